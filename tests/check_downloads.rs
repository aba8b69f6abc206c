//! `check` on downloads that went wrong: a web page or a git-lfs pointer under the name of a picture.

use std::path::Path;
use std::process::{Command, Output};

use skycube::math::Vec3;
use skycube::picture::{Raster, WriteOptions};
use tempfile::TempDir;

const PAGE: &[u8] = b"<!DOCTYPE html>\n<html><head><title>Sign in</title></head><body>posx.jpg</body></html>\n";
const POINTER: &[u8] =
    b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 123456\n";

/// A folder with the compass as a map of this name.
fn copy_compass(folder: &Path, name: &str) {
    let map = folder.join(name);
    std::fs::create_dir(&map).unwrap();
    let compass = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass");
    for face in ["posx", "negx", "posy", "negy", "posz", "negz"] {
        let file = format!("{face}.png");
        std::fs::copy(compass.join(&file), map.join(&file)).unwrap();
    }
}

/// The same with one face that is something else under the name of a JPEG.
fn copy_with(folder: &Path, name: &str, face: &str, bytes: &[u8]) {
    copy_compass(folder, name);
    std::fs::remove_file(folder.join(name).join(format!("{face}.png"))).unwrap();
    std::fs::write(folder.join(name).join(format!("{face}.jpg")), bytes).unwrap();
}

fn skycube(folder: &TempDir, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_skycube")).args(arguments).current_dir(folder.path()).output().unwrap()
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

#[test]
fn one_map_is_refused_with_the_file_and_what_it_is() {
    for (bytes, what) in [(PAGE, "this is a web page (HTML), not a picture"), (POINTER, "this is a git-lfs pointer")] {
        let folder = TempDir::new().unwrap();
        copy_with(folder.path(), "sky", "negz", bytes);
        let output = skycube(&folder, &["check", "sky"]);
        assert_eq!(output.status.code(), Some(2), "{what}");
        assert!(output.stdout.is_empty(), "{}", text(&output.stdout));
        let error = text(&output.stderr);
        assert!(error.starts_with("error: ") && error.contains("negz.jpg") && error.contains(what), "{error}");
        let fixed = skycube(&folder, &["fix", "sky", "-o", "fixed"]);
        assert_eq!((fixed.status.code(), folder.path().join("fixed").exists()), (Some(2), false));
    }
}

#[test]
fn the_rest_of_a_folder_of_maps_is_still_checked() {
    let folder = TempDir::new().unwrap();
    let maps = folder.path().join("maps");
    std::fs::create_dir(&maps).unwrap();
    copy_with(&maps, "a-page", "posx", PAGE);
    copy_compass(&maps, "compass");
    copy_with(&maps, "pointer", "negy", POINTER);
    std::fs::write(maps.join("archive.zip"), PAGE).unwrap();
    std::fs::write(maps.join("readme.txt"), "not a map").unwrap();
    let output = skycube(&folder, &["check", "maps"]);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    let report = text(&output.stdout).replace('\\', "/");
    let lines: Vec<&str> = report.lines().collect();
    assert_eq!(lines[0], "maps/a-page: cannot be checked: this is a web page (HTML), not a picture");
    assert!(lines[1].starts_with("maps/archive.zip: cannot be checked: "), "{}", lines[1]);
    assert_eq!(lines[2], "maps/compass: fits");
    assert_eq!(lines[3], "maps/pointer: cannot be checked: this is a git-lfs pointer, not the picture itself");
    assert_eq!(lines[4..], ["4 maps: 1 fit, 0 broken, 0 undecidable, 3 could not be checked"]);
    let errors = text(&output.stderr);
    for part in ["posx.jpg", "a web page (HTML)", "negy.jpg", "a git-lfs pointer", "archive.zip"] {
        assert!(errors.contains(part), "{part}: {errors}");
    }
}

#[test]
fn a_subfolder_does_not_hide_that_a_map_cannot_be_read() {
    let folder = TempDir::new().unwrap();
    copy_with(folder.path(), "sky", "posx", POINTER);
    copy_compass(&folder.path().join("sky"), "other");
    let output = skycube(&folder, &["check", "sky"]);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stdout));
    assert!(text(&output.stderr).contains("a git-lfs pointer"), "{}", text(&output.stderr));
    let output = skycube(&folder, &["check", "."]);
    assert!(text(&output.stdout).starts_with("./sky: cannot be checked: "), "{}", text(&output.stdout));
    assert!(text(&output.stdout).ends_with("\n1 map: 0 fit, 0 broken, 0 undecidable, 1 could not be checked\n"));
    assert!(text(&output.stderr).ends_with("error: 1 of 1 map could not be checked\n"), "{}", text(&output.stderr));
}

