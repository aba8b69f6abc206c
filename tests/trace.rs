//! A traced pixel is the pixel that `render` writes, bit for bit, and what the trace tells adds up to it.

mod common;

use std::path::Path;

use common::outcome as skycube;
use skycube::PixelTrace;
use skycube::colour::{Encoding, ToneMap};
use skycube::integrators::{Event, LightOutcome};
use skycube::math::Vec3;
use skycube::render::{Silent, render};
use skycube::scene::{IntegratorKind, Plan, Scene};

const LESSON: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/06-environment-map/glass-and-mirror.toml");

const KINDS: [IntegratorKind; 4] =
    [IntegratorKind::Normals, IntegratorKind::Phong, IntegratorKind::Whitted, IntegratorKind::Path];

fn scene(kind: IntegratorKind, samples: u32) -> Scene {
    let mut scene = Scene::read(Path::new(LESSON)).unwrap();
    scene.camera = scene.camera.resized([12, 8]);
    scene.integrator.kind = kind;
    scene.samples = samples;
    // Guided paths have other noise than those that are watched.
    scene.integrator.fast = kind != IntegratorKind::Path;
    scene
}

fn bits(colour: Vec3) -> [u32; 3] {
    colour.to_array().map(f32::to_bits)
}

/// What a ray brought back, computed anew from what the trace tells of it: factors times what branches brought back,
/// contributions of lights, colours. `None` at the end of the ray's events.
fn radiance_of(events: &mut std::slice::Iter<Event>) -> Vec3 {
    let (mut radiance, mut through) = (Vec3::ZERO, Vec3::ONE);
    while let Some(event) = events.next() {
        match *event {
            Event::Hit { transmittance, .. } => through = transmittance,
            Event::Missed { environment, transmittance, .. } => (radiance, through) = (environment, transmittance),
            Event::Own { colour, .. } => radiance = colour,
            Event::Light { outcome: LightOutcome::Ambient { contribution }, .. }
            | Event::Light { outcome: LightOutcome::Free { contribution, .. }, .. } => radiance += contribution,
            Event::Ray { factor, .. } => radiance += factor * radiance_of(events),
            Event::End { radiance: told } => {
                let found = through * radiance;
                assert_eq!(told.map(bits), Some(bits(found)), "the ray's result is not what it found");
                return found;
            }
            _ => {}
        }
    }
    panic!("the ray has no end");
}

#[test]
fn a_traced_pixel_is_the_rendered_one() {
    for kind in KINDS {
        for samples in [1, 5] {
            let scene = scene(kind, samples);
            let plan = Plan::new(&scene);
            let rendered = render(&scene, &plan, &Silent).unwrap().raster;
            for (x, y) in [(0, 0), (3, 5), (6, 4), (2, 4), (8, 4), (9, 3), (11, 7), (5, 3)] {
                let trace = PixelTrace::of(&scene, &plan, [x, y], samples - 1).unwrap();
                assert_eq!(bits(trace.colour), bits(rendered.pixel(x, y)), "{kind:?} {samples} ({x}, {y})");
            }
        }
    }
}

#[test]
fn what_the_trace_tells_adds_up() {
    for kind in KINDS {
        let scene = scene(kind, 2);
        let plan = Plan::new(&scene);
        let mut branches = 0;
        // Every path trace builds its tables anew.
        let step = if kind == IntegratorKind::Path { 5 } else { 1 };
        for (x, y) in (0..12).flat_map(|x| (0..8).map(move |y| (x, y))).step_by(step) {
            let trace = PixelTrace::of(&scene, &plan, [x, y], 1).unwrap();
            let radiance = trace.samples[1].radiance;
            let mut events = trace.events.iter();
            assert!(matches!(events.next(), Some(Event::Ray { .. })));
            branches += trace.events.iter().filter(|event| matches!(event, Event::Ray { .. })).count() - 1;
            if kind == IntegratorKind::Path {
                let mut sum = Vec3::ZERO;
                for event in events {
                    if let Event::Added { contribution, .. } = event {
                        sum += *contribution;
                    }
                }
                assert_eq!(bits(sum), bits(radiance), "({x}, {y})");
            } else {
                assert_eq!(bits(radiance_of(&mut events)), bits(radiance), "{kind:?} ({x}, {y})");
                assert!(events.next().is_none());
            }
        }
        println!("{kind:?}: {branches} branches followed");
        assert!(kind != IntegratorKind::Whitted || branches > 50);
    }
}

#[test]
fn the_command_tells_the_colour_that_the_picture_holds() {
    let folder = tempfile::tempdir().unwrap();
    let size = ["--size", "24x16", "--samples", "3"];
    for kind in ["normals", "phong", "whitted", "path"] {
        let more = [&size[..], &["--integrator", kind]].concat();
        let more = if kind == "path" { [&more[..], &["--textbook"]].concat() } else { more };
        let (code, _, error) = skycube(folder.path(), &[&["render", LESSON, "-o", "a.exr"], &more[..]].concat());
        assert_eq!(code, Some(0), "{error}");
        let picture = skycube::picture::read(&folder.path().join("a.exr")).unwrap();
        for (x, y) in [(4, 9), (12, 7), (17, 9)] {
            let pixel = format!("{x},{y}");
            let arguments = [&["trace", LESSON, "--pixel", &pixel, "--json"], &more[..]].concat();
            let (code, json, error) = skycube(folder.path(), &arguments);
            assert_eq!(code, Some(0), "{error}");
            let json = common::json_report(&json);
            let told: Vec<u32> =
                json["colour"].as_array().unwrap().iter().map(|v| (v.as_f64().unwrap() as f32).to_bits()).collect();
            assert_eq!(told, bits(picture.texel(x, y)), "{kind} {pixel}");
        }
    }
}

