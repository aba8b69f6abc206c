//! Commands that write pictures of faces: what they replace, and what they refuse.

mod common;

use std::path::Path;

use common::{SHARED_IMAGE_LOOKUP, outcome, project};
use skycube::envmap::Face;

/// The six pictures of the compass in a folder, which is made.
fn copy_compass(folder: &Path) {
    std::fs::create_dir_all(folder).unwrap();
    for face in Face::ALL {
        let name = format!("{}.png", face.name());
        std::fs::copy(project("envmaps/compass").join(&name), folder.join(&name)).unwrap();
    }
}

#[test]
fn a_second_run_replaces_the_first_and_no_rival_is_left_beside() {
    let compass = project("envmaps/compass");
    let compass = compass.to_str().unwrap();
    let scene = project("lessons/06-environment-map/environment-with.toml");
    let commands = [
        vec!["fix", compass],
        vec!["bake", scene.to_str().unwrap(), "--face-size", "4", "--samples", "1"],
        vec!["shots", compass, "--size", "16"],
    ];
    for command in commands {
        let folder = tempfile::tempdir().unwrap();
        let run = || outcome(folder.path(), &[&command[..], &["-o", "out"]].concat());
        for _ in 0..2 {
            let (code, _, error) = run();
            assert_eq!(code, Some(0), "{command:?}: {error}");
        }
        std::fs::rename(folder.path().join("out/posy.png"), folder.path().join("out/POSY.tga")).unwrap();
        let (code, _, error) = run();
        assert_eq!(code, Some(2), "{command:?}");
        assert!(error.contains("POSY.tga: out/posy.png would be beside it"), "{error}");
    }
}

#[test]
fn shots_replace_no_pictures_without_their_contact_sheet() {
    let folder = tempfile::tempdir().unwrap();
    copy_compass(&folder.path().join("mine"));
    let compass = project("envmaps/compass");
    let (code, _, error) = outcome(folder.path(), &["shots", compass.to_str().unwrap(), "--size", "16", "-o", "mine"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("posx.png: this picture exists already"), "{error}");
}

#[test]
fn shots_of_the_outer_folder_do_not_vouch_for_pictures_inside() {
    let folder = tempfile::tempdir().unwrap();
    let compass = project("envmaps/compass");
    let shots =
        |output: &str| outcome(folder.path(), &["shots", compass.to_str().unwrap(), "--size", "16", "-o", output]);
    assert_eq!(shots("own").0, Some(0));
    copy_compass(&folder.path().join("own/mine"));
    assert_eq!(shots("own/mine").0, Some(2));
}

#[test]
fn shots_do_not_go_among_the_pictures_of_a_map_in_a_subfolder() {
    let folder = tempfile::tempdir().unwrap();
    copy_compass(&folder.path().join("outer/inner"));
    for face in Face::ALL {
        let [old, new] = [face.name(), &format!("sky_{}", face.name())]
            .map(|name| folder.path().join("outer/inner").join(name).with_extension("png"));
        std::fs::rename(old, new).unwrap();
    }
    let (code, _, error) = outcome(folder.path(), &["shots", "outer", "--size", "16", "-o", "outer/inner"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("this folder holds files that the command reads"), "{error}");
}

#[test]
fn shots_that_would_not_fit_into_memory_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let compass = project("envmaps/compass");
    let (code, _, error) =
        outcome(folder.path(), &["shots", compass.to_str().unwrap(), "--size", "16384", "-o", "out"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("--size: 98304 x 16384 pixels are too many"), "{error}");
}

#[test]
fn a_lookup_with_a_shared_image_is_not_fixed_into_five_files() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("double.toml"), SHARED_IMAGE_LOOKUP).unwrap();
    let compass = project("envmaps/compass");
    let arguments = ["fix", compass.to_str().unwrap(), "--lookup", "double.toml", "-o", "out"];
    let (code, _, error) = outcome(folder.path(), &arguments);
    assert_eq!(code, Some(2));
    assert!(error.contains("two faces of the lookup read posx"), "{error}");
    assert!(!folder.path().join("out").exists());
}

#[test]
fn a_position_with_a_word_among_its_numbers_is_refused() {
    let scene = project("lessons/06-environment-map/environment-with.toml");
    let folder = tempfile::tempdir().unwrap();
    for position in ["1,foo,2,3", "1,2,3,", "1,2", "1,2,inf"] {
        let arguments = ["bake", scene.to_str().unwrap(), "-o", "out", "--face-size", "4", "--position", position];
        assert_eq!(outcome(folder.path(), &arguments).0, Some(2), "{position}");
    }
}