#[test]
fn every_argument_may_be_a_folder_of_maps() {
    let folder = TempDir::new().unwrap();
    for outer in ["day", "night"] {
        std::fs::create_dir(folder.path().join(outer)).unwrap();
        copy_compass(&folder.path().join(outer), "one");
        copy_compass(&folder.path().join(outer), "two");
    }
    // A link in a circle ends; a link to a map is a map.
    #[cfg(unix)]
    for (target, link) in [(".", "day/circle"), ("..", "day/up")] {
        std::os::unix::fs::symlink(target, folder.path().join(link)).unwrap();
    }
    let output = skycube(&folder, &["check", "day", "night"]);
    let report = text(&output.stdout).replace('\\', "/");
    let expected = ["day/one: fits", "day/two: fits", "night/one: fits", "night/two: fits"];
    assert_eq!(report.lines().take(4).collect::<Vec<_>>(), expected);
    assert!(report.ends_with("\n4 maps: 4 fit, 0 broken, 0 undecidable, 0 could not be checked\n"), "{report}");
}

#[test]
fn a_line_names_faces_that_do_not_belong_beside_what_changes() {
    let folder = TempDir::new().unwrap();
    copy_compass(folder.path(), "right");
    let courtyard = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/courtyard");
    std::fs::create_dir(folder.path().join("strange")).unwrap();
    for entry in std::fs::read_dir(courtyard).unwrap().flatten() {
        std::fs::copy(entry.path(), folder.path().join("strange").join(entry.file_name())).unwrap();
    }
    let write = |name: &str, raster: &Raster| {
        let file = folder.path().join("strange").join(name).with_extension("png");
        skycube::picture::write(raster, &file, &WriteOptions::default()).unwrap();
        let _ = std::fs::remove_file(file.with_extension("jpg"));
    };
    let negz = skycube::picture::read(&folder.path().join("strange/negz.jpg")).unwrap().to_raster();
    let size = negz.width();
    write("negz", &Raster::from_function(size, size, |x, y| negz.pixel(size - 1 - x, y)));
    let stripes = |x: usize, y: usize| Vec3::new((x / 8 % 2) as f32, (y / 16 % 2) as f32, ((x + y) / 4 % 2) as f32);
    write("posx", &Raster::from_function(size, size, stripes));
    let output = skycube(&folder, &["check", "right", "strange"]);
    let report = text(&output.stdout);
    let line = report.lines().nth(1).unwrap();
    let expected =
        "strange: broken: negz.png: flip left-right; posx.png: replace this picture: it does not belong here";
    assert_eq!(line, expected, "{report}");
}

/// The names of the compass's files in another form.
fn rename(folder: &Path, name: impl Fn(usize, &str) -> String) {
    for (index, face) in ["posx", "negx", "posy", "negy", "posz", "negz"].iter().enumerate() {
        let renamed = folder.join(name(index, face)).with_extension("png");
        std::fs::rename(folder.join(face).with_extension("png"), renamed).unwrap();
    }
}

