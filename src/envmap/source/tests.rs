//! Opening skyboxes from files made here, with one fault each. Real maps are opened in `real_maps`.

use std::fs;
use std::io::{Cursor, Write};
use std::path::Path;

use exr::meta::attribute::EnvironmentMap;
use image::{ImageFormat, Rgb, RgbImage};
use tempfile::TempDir;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::*;
use crate::math::Vec3;
use crate::picture::Texels;

/// The colour that face number `index` is painted in.
fn paint(index: usize) -> [u8; 3] {
    [40 * index as u8, 255 - 40 * index as u8, 7]
}

fn png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// A PNG file of one colour.
fn plain(width: u32, height: u32, index: usize) -> Vec<u8> {
    png(&RgbImage::from_pixel(width, height, Rgb(paint(index))))
}

const NAMES: [&str; 6] = ["posx.png", "negx.png", "posy.png", "negy.png", "posz.png", "negz.png"];

/// A folder with six faces of 4 x 4 pixels, each of its own colour.
fn six_files() -> TempDir {
    let folder = TempDir::new().unwrap();
    for (index, name) in NAMES.into_iter().enumerate() {
        fs::write(folder.path().join(name), plain(4, 4, index)).unwrap();
    }
    folder
}

fn zip_bytes(entries: &[(String, Vec<u8>)]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        writer.start_file(name.as_str(), SimpleFileOptions::default()).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// A folder with the archive `sky.zip`.
fn zip_file(bytes: &[u8]) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("sky.zip"), bytes).unwrap();
    folder
}

/// The entries of a set of six in a folder of an archive.
fn six_entries(folder: &str) -> Vec<(String, Vec<u8>)> {
    NAMES.iter().enumerate().map(|(index, name)| (format!("{folder}{name}"), plain(4, 4, index))).collect()
}

fn zip_of(entries: &[(String, Vec<u8>)]) -> TempDir {
    zip_file(&zip_bytes(entries))
}

/// The first texel of each image, to see which picture became which face.
fn first_texels(skybox: &Skybox) -> [[u8; 3]; 6] {
    [0, 1, 2, 3, 4, 5].map(|index| match skybox.images[index].decode().unwrap().texels() {
        Texels::Srgb8(bytes) => [bytes[0], bytes[1], bytes[2]],
        Texels::Linear(colours) => panic!("a PNG became {:?}", colours[0]),
    })
}

fn names(skybox: &Skybox) -> String {
    skybox.images.iter().map(FaceImage::name).collect::<Vec<_>>().join(" ")
}

/// The error of opening `path` in a temporary folder, which it calls `[folder]`.
fn error_at(folder: &TempDir, path: &str) -> String {
    let path = if path.is_empty() { folder.path().to_path_buf() } else { folder.path().join(path) };
    let error = Skybox::open(&path).unwrap_err().to_string();
    error.replace(&folder.path().display().to_string(), "[folder]")
}

#[test]
fn a_folder_opens_by_its_names() {
    let folder = six_files();
    fs::write(folder.path().join("readme.txt"), "by nobody").unwrap();
    let skybox = Skybox::open(folder.path()).unwrap();
    assert_eq!(names(&skybox), NAMES.join(" "));
    assert_eq!(first_texels(&skybox), [0, 1, 2, 3, 4, 5].map(paint));
    assert_eq!(skybox.passed_over, ["readme.txt"]);
    assert_eq!(skybox.layout, Layout::SixFiles);
    let header = skybox.image(Face::NegZ).header();
    assert_eq!((header.width, header.height), (4, 4));
    assert_eq!(skybox.images[3].encoded_bytes().unwrap(), Some(plain(4, 4, 3)));
}

#[test]
fn a_subfolder_that_holds_the_six_is_found() {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("Sky")).unwrap();
    for (index, name) in NAMES.into_iter().enumerate() {
        fs::write(folder.path().join("Sky").join(name), plain(4, 4, index)).unwrap();
    }
    assert_eq!(Skybox::open(folder.path()).unwrap().images[0].name(), "Sky/posx.png");
}

