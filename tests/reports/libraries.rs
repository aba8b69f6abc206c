//! `fix`, `cross` and `shots` on a folder of maps.

use skycube::envmap::Face;
use skycube::picture::read;

use crate::common::outcome;
use crate::compass;

/// A right map and a turned one under `skies`.
fn library() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    compass(&folder.path().join("skies/right"), None);
    compass(&folder.path().join("skies/turned"), Some(Face::PosY));
    folder
}

#[test]
fn fix_repairs_each_map_into_a_folder_of_its_name() {
    let folder = library();
    let (code, text, error) = outcome(folder.path(), &["fix", "skies", "-o", "repaired"]);
    assert_eq!(code, Some(0), "{text}{error}");
    assert_eq!(outcome(folder.path(), &["check", "repaired", "-q"]).0, Some(0));
    assert!(folder.path().join("repaired/turned/posy.png").is_file());
    // Among the maps the next run would take the repaired ones for more of them.
    let (code, _, error) = outcome(folder.path(), &["fix", "skies", "-o", "skies/repaired"]);
    assert!(code == Some(2) && error.contains("inside the folder of maps"), "{error}");
    // One that fails does not stop the others.
    std::fs::write(folder.path().join("skies/right/posx.png"), "no picture").unwrap();
    let (code, _, error) = outcome(folder.path(), &["fix", "skies", "-o", "again"]);
    assert!(code == Some(2) && error.contains("1 of 2 maps failed"), "{error}");
    assert!(folder.path().join("again/turned/posy.png").is_file());
}

#[test]
fn a_folder_with_one_good_map_and_others_is_no_map() {
    let folder = library();
    std::fs::remove_file(folder.path().join("skies/turned/posx.png")).unwrap();
    let (code, text, _) = outcome(folder.path(), &["check", "skies"]);
    assert!(code == Some(2) && text.contains("1 fit") && text.contains("1 could not be checked"), "{text}");
}

#[test]
fn two_maps_never_get_one_place_and_folders_apart_are_compared() {
    let folder = library();
    let zip = skycube::picture::archive_of([("posx.png", &b"no picture"[..])]).unwrap();
    std::fs::write(folder.path().join("skies/right.zip"), zip).unwrap();
    let (code, _, error) = outcome(folder.path(), &["cross", "skies", "-o", "crosses"]);
    assert!(code == Some(2) && error.contains("would be written to one place"), "{error}");
    let (code, _, error) = outcome(folder.path(), &["compare", "skies", "skies/right"]);
    assert!(code == Some(2) && error.contains("lies inside the other"), "{error}");
    let (code, _, error) = outcome(folder.path(), &["cross", "skies", "-o", "-"]);
    assert!(code == Some(2) && error.contains("standard output takes one picture"), "{error}");
}

#[test]
fn cross_draws_each_map_or_all_on_a_sheet() {
    let folder = library();
    let (code, _, error) = outcome(folder.path(), &["cross", "skies", "-o", "crosses", "--cell", "64"]);
    assert_eq!((code, error.as_str()), (Some(0), ""));
    let one = read(&folder.path().join("crosses/turned.png")).unwrap();
    let (code, text, _) = outcome(folder.path(), &["cross", "skies", "--sheet", "-o", "sheet.png"]);
    assert_eq!((code, text.as_str()), (Some(0), "wrote sheet.png: 2 maps\n"));
    let sheet = read(&folder.path().join("sheet.png")).unwrap();
    assert!(sheet.width() > 2 * one.width() && sheet.height() > one.height(), "{} {}", sheet.width(), sheet.height());
    let (code, _, error) = outcome(folder.path(), &["cross", "nowhere", "--sheet", "-o", "sheet.png"]);
    assert!(code == Some(2) && error.contains("no map to draw"), "{error}");
}

#[test]
fn shots_go_into_a_folder_for_each_map() {
    let folder = library();
    let (code, _, error) = outcome(folder.path(), &["shots", "skies", "-o", "shots", "--size", "16"]);
    assert_eq!((code, error.as_str()), (Some(0), ""));
    for map in ["right", "turned"] {
        assert!(folder.path().join("shots").join(map).join("contact-sheet.png").is_file(), "{map}");
    }
}

#[test]
fn the_configuration_holds_for_drawings_too() {
    let folder = library();
    std::fs::write(folder.path().join("skycube.toml"), "engine = \"babylon\"\n").unwrap();
    let arguments = ["cross", "skies/right", "-o", "cross.png", "--cell", "64"];
    let (_, text, _) = outcome(folder.path(), &arguments);
    assert!(text.contains("skycube.toml: engine babylon\n"), "{text}");
    let (_, other, _) = outcome(folder.path(), &[&arguments[..], &["--no-config"]].concat());
    assert!(!other.contains("skycube.toml"), "{other}");
}
