//! Six files in a folder, or named one by one.

use std::fs;

use image::{Rgb, RgbImage};
use tempfile::TempDir;

use super::*;

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
    fs::rename(folder.path().join("negy.png"), folder.path().join("ground.png")).unwrap();
    insta::assert_snapshot!(error_at(&folder, ""), @r"
        [folder]: negy without a file
          posx: posx.png
          negx: negx.png
          posy: posy.png
          negy: nothing
          posz: posz.png
          negz: negz.png
          ignored: ground.png
          expected: one picture for each of the six faces
          help: rename files, or move the superfluous ones away; a scene may also name the six files itself
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
          help: rename files, or move the superfluous ones away; a scene may also name the six files itself
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
        [folder]/nowhere: the file or folder does not exist
        ");
    insta::assert_snapshot!(error_at(&folder, "posx.png/night"), @r"
        [folder]/posx.png/night: the file or folder does not exist
        ");
}

#[test]
fn an_empty_folder_is_refused() {
    let error = error_at(&TempDir::new().unwrap(), "");
    assert!(error.starts_with("[folder]: no files in it\n"), "{error}");
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
