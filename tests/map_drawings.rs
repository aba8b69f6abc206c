//! The commands that look at a map: cross, shots, probe.

mod common;

use std::path::{Path, PathBuf};
use std::process::Output;

use common::skycube;
use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Face, Preset, Probe};
use skycube::math::Vec3;
use skycube::picture::{Picture, Raster, WriteOptions, read, write};

fn compass() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass")
}

fn stdout(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Directions in all parts of the cube: a grid with faces, edges, corners, ties, and places between.
fn directions() -> impl Iterator<Item = Vec3> {
    let steps = || (-24..=24).map(|step| step as f32 / 16.0);
    let grid = steps().flat_map(move |x| steps().flat_map(move |y| steps().map(move |z| Vec3::new(x, y * 1.01, z))));
    grid.filter(|direction| *direction != Vec3::ZERO)
}

#[test]
fn a_probe_tells_the_colour_of_sample_bit_for_bit() {
    let skybox = Skybox::open(&compass()).unwrap();
    for filter in [CubeFilter::Nearest, CubeFilter::Bilinear, CubeFilter::Seamless] {
        for preset in [Preset::Exercise, Preset::HumusYUp] {
            let map = CubeMap::from_skybox(&skybox, preset.lookup(), filter);
            for direction in directions() {
                let probe = Probe::new(&map, direction).unwrap();
                let bits = |colour: Vec3| colour.to_array().map(f32::to_bits);
                assert_eq!(bits(probe.colour), bits(map.sample(direction)), "{direction} {filter:?}");
                // What is listed is what was added.
                let sum: Vec3 = probe.texels.iter().map(|texel| texel.colour * texel.weight).sum();
                assert!((sum - probe.colour).abs().max_element() < 1e-6, "{direction} {filter:?}");
                for texel in &probe.texels {
                    let Some(place) = texel.place else { continue };
                    assert_eq!(texel.colour, map.picture(place.image).unwrap().texel(place.column, place.row));
                }
            }
        }
    }
}

#[test]
fn a_direction_that_points_nowhere_is_an_error() {
    let folder = compass();
    for direction in ["0,0,0", "nan,1,0", "inf,0,0", "1e39,0,0", "-0,0,0"] {
        let output = skycube(&folder, &["probe", ".", "--direction", direction]);
        assert_eq!(output.status.code(), Some(2), "{direction}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("has no direction"), "{direction}");
    }
}

#[test]
fn probe_prints_every_step() {
    let folder = compass();
    let map = folder.parent().unwrap();
    let text = stdout(&skycube(map, &["probe", "compass", "--lookup", "course", "--direction", "0.3,-1,0.5"]));
    insta::assert_snapshot!(text);
    let tie = stdout(&skycube(map, &["probe", "compass", "--direction", "2,2,2", "--filter", "seamless"]));
    insta::assert_snapshot!(tie);
    let json = stdout(&skycube(map, &["probe", "compass", "--direction", "-3,1,0.5", "--filter", "nearest", "--json"]));
    common::json_report(&json);
    insta::assert_snapshot!(json);
}

#[test]
fn shots_writes_six_pictures_a_sheet_and_the_camera() {
    let folder = tempfile::tempdir().unwrap();
    let map = compass();
    let map = map.to_str().unwrap();
    let arguments = ["shots", map, "-o", "out", "--lookup", "humus-y-up", "--size", "64"];
    insta::assert_snapshot!(stdout(&skycube(folder.path(), &arguments)));
    for face in Face::ALL {
        let shot = read(&folder.path().join("out").join(face.name()).with_extension("png")).unwrap();
        assert_eq!((shot.width(), shot.height()), (64, 64));
    }
    assert_looks_as_it_did(&folder.path().join("out/contact-sheet.png"), "contact-sheet-compass");
}

#[test]
fn the_pictures_of_a_map_are_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    for face in Face::ALL {
        let name = Path::new(face.name()).with_extension("png");
        std::fs::copy(compass().join(&name), folder.path().join(&name)).unwrap();
    }
    let before = std::fs::read(folder.path().join("posx.png")).unwrap();
    for arguments in [["shots", ".", "-o", "."], ["cross", ".", "-o", "posx.png"]] {
        let output = skycube(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    }
    assert_eq!(std::fs::read(folder.path().join("posx.png")).unwrap(), before);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 6);
}

#[test]
fn broken_seams_and_pictures_to_repair_are_vermilion() {
    const BLUE: [u8; 3] = [0, 114, 178];
    const VERMILION: [u8; 3] = [213, 94, 0];
    let folder = tempfile::tempdir().unwrap();
    let count = |map: &Path, colour: [u8; 3]| {
        let arguments = ["cross", map.to_str().unwrap(), "--lookup", "humus-z-up", "-o", "cross.png"];
        stdout(&skycube(folder.path(), &arguments));
        match read(&folder.path().join("cross.png")).unwrap().texels() {
            skycube::picture::Texels::Srgb8(bytes) => bytes.chunks_exact(3).filter(|pixel| **pixel == colour).count(),
            skycube::picture::Texels::Linear(_) => panic!("an 8-bit picture"),
        }
    };
    let broken = common::project("lessons/06-environment-map/broken");
    assert!(count(&broken, VERMILION) > 5000, "{}", count(&broken, VERMILION));
    assert_eq!(count(&compass(), VERMILION), 0);
    assert!(count(&compass(), BLUE) > 1000, "{}", count(&compass(), BLUE));
}

/// The mean difference of 255 over pixels and channels.
fn difference(one: &Picture, other: &Picture) -> f32 {
    assert_eq!((one.width(), one.height()), (other.width(), other.height()));
    let [one, other] = [one, other].map(|picture| match picture.texels() {
        skycube::picture::Texels::Srgb8(bytes) => bytes,
        skycube::picture::Texels::Linear(_) => panic!("an 8-bit picture"),
    });
    let sum: f32 = one.iter().zip(other).map(|(a, b)| f32::from(a.abs_diff(*b))).sum();
    sum / one.len() as f32
}

/// Compares a drawing with a golden one. `SKYCUBE_BLESS=1` writes the golden pictures anew: look at them.
fn assert_looks_as_it_did(drawn: &Path, name: &str) {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name).with_extension("png");
    if std::env::var_os("SKYCUBE_BLESS").is_some() {
        std::fs::copy(drawn, &golden).unwrap();
    }
    let step = difference(&read(drawn).unwrap(), &read(&golden).unwrap());
    assert!(step < 0.5, "{name}: {step} of 255 from {}", golden.display());
}

