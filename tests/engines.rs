//! Maps made for each engine by what its documents say, read with `--engine`.

mod common;

use std::path::Path;

use common::{outcome, project};
use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Engine, Face, Handedness};
use skycube::math::Vec3;
use skycube::picture::{Raster, WriteOptions, read, write};
use skycube::render::AxisShot;

const SIDE: usize = 128;

/// A view with detail in all directions, and no symmetry.
fn colour(direction: Vec3) -> Vec3 {
    let Vec3 { x, y, z } = direction.normalize();
    let wave = |phase: f32| 0.5 + 0.4 * phase.sin();
    Vec3::new(wave(9.0 * x + 4.0 * y), wave(11.0 * y - 3.0 * z + 1.0), wave(8.0 * z + 5.0 * x * y + 2.0))
}

/// The directions of a file in the engine's world: through its middle, to its right, to its top.
type View = [Vec3; 3];

const X: Vec3 = Vec3::X;
const Y: Vec3 = Vec3::Y;
const Z: Vec3 = Vec3::Z;

/// The table of the OpenGL specification, 8.19: +sc to the right, +tc downwards.
const OPENGL: [View; 6] = [
    [X, Vec3::NEG_Z, Y],
    [Vec3::NEG_X, Z, Y],
    [Y, X, Vec3::NEG_Z],
    [Vec3::NEG_Y, X, Z],
    [Z, X, Y],
    [Vec3::NEG_Z, Vec3::NEG_X, Y],
];

/// What the files +X -X +Y -Y +Z -Z of an engine hold.
fn files_of(engine: Engine) -> [View; 6] {
    let (neg_x, neg_y, neg_z) = (-X, -Y, -Z);
    match engine {
        Engine::Opengl | Engine::Vulkan | Engine::Godot => OPENGL,
        // Left-handed, y up: every file is what a viewer sees, right = up x forward; above, the front is behind the head.
        Engine::Directx | Engine::Babylon | Engine::Unity => {
            let seen = |forward: Vec3, up: Vec3| [forward, up.cross(forward), up];
            [seen(X, Y), seen(neg_x, Y), seen(Y, neg_z), seen(neg_y, Z), seen(Z, Y), seen(neg_z, Y)]
        }
        // "pos-x and neg-x swapped": the loader reads along (-x, y, z).
        Engine::Threejs => OPENGL.map(|view| view.map(|axis| Vec3::new(-axis.x, axis.y, axis.z))),
        // What is seen in a left-handed world with z up, turned as Unreal's page says.
        Engine::Unreal => {
            let seen = |forward: Vec3, up: Vec3| [forward, up.cross(forward), up];
            let turned_counterclockwise = |[forward, right, up]: View| [forward, -up, right];
            let half = |view| turned_counterclockwise(turned_counterclockwise(view));
            [
                turned_counterclockwise(seen(X, Z)),
                turned_counterclockwise(half(seen(neg_x, Z))),
                half(seen(Y, Z)),
                seen(neg_y, Z),
                // "The side that must align with positive Y should be at the top."
                seen(Z, Y),
                seen(neg_z, Y),
            ]
        }
        // Six cameras of a right-handed world with z up, right = forward x up.
        Engine::Blender => {
            let seen = |forward: Vec3, up: Vec3| [forward, forward.cross(up), up];
            [seen(X, Z), seen(neg_x, Z), seen(Y, Z), seen(neg_y, Z), seen(Z, neg_y), seen(neg_z, Y)]
        }
    }
}

/// Writes the six files of an engine under the names of its documents.
fn make_map(engine: Engine, folder: &Path) {
    for ([forward, right, up], name) in files_of(engine).into_iter().zip(engine.file_names()) {
        let offset = |index: usize| (2 * index + 1) as f32 / SIDE as f32 - 1.0;
        let file = Raster::from_function(SIDE, SIDE, |x, y| colour(forward + right * offset(x) - up * offset(y)));
        write(&file, &folder.join(format!("sky_{name}.png")), &WriteOptions::default()).unwrap();
    }
}

#[test]
fn every_engine_reads_the_map_that_was_made_for_it() {
    for engine in Engine::ALL {
        let folder = tempfile::tempdir().unwrap();
        make_map(engine, folder.path());
        let skybox = Skybox::open(folder.path()).unwrap();
        let files = Face::ALL.map(|image| skybox.image(image).name());
        let map = CubeMap::from_skybox(&skybox, engine.lookup(files), CubeFilter::Bilinear);
        for index in 0..500 {
            let [a, b, c] = [0.618, 0.414, 0.732].map(|step: f32| 2.0 * (index as f32 * step).fract() - 1.0);
            let direction = Vec3::new(a, b, c);
            let difference = (map.sample(direction) - colour(direction)).abs().max_element();
            assert!(difference < 0.05, "{} along {direction}: {difference}", engine.name());
        }
        let name = engine.name();
        let (code, report, error) = outcome(folder.path(), &["check", ".", "--engine", &name, "--json"]);
        assert_eq!(code, Some(0), "{name}: {report}{error}");
        assert!(report.contains("\"verdict\": \"fits\""), "{report}");
    }
}

