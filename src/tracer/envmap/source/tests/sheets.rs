//! Crosses, strips and OpenEXR cubes.

use std::fs;
use std::path::Path;

use exr::meta::attribute::EnvironmentMap;
use image::{Rgb, RgbImage};
use tempfile::TempDir;

use super::*;
use crate::math::Vec3;

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
fn sheets_are_cut_row_by_row() {
    let cells = [0, 1, 2, 3, 4, 5].map(Some);
    check_sheet(&sheet(3, 2, &cells, None), Layout::WideSheet);
    check_sheet(&sheet(2, 3, &cells, None), Layout::TallSheet);
}

#[test]
fn the_arms_of_a_cross_stand_where_its_cells_are_not_empty() {
    let [px, nx, py, ny, pz, nz] = [0, 1, 2, 3, 4, 5].map(Some);
    for front in 0..4 {
        let mut horizontal = [None; 12];
        let mut vertical = [None; 12];
        for (quarter, face) in [pz, px, nz, nx].into_iter().enumerate() {
            horizontal[4 + (front + quarter) % 4] = face;
        }
        for (quarter, face) in [pz, ny, nz, py].into_iter().enumerate() {
            vertical[3 * ((front + quarter) % 4) + 1] = face;
        }
        (horizontal[front], horizontal[8 + front]) = (py, ny);
        (vertical[3 * front], vertical[3 * front + 2]) = (nx, px);
        check_sheet(&sheet(4, 3, &horizontal, None), Layout::HorizontalCross);
        check_sheet(&sheet(3, 4, &vertical, nz), Layout::VerticalCross);
    }
}

#[test]
fn a_picture_of_the_shape_of_a_cross_or_sheet_is_refused() {
    let folder = TempDir::new().unwrap();
    // A texture without any border in it, and a smooth one.
    let grain = |x: u32, y: u32| ((x * 7919 + y * 104_729).wrapping_mul(2_654_435_761) >> 24) as u8;
    let smooth = |x: u32, y: u32| (3 * x + y) as u8;
    for (width, height, code, why) in [
        (64, 48, &grain as &dyn Fn(u32, u32) -> u8, "its corner cells are not empty"),
        (48, 64, &grain, "its corner cells are not empty"),
        (48, 32, &grain, "its cells continue each other"),
        (48, 32, &smooth, "its cells continue each other"),
        (32, 48, &smooth, "its cells continue each other"),
    ] {
        let picture = RgbImage::from_fn(width, height, |x, y| Rgb([code(x, y); 3]));
        fs::write(folder.path().join("photo.png"), png(&picture)).unwrap();
        let error = error_at(&folder, "photo.png");
        assert!(error.contains(why), "{error}");
    }
    fs::write(folder.path().join("sky_eac.png"), plain(12, 8, 0)).unwrap();
    assert!(error_at(&folder, "sky_eac.png").contains("equi-angular"));
}

#[test]
fn other_pictures_are_refused() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("panorama.png"), plain(8, 4, 0)).unwrap();
    insta::assert_snapshot!(error_at(&folder, "panorama.png"), @r"
        [folder]/panorama.png: 8 x 4 pixels: an equirectangular picture, not six faces
          expected: six faces: a folder, a zip, a cross or strip, or an OpenEXR file with `envmap = cube`
          help: a scene can use it as an equirectangular environment
        ");
    fs::write(folder.path().join("cross.png"), plain(41, 30, 0)).unwrap();
    insta::assert_snapshot!(error_at(&folder, "cross.png"), @r"
        [folder]/cross.png: 41 x 30 pixels: these proportions match no layout of six faces
          expected: a cross, strip or sheet whose cells are exactly square (horizontal cross 4:3, vertical cross 3:4, horizontal strip 6:1, vertical strip 1:6, sheet 3:2, sheet 2:3)
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
          help: a scene can use it as an equirectangular environment
        ");
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