#[test]
fn a_trace_says_where_the_picture_has_other_noise() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "camera = { position = [0, -5, 1], target = [0, 0, 1], size = [8, 8], samples = 2 }\n\
        integrator = { kind = \"path\" }\nmaterials.floor = { kind = \"lambert\", colour = 0.5 }\n\
        materials.glass = { kind = \"glass\" }\nmaterials.lamp = { kind = \"light\", radiance = 9 }\n\
        shapes = [{ kind = \"plane\", material = \"floor\" },\n\
        { kind = \"sphere\", centre = [0, 0, 1], radius = 0.7, material = \"glass\" },\n\
        { kind = \"sphere\", centre = [1, 0, 3], radius = 0.2, material = \"lamp\" }]\n";
    std::fs::write(folder.path().join("a.toml"), scene).unwrap();
    let said = "The picture is rendered by guided paths, with the same mean and other noise";
    // Without a lamp and glass nothing guides.
    let dark = scene.replace("kind = \"glass\"", "kind = \"mirror\"").replace("radiance = 9", "radiance = 0");
    std::fs::write(folder.path().join("dark.toml"), dark).unwrap();
    let (code, text, error) = skycube(folder.path(), &["trace", "dark.toml", "--pixel", "4,4"]);
    assert_eq!((code, text.contains(said)), (Some(0), false), "{text}{error}");
    for (more, noted) in [(&[][..], true), (&["--textbook"], false)] {
        let arguments = [&["trace", "a.toml", "--pixel", "4,4"], more].concat();
        let (code, text, error) = skycube(folder.path(), &arguments);
        assert_eq!((code, text.contains(said)), (Some(0), noted), "{text}{error}");
    }
}

#[test]
fn the_tree_reads_well_and_errors_are_clear() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["trace", LESSON, "--size", "24x16", "--samples", "2", "--pixel", "4,9"];
    let (code, text, _) = skycube(folder.path(), &arguments);
    println!("{text}");
    assert_eq!(code, Some(0));
    for part in
        ["camera ray from", "material \"glass\" (glass)", "Fresnel, index 1 to 1.5", "  refracted ray x ", "pixel = "]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
    let (_, path, _) = skycube(folder.path(), &[&arguments[..], &["--integrator", "path"]].concat());
    println!("{path}");
    let (code, _, error) = skycube(folder.path(), &["trace", LESSON, "--size", "24x16", "--pixel", "24,9"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("there is no pixel (24, 9)"), "{error}");
    let (code, _, error) = skycube(folder.path(), &["trace", LESSON, "--pixel", "4,9", "--sample", "16"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("at most 15"), "{error}");
}

#[test]
fn every_ray_ends_once_even_where_a_glass_was_never_left() {
    // A disc of glass has no other side: rays enter it and find out later that they are not inside.
    let text = "camera = { position = [-3.4919, -5.1187, -5.1404], target = [0.8688, -0.8169, 0.2588], size = [37, 21], \
        samples = 2, sampler = \"independent\" }\n\
        environment = { kind = \"constant\", radiance = 1 }\nintegrator = { depth = 5, weight_cutoff = 0 }\n\
        materials.glass = { kind = \"glass\" }\nshapes = [\n\
        { kind = \"sphere\", centre = [-2.2078, -1.8356, -1.901], radius = 2.3687, material = \"glass\" },\n\
        { kind = \"disc\", centre = [-0.5456, 0.082, -0.4482], normal = [0.7614, -0.662, -0.8531], radius = 1.5856, \
        material = \"glass\" }]\n";
    let scene = Scene::from_text(text, Path::new("disc.toml")).unwrap();
    let plan = Plan::new(&scene);
    for pixel in (0..37 * 21).map(|number| [number % 37, number / 37]) {
        let events = PixelTrace::of(&scene, &plan, pixel, 0).unwrap().events;
        let count = |counts: fn(&Event) -> bool| events.iter().filter(|event| counts(event)).count();
        let rays = count(|event| matches!(event, Event::Ray { .. }));
        assert_eq!(count(|event| matches!(event, Event::End { .. })), rays, "{pixel:?}");
    }
}

#[test]
fn the_code_told_is_that_of_the_picture_by_the_scenes_tone_map() {
    let folder = tempfile::tempdir().unwrap();
    for tone_map in ["clamp", "reinhard"] {
        let text = format!(
            "camera = {{ position = [0, 0, 0], target = [1, 0, 0], size = [2, 2] }}\noutput = {{ tone_map = \"{tone_map}\" }}\n\
             environment = {{ kind = \"constant\", radiance = [2, 0.7, 0.1] }}\n"
        );
        std::fs::write(folder.path().join("sky.toml"), text).unwrap();
        let (code, _, error) = skycube(folder.path(), &["render", "sky.toml", "-o", "sky.png"]);
        assert_eq!(code, Some(0), "{error}");
        let shown = skycube::picture::read(&folder.path().join("sky.png")).unwrap().texel(1, 1);
        let [red, green, blue] = ToneMap::Clamp.bytes_as(shown, Encoding::Srgb);
        let (_, told, _) = skycube(folder.path(), &["trace", "sky.toml", "--pixel", "1,1"]);
        assert!(told.contains(&format!("8-bit sRGB code ({red}, {green}, {blue}), ")), "{told}");
    }
}