/// Repaired files have the names that the engine's documents use, and fit.
#[test]
fn fix_writes_the_files_that_the_engine_loads() {
    for engine in Engine::ALL {
        let folder = tempfile::tempdir().unwrap();
        let map = folder.path().join("map");
        std::fs::create_dir(&map).unwrap();
        make_map(engine, &map);
        let file = |folder: &str, name: &str| format!("{folder}/{name}.png");
        let broken = folder.path().join(file("map", &format!("sky_{}", engine.file_names()[4])));
        let right = read(&broken).unwrap();
        let turned = Raster::from_function(SIDE, SIDE, |x, y| right.texel(y, SIDE - 1 - x));
        write(&turned, &broken, &WriteOptions::default()).unwrap();
        let name = engine.name();
        let (code, report, error) = outcome(folder.path(), &["fix", "map", "--engine", &name, "-o", "fixed"]);
        assert_eq!(code, Some(0), "{name}: {report}{error}");
        for file_name in engine.file_names() {
            assert!(folder.path().join(file("fixed", file_name)).is_file(), "{name}: {file_name}: {report}");
        }
        let mended = read(&folder.path().join(file("fixed", engine.file_names()[4]))).unwrap();
        assert_eq!(mended.texels(), right.texels(), "{name}");
        let (code, report, _) = outcome(folder.path(), &["check", "fixed", "--engine", &name]);
        assert_eq!(code, Some(0), "{name}: {report}");
    }
}

/// The six shots are what a viewer sees who stands in the engine's world.
#[test]
fn shots_are_what_the_engine_shows() {
    for engine in Engine::ALL {
        let folder = tempfile::tempdir().unwrap();
        let map = folder.path().join("map");
        std::fs::create_dir(&map).unwrap();
        make_map(engine, &map);
        let arguments = ["shots", "map", "--engine", &engine.name(), "--size", "32", "-o", "shots"];
        let (code, report, error) = outcome(folder.path(), &arguments);
        assert_eq!(code, Some(0), "{error}");
        assert!(report.starts_with(&format!("as {} shows it: ", engine.name())), "{report}");
        for shot in AxisShot::all(engine.world()) {
            let picture = read(&folder.path().join(format!("shots/{}.png", shot.direction.name()))).unwrap();
            let (forward, up) = (shot.direction.normal(), shot.up.direction());
            let right = match engine.world().handedness {
                Handedness::Right => forward.cross(up),
                Handedness::Left => up.cross(forward),
            };
            for (x, y) in (2..30).flat_map(|x| (2..30).map(move |y| (x, y))) {
                let offset = |index: usize| (2 * index + 1) as f32 / 32.0 - 1.0;
                let expected = colour(forward + right * offset(x) - up * offset(y));
                let difference = (picture.texel(x, y) - expected).abs().max_element();
                assert!(difference < 0.1, "{} {} ({x}, {y}): {difference}", engine.name(), shot.direction.name());
            }
        }
    }
}

/// A download with y up, in Direct3D's world, is the same picture as under `humus-y-up`, whose front is -z.
#[test]
fn a_download_is_not_mirrored_in_a_left_handed_engine() {
    let folder = tempfile::tempdir().unwrap();
    let courtyard = project("envmaps/courtyard").display().to_string();
    let take = |option: &str, value: &str, output: &str| {
        let arguments = ["shots", &courtyard, option, value, "--size", "64", "--samples", "1", "-o", output];
        let (code, _, error) = outcome(folder.path(), &arguments);
        assert_eq!(code, Some(0), "{error}");
    };
    take("--engine", "directx", "left");
    take("--lookup", "humus-y-up", "right");
    for (left, right) in [("posx", "posx"), ("posy", "posy"), ("posz", "negz"), ("negz", "posz")] {
        let [left, right] = [("left", left), ("right", right)]
            .map(|(shots, name)| read(&folder.path().join(format!("{shots}/{name}.png"))).unwrap());
        for (x, y) in (0..64).flat_map(|x| (0..64).map(move |y| (x, y))) {
            let difference = (left.texel(x, y) - right.texel(x, y)).abs().max_element();
            assert!(difference < 0.02, "({x}, {y}): {difference}");
        }
    }
}

#[test]
fn an_engine_and_a_lookup_that_contradict_it_are_one_error() {
    let folder = tempfile::tempdir().unwrap();
    let hall = project("envmaps/hall").display().to_string();
    for command in ["check", "cross", "probe", "fix", "shots"] {
        let more: &[&str] = match command {
            "probe" => &["--direction", "1,0,0"],
            "check" => &[],
            _ => &["-o", "out.png"],
        };
        let arguments = [&[command, &hall, "--engine", "threejs", "--lookup", "opengl"], more].concat();
        let (code, report, error) = outcome(folder.path(), &arguments);
        assert_eq!((code, report.as_str()), (Some(2), ""), "{command}: {error}");
        assert!(error.contains("--engine threejs does not read by --lookup opengl"), "{error}");
        assert_eq!(error.matches("error: ").count(), 1, "{error}");
    }
    // Unity reads axes by OpenGL's table.
    let (code, _, error) = outcome(folder.path(), &["check", &hall, "--engine", "unity", "--lookup", "opengl"]);
    assert_ne!(code, Some(2), "{error}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// The lookup alone would say so: the same files under another engine are mirrored or do not fit.
#[test]
fn the_report_says_what_the_engine_shows() {
    let folder = tempfile::tempdir().unwrap();
    let courtyard = project("envmaps/courtyard").display().to_string();
    let shown = |engine: &str| {
        let arguments = ["cross", &courtyard, "--engine", engine, "--cell", "64", "-o", "cross.png"];
        let (code, report, error) = outcome(folder.path(), &arguments);
        assert_eq!(code, Some(0), "{error}");
        report
    };
    assert!(shown("opengl").contains("photographs appear mirrored"), "{}", shown("opengl"));
    let (_, report, _) = outcome(folder.path(), &["check", &courtyard, "--engine", "unreal"]);
    assert!(report.ends_with("as unreal shows it: a left-handed world, +z up, front +x\n"), "{report}");
    assert!(shown("babylon").starts_with("as babylon shows it: a left-handed world, +y up, front +z\n"));
    assert!(shown("threejs").starts_with("as threejs shows it: a right-handed world, +y up, front -z\n"));
}