#[test]
fn crosses_look_as_they_did() {
    let folder = tempfile::tempdir().unwrap();
    let map = compass();
    for lookup in ["humus-z-up", "exercise"] {
        let arguments = ["cross", map.to_str().unwrap(), "-o", "cross.png", "--lookup", lookup, "--cell", "80"];
        stdout(&skycube(folder.path(), &arguments));
        assert_looks_as_it_did(&folder.path().join("cross.png"), &format!("cross-compass-{lookup}"));
    }
}

#[test]
fn shots_do_not_overwrite_what_may_be_the_students_own() {
    let folder = tempfile::tempdir().unwrap();
    let mine = folder.path().join("posy.png");
    std::fs::write(&mine, b"mine").unwrap();
    let map = compass();
    let arguments = ["shots", map.to_str().unwrap(), "-o", ".", "--size", "16"];
    let output = skycube(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("posy.png: this picture exists already"));
    assert_eq!(std::fs::read(&mine).unwrap(), b"mine");
    std::fs::remove_file(&mine).unwrap();
    // Its own shots are replaced.
    stdout(&skycube(folder.path(), &arguments));
    stdout(&skycube(folder.path(), &arguments));
}

/// A map in a folder, its faces computed from the compass.
fn map_of(folder: &Path, face: impl Fn(Face, Raster) -> Raster) {
    std::fs::create_dir(folder).unwrap();
    for name in Face::ALL {
        let file = Path::new(name.name()).with_extension("png");
        let raster = face(name, read(&compass().join(&file)).unwrap().to_raster());
        write(&raster, &folder.join(&file), &WriteOptions::default()).unwrap();
    }
}

#[test]
fn why_nothing_is_fixed_is_said_by_the_verdict() {
    let folder = tempfile::tempdir().unwrap();
    map_of(&folder.path().join("flat"), |_, _| Raster::filled(16, 16, Vec3::splat(0.5)));
    let reason = "undecidable: the pixels cannot decide whether these faces fit; nothing is changed";
    for arguments in [
        &["probe", "flat", "--direction", "1,2,3"][..],
        &["cross", "flat", "--fixed", "-o", "cross.png", "--cell", "64"],
        &["shots", "flat", "--fixed", "-o", "out", "--size", "16"],
    ] {
        let text = stdout(&skycube(folder.path(), arguments));
        assert!(text.contains(reason) && !text.contains("nothing to fix"), "{text}");
    }
}

#[test]
fn faces_of_several_sizes_are_seen_as_check_sees_them() {
    let folder = tempfile::tempdir().unwrap();
    map_of(&folder.path().join("mixed"), |face, raster| raster.reduced(if face == Face::PosX { 2 } else { 4 }));
    for filter in ["nearest", "bilinear", "seamless"] {
        let cross = ["cross", "mixed", "-o", "cross.png", "--cell", "64", "--filter", filter];
        stdout(&skycube(folder.path(), &cross));
    }
    stdout(&skycube(folder.path(), &["probe", "mixed", "--direction", "1,0.99,0"]));
    stdout(&skycube(folder.path(), &["shots", "mixed", "-o", "out", "--size", "64"]));
    let grade = ["grade", "out", "--map", "mixed", "--lookup", "opengl"];
    assert!(stdout(&skycube(folder.path(), &grade)).contains("right"));
}