#[test]
fn an_archive_opens_in_place() {
    let mut entries = six_entries("Sky/");
    entries.push(("__MACOSX/Sky/._posx.png".to_owned(), vec![0; 8]));
    entries.push(("Sky/readme.txt".to_owned(), b"by nobody".to_vec()));
    let folder = zip_of(&entries);
    let skybox = Skybox::open(&folder.path().join("sky.zip")).unwrap();
    assert_eq!(skybox.images[5].name(), "sky.zip/Sky/negz.png");
    assert_eq!(first_texels(&skybox), [0, 1, 2, 3, 4, 5].map(paint));
    assert_eq!(skybox.images[2].encoded_bytes().unwrap(), Some(plain(4, 4, 2)));
    assert_eq!(skybox.passed_over, ["Sky/readme.txt", "__MACOSX/Sky/._posx.png"]);
}

#[test]
fn a_subfolder_of_an_archive_is_named_after_a_slash() {
    let folder = zip_of(&[six_entries("Day/"), six_entries("Night/")].concat());
    insta::assert_snapshot!(error_at(&folder, "sky.zip"), @r"
        [folder]/sky.zip: 2 subfolders hold six faces each
          Day
          Night
          expected: one set of six faces
          help: name the subfolder that is meant after a slash, as in .../Day
        ");
    let skybox = Skybox::open(&folder.path().join("sky.zip/Night")).unwrap();
    assert_eq!(skybox.images[0].name(), "sky.zip/Night/posx.png");
    insta::assert_snapshot!(error_at(&folder, "sky.zip/Noon"), @r"
        [folder]/sky.zip: the archive has no folder Noon
        ");
}

#[test]
fn named_files_need_no_names_of_faces() {
    let folder = six_files();
    let mut files: Vec<(Face, PathBuf)> =
        Face::ALL.into_iter().zip(NAMES.map(|name| folder.path().join(name))).collect();
    files.reverse();
    let skybox = Skybox::from_files(&files).unwrap();
    assert_eq!(first_texels(&skybox), [0, 1, 2, 3, 4, 5].map(paint));
    insta::assert_snapshot!(Skybox::from_files(&files[1..]).unwrap_err(), @r"
        no file is named for negz
          expected: one file for each of posx, negx, posy, negy, posz, negz
        ");
    files.push(files[0].clone());
    insta::assert_snapshot!(Skybox::from_files(&files).unwrap_err(), @r"
        several files are named for negz
          expected: one file for each of posx, negx, posy, negy, posz, negz
        ");
}

#[test]
fn a_missing_face_is_named() {
    let folder = six_files();
    fs::rename(folder.path().join("negy.png"), folder.path().join("below.png")).unwrap();
    insta::assert_snapshot!(error_at(&folder, ""), @r"
        [folder]: negy without a file
          posx: posx.png
          negx: negx.png
          posy: posy.png
          negy: nothing
          posz: posz.png
          negz: negz.png
          passed over: below.png
          expected: one picture for each of the six faces
          help: rename files, or move those that do not belong out of the way; a scene may also name the six files itself
        ");
}

#[test]
fn a_double_face_is_named() {
    let folder = six_files();
    fs::copy(folder.path().join("posx.png"), folder.path().join("posx.jpg")).unwrap();
    insta::assert_snapshot!(error_at(&folder, ""), @r"
        [folder]: posx with several files
          posx: posx.jpg, posx.png
          negx: negx.png
          posy: posy.png
          negy: negy.png
          posz: posz.png
          negz: negz.png
          expected: one picture for each of the six faces
          help: rename files, or move those that do not belong out of the way; a scene may also name the six files itself
        ");
}

#[test]
fn sizes_that_differ_are_named_and_taken_leniently() {
    let folder = six_files();
    fs::write(folder.path().join("posy.png"), plain(8, 8, 2)).unwrap();
    fs::write(folder.path().join("negz.png"), plain(4, 3, 5)).unwrap();
    insta::assert_snapshot!(error_at(&folder, ""), @r"
        [folder]: 2 faces have the wrong size
          posy: posy.png is 8 x 8: most faces are 4 x 4
          negz: negz.png is 4 x 3: not square
          expected: six square pictures of one size
          help: scale or crop these pictures, or take them from the original download again
        ");
    let faults = Skybox::open_lenient(folder.path()).unwrap().size_faults();
    let kinds: Vec<_> = faults.iter().map(|fault| (fault.face, fault.kind)).collect();
    let expected = [(Face::PosY, SizeFaultKind::Differs { from: 4 }), (Face::NegZ, SizeFaultKind::NotSquare)];
    assert_eq!(kinds, expected);
}

#[test]
fn faces_that_are_no_pictures_are_all_named() {
    let folder = six_files();
    fs::write(folder.path().join("posx.png"), "<html>not found</html>").unwrap();
    fs::write(folder.path().join("posz.png"), "").unwrap();
    let error = error_at(&folder, "");
    assert!(error.starts_with("[folder]: 2 of the six faces cannot be read\n  posx: "), "{error}");
    assert!(error.contains("posx.png") && error.contains("posz.png"), "{error}");
}

#[test]
fn what_is_not_there_is_said_plainly() {
    let folder = six_files();
    insta::assert_snapshot!(error_at(&folder, "nowhere"), @r"
        [folder]/nowhere: no such file or folder
        ");
    insta::assert_snapshot!(error_at(&folder, "posx.png/night"), @r"
        [folder]/posx.png/night: no such file or folder
        ");
}

#[test]
fn an_empty_folder_is_refused() {
    let error = error_at(&TempDir::new().unwrap(), "");
    assert!(error.starts_with("[folder]: no files in it\n"), "{error}");
}

#[test]
fn damaged_archives_are_refused() {
    insta::assert_snapshot!(error_at(&zip_file(b"PK but no archive"), "sky.zip"), @r"
        [folder]/sky.zip: invalid Zip archive: Could not find EOCD
          help: the archive is damaged or incomplete; download it again
        ");
    let whole = zip_bytes(&six_entries(""));
    for length in (0..whole.len()).step_by(37) {
        let error = error_at(&zip_file(&whole[..length]), "sky.zip");
        assert!(error.starts_with("[folder]/sky.zip"), "{length}: {error}");
    }
}

#[test]
fn a_byte_changed_in_an_archive_never_yields_another_picture() {
    let whole = zip_bytes(&six_entries(""));
    for place in 0..whole.len() {
        let mut damaged = whole.clone();
        damaged[place] ^= 0xff;
        let folder = zip_file(&damaged);
        let Ok(skybox) = Skybox::open_lenient(&folder.path().join("sky.zip")) else { continue };
        for (index, image) in skybox.images.iter().enumerate() {
            let Ok(bytes) = image.encoded_bytes() else { continue };
            assert_eq!(bytes, Some(plain(4, 4, index)), "byte {place}");
        }
    }
}

#[test]
fn an_entry_with_a_wrong_checksum_is_refused() {
    let mut entries = six_entries("");
    entries.truncate(5);
    let marked = [b"MARK".as_slice(), &[0; 64]].concat();
    let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries.iter().map(|(name, bytes)| (name.as_str(), bytes)).chain([("negz.png", &marked)]) {
        writer.start_file(name, options).unwrap();
        writer.write_all(bytes).unwrap();
    }
    let mut bytes = writer.finish().unwrap().into_inner();
    let place = bytes.windows(4).position(|window| window == b"MARK").unwrap();
    bytes[place] = b'B';
    insta::assert_snapshot!(error_at(&zip_file(&bytes), "sky.zip"), @r"
        [folder]/sky.zip/negz.png: cannot be unpacked: Invalid checksum
          help: the archive is damaged or incomplete; download it again
        ");
}

#[test]
fn an_encrypted_archive_says_so() {
    let mut bytes = zip_bytes(&six_entries(""));
    // The lowest bit of the general flags, in the local headers and the central directory.
    for (signature, flags) in [(b"PK\x03\x04", 6), (b"PK\x01\x02", 8)] {
        let places: Vec<usize> = (0..bytes.len() - 4).filter(|&at| bytes[at..].starts_with(signature)).collect();
        places.into_iter().for_each(|at| bytes[at + flags] |= 1);
    }
    let error = error_at(&zip_file(&bytes), "sky.zip");
    assert_eq!(error.matches("is encrypted").count(), 6, "{error}");
}

#[test]
fn an_entry_that_would_fill_the_memory_is_refused() {
    let mut bytes = zip_bytes(&six_entries(""));
    // The unpacked size in every central directory entry.
    let places: Vec<usize> = (0..bytes.len() - 4).filter(|&at| bytes[at..].starts_with(b"PK\x01\x02")).collect();
    places.into_iter().for_each(|at| bytes[at + 24..at + 28].copy_from_slice(&0x7fff_ffff_u32.to_le_bytes()));
    let error = error_at(&zip_file(&bytes), "sky.zip");
    assert_eq!(error.matches("would be 2147483647 bytes unpacked").count(), 6, "{error}");
}

/// A sheet whose cells, given row by row as face numbers, are painted in the colours of the faces; the texel that is the
/// upper left of the upright face is white.
fn sheet(columns: u32, rows: u32, cells: &[Option<usize>], turned: Option<usize>) -> Vec<u8> {
    const SIZE: u32 = 4;
    let mut picture = RgbImage::new(columns * SIZE, rows * SIZE);
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        let cell = cells[(y / SIZE * columns + x / SIZE) as usize];
        let Some(index) = cell else { continue };
        let corner = if cell == turned { SIZE - 1 } else { 0 };
        let marked = x % SIZE == corner && y % SIZE == corner;
        *pixel = Rgb(if marked { [255; 3] } else { paint(index) });
    }
    png(&picture)
}

/// Opens a sheet and checks that every face is its own colour and upright.
fn check_sheet(bytes: &[u8], layout: Layout) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("sky.png");
    fs::write(&path, bytes).unwrap();
    let skybox = Skybox::open(&path).unwrap();
    assert_eq!(skybox.layout, layout);
    for (index, image) in skybox.images.iter().enumerate() {
        let picture = image.decode().unwrap();
        assert_eq!((picture.width(), picture.height()), (4, 4));
        assert_eq!((image.header().width, image.header().height), (4, 4));
        assert_eq!(picture.texel(0, 0), Vec3::ONE, "{}", image.name());
        let colour = crate::colour::decode_srgb8(paint(index));
        let others = (1..16).all(|texel| picture.texel(texel % 4, texel / 4) == colour);
        assert!(others, "{}", image.name());
        assert_eq!(image.encoded_bytes().unwrap(), None);
    }
    assert_eq!(skybox.images[1].name(), "sky.png [-x cell]");
}

#[test]
fn crosses_and_strips_are_cut() {
    let [px, nx, py, ny, pz, nz] = [0, 1, 2, 3, 4, 5].map(Some);
    #[rustfmt::skip]
    let horizontal = [
        None, py, None, None,
        nx,   pz, px,   nz,
        None, ny, None, None,
    ];
    check_sheet(&sheet(4, 3, &horizontal, None), Layout::HorizontalCross);
    #[rustfmt::skip]
    let vertical = [
        None, py, None,
        nx,   pz, px,
        None, ny, None,
        None, nz, None,
    ];
    check_sheet(&sheet(3, 4, &vertical, nz), Layout::VerticalCross);
    let strip = [px, nx, py, ny, pz, nz];
    check_sheet(&sheet(6, 1, &strip, None), Layout::HorizontalStrip);
    check_sheet(&sheet(1, 6, &strip, None), Layout::VerticalStrip);
}

#[test]
fn other_pictures_are_refused() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("panorama.png"), plain(8, 4, 0)).unwrap();
    insta::assert_snapshot!(error_at(&folder, "panorama.png"), @r"
        [folder]/panorama.png: 8 x 4 pixels: an equirectangular picture, not six faces
          expected: six faces: a folder, a zip, a cross or strip, or an OpenEXR file with `envmap = cube`
          help: a scene takes such a picture as its equirectangular environment
        ");
    fs::write(folder.path().join("cross.png"), plain(41, 30, 0)).unwrap();
    insta::assert_snapshot!(error_at(&folder, "cross.png"), @r"
        [folder]/cross.png: 41 x 30 pixels: the shape tells no layout of six faces
          expected: a cross or strip whose cells are exactly square (horizontal cross 4:3, vertical cross 3:4, horizontal strip 6:1, vertical strip 1:6)
          help: if this is a horizontal cross 4:3, 40 x 30 or 44 x 33 pixels would be right
        ");
    fs::write(folder.path().join("notes.txt"), "no picture").unwrap();
    assert!(error_at(&folder, "notes.txt").starts_with("[folder]/notes.txt: "));
}

/// An OpenEXR file of linear colours that grow from row to row, with an `envmap` attribute.
fn write_exr(path: &Path, width: usize, height: usize, attribute: EnvironmentMap) {
    use exr::prelude::*;
    let channels = SpecificChannels::rgb(|place: Vec2<usize>| (place.y() as f32, 2.0, 0.5));
    let mut image = Image::from_channels((width, height), channels);
    image.layer_data.attributes.environment_map = Some(attribute);
    image.write().to_file(path).unwrap();
}

#[test]
fn an_openexr_cube_opens_by_its_attribute() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("cube.exr");
    write_exr(&path, 4, 24, EnvironmentMap::Cube);
    let skybox = Skybox::open(&path).unwrap();
    assert_eq!(skybox.layout, Layout::OpenExrCube);
    for (index, image) in skybox.images.iter().enumerate() {
        let picture = image.decode().unwrap();
        assert_eq!((picture.width(), picture.height()), (4, 4));
        let rows = [0, 1, 2, 3].map(|row| picture.texel(0, row).x as usize);
        assert_eq!(rows, [0, 1, 2, 3].map(|row| 4 * index + row), "{}", image.name());
    }
}

#[test]
fn openexr_files_that_are_no_cube_are_refused() {
    let folder = TempDir::new().unwrap();
    write_exr(&folder.path().join("short.exr"), 4, 12, EnvironmentMap::Cube);
    insta::assert_snapshot!(error_at(&folder, "short.exr"), @r"
        [folder]/short.exr: 4 x 12 pixels, though its attribute says `envmap = cube`
          expected: six square faces from top to bottom: a height of six times the width
        ");
    write_exr(&folder.path().join("globe.exr"), 4, 24, EnvironmentMap::LatitudeLongitude);
    insta::assert_snapshot!(error_at(&folder, "globe.exr"), @r"
        [folder]/globe.exr: 4 x 24 pixels: an equirectangular picture, not six faces
          expected: six faces: a folder, a zip, a cross or strip, or an OpenEXR file with `envmap = cube`
          help: a scene takes such a picture as its equirectangular environment
        ");
}

#[test]
fn archives_written_with_backslashes_open() {
    let mut entries = six_entries("Sky\\");
    entries.push(("Sky\\readme.txt".to_owned(), Vec::new()));
    let folder = zip_of(&entries);
    let skybox = Skybox::open(&folder.path().join("sky.zip")).unwrap();
    assert_eq!(skybox.images[0].name(), "sky.zip/Sky/posx.png");
    assert_eq!(first_texels(&skybox), [0, 1, 2, 3, 4, 5].map(paint));
}

/// Pictures whose headers lie behind more than is read first: here a TIFF, whose directory follows its pixels.
#[test]
fn headers_at_the_end_of_large_files_are_found() {
    let folder = six_files();
    fs::remove_file(folder.path().join("negy.png")).unwrap();
    let picture = RgbImage::from_fn(320, 320, |x, y| Rgb([x as u8, y as u8, (x * y) as u8]));
    picture.save(folder.path().join("negy.tiff")).unwrap();
    let header = Skybox::open_lenient(folder.path()).unwrap().image(Face::NegY).header();
    assert_eq!((header.width, header.height), (320, 320));
}

#[test]
fn skyboxes_may_be_shared_between_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<Skybox>();
}

#[test]
fn faces_are_decoded_by_many_threads_at_once() {
    let strip = [0, 1, 2, 3, 4, 5].map(Some);
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("sky.png");
    fs::write(&path, sheet(6, 1, &strip, None)).unwrap();
    let skybox = Skybox::open(&path).unwrap();
    std::thread::scope(|scope| {
        let images = skybox.images.iter().cycle().take(24).enumerate();
        let threads: Vec<_> = images.map(|(index, image)| (index % 6, scope.spawn(|| image.decode()))).collect();
        for (index, thread) in threads {
            let picture = thread.join().unwrap().unwrap();
            assert_eq!(picture.texel(1, 1), crate::colour::decode_srgb8(paint(index)));
        }
    });
}