#[test]
fn six_square_pictures_are_one_map() {
    let folder = TempDir::new().unwrap();
    copy_compass(folder.path(), "sky");
    rename(&folder.path().join("sky"), |index, _| ["a", "b", "c", "d", "e", "f"][index].to_owned());
    let files = ["a", "b", "c", "d", "e", "f"].map(|name| format!("sky/{name}.png"));
    let arguments: Vec<&str> = std::iter::once("check").chain(files.iter().map(String::as_str)).collect();
    let output = skycube(&folder, &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains(": fits under the lookup opengl"), "{}", text(&output.stdout));
    // As a folder the names say nothing: the pixels put the pictures in order, and that is said.
    let output = skycube(&folder, &["check", "sky"]);
    let report = text(&output.stdout);
    assert!(report.contains("fits") && report.contains("the names of the files do not identify the faces"), "{report}");
    let drawn = skycube(&folder, &["cross", "sky", "-o", "cross.png", "--cell", "64"]);
    assert_eq!(drawn.status.code(), Some(0), "{}", text(&drawn.stderr));
}

#[test]
fn numbered_pictures_are_put_in_order() {
    let folder = TempDir::new().unwrap();
    copy_compass(folder.path(), "sky");
    // Front, right, back, left, up, down, as Pannellum counts.
    rename(&folder.path().join("sky"), |index, _| format!("pano{}", [1, 3, 4, 5, 0, 2][index]));
    let output = skycube(&folder, &["check", "sky"]);
    let report = text(&output.stdout);
    assert!(report.contains("the order of Pannellum and Minecraft"), "{report}");
    assert!(!report.contains("turn ") && !report.contains("flip "), "{report}");
    assert_eq!(skycube(&folder, &["fix", "sky", "-o", "fixed"]).status.code(), Some(0));
    assert_eq!(skycube(&folder, &["check", "fixed"]).status.code(), Some(0));
}

#[test]
fn several_sets_in_a_folder_are_checked_one_by_one() {
    let folder = TempDir::new().unwrap();
    for time in ["day", "night"] {
        copy_compass(folder.path(), time);
        for face in ["posx", "negx", "posy", "negy", "posz", "negz"] {
            let from = folder.path().join(time).join(face).with_extension("png");
            let into = folder.path().join(format!("{time}_{face}.png"));
            std::fs::rename(from, into).unwrap();
        }
        std::fs::remove_dir(folder.path().join(time)).unwrap();
    }
    let output = skycube(&folder, &["check", "."]);
    let report = text(&output.stdout).replace('\\', "/");
    assert_eq!(
        report.lines().collect::<Vec<_>>(),
        ["./day: fits", "./night: fits", "2 maps: 2 fit, 0 broken, 0 undecidable, 0 could not be checked"]
    );
    let one = skycube(&folder, &["check", "night_"]);
    assert!(text(&one.stdout).starts_with("night_: fits under"), "{}", text(&one.stdout));
}

#[test]
fn sizes_that_no_cube_map_has_are_broken() {
    let folder = TempDir::new().unwrap();
    copy_compass(folder.path(), "sky");
    let small = Raster::from_function(64, 64, |_, _| Vec3::splat(0.5));
    skycube::picture::write(&small, &folder.path().join("sky/posy.png"), &WriteOptions::default()).unwrap();
    for arguments in [&["check", "sky"][..], &["check", "sky", "sky"]] {
        let output = skycube(&folder, arguments);
        assert_eq!(output.status.code(), Some(1));
        assert!(
            text(&output.stdout).contains("posy.png: scale to 512 x 512 texels, the size of the others"),
            "{}",
            text(&output.stdout)
        );
    }
    let narrow = Raster::from_function(64, 48, |_, _| Vec3::splat(0.5));
    skycube::picture::write(&narrow, &folder.path().join("sky/posy.png"), &WriteOptions::default()).unwrap();
    let output = skycube(&folder, &["check", "sky", "sky"]);
    assert!(
        text(&output.stdout).contains("posy.png (64 x 48 texels): crop or scale to a square"),
        "{}",
        text(&output.stdout)
    );
}
