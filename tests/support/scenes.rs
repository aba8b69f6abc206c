//! Scenes to compare two ways of rendering on: those of the lessons, small, and random ones.
#![allow(dead_code)] // Every test uses a part of it.

use std::path::{Path, PathBuf};

use skycube::scene::{Plan, Scene};
use skycube::stress::Random;

/// How many random scenes are tried.
pub const RANDOM_SCENES: u64 = 200;

/// Every scene of the lessons, in a small picture with few samples.
pub fn of_lessons() -> Vec<(PathBuf, Scene)> {
    let lessons = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    let entries = |folder: &Path| std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let folders = entries(&lessons).filter(|path| path.is_dir());
    let mut files: Vec<PathBuf> = folders
        .flat_map(|folder| entries(&folder).collect::<Vec<_>>())
        .filter(|file| file.extension().is_some_and(|extension| extension == "toml"))
        .filter(|file| file.file_name().is_some_and(|name| name != "lesson.toml"))
        .collect();
    files.sort();
    assert!(files.len() > 25, "{} scenes", files.len());
    let small = |file: PathBuf| {
        let mut scene = Scene::read(&file).unwrap();
        scene.camera = scene.camera.resized([48, 32]);
        scene.samples = scene.samples.min(4);
        (file, scene)
    };
    files.into_iter().map(small).collect()
}

/// The same scene, rendered by the textbook's code alone.
pub fn textbook_plan(scene: &mut Scene) -> Plan {
    scene.integrator.fast = false;
    Plan::new(scene)
}

fn pick<'a>(random: &mut Random, choices: &[&'a str]) -> &'a str {
    choices[random.below(choices.len())]
}

/// A scene for Whitted's or Phong's integrator: spheres, boxes, ellipsoids, discs and a floor, glass in glass, all kinds of
/// lights, near and far cameras, lenses, with and without a hierarchy.
pub fn random_whitted(seed: u64) -> Scene {
    let random = &mut Random(seed);
    let mut shapes = vec!["{ kind = \"plane\", material = \"floor\" }".to_owned()];
    for _ in 0..1 + random.below(7) {
        let [x, y, z] = (random.in_ball() * 2.0).to_array();
        let (radius, z) = (0.2 + 0.6 * random.unit(), z + 1.5);
        let material = pick(random, &["glass", "tinted", "mirror", "shiny", "clay", "metal", "lamp"]);
        shapes.push(match random.below(6) {
            0 => format!(
                "{{ kind = \"box\", minimum = [{x}, {y}, {z}], maximum = [{}, {}, {}], rotate = [{}, 0, 30], material = \"{material}\" }}",
                x + radius, y + radius, z + 0.8 * radius, 40.0 * random.unit()
            ),
            1 => format!(
                "{{ kind = \"disc\", centre = [{x}, {y}, {z}], normal = [{x}, 0.3, 1], radius = {radius}, material = \"{material}\" }}"
            ),
            2 => format!(
                "{{ kind = \"sphere\", radius = {radius}, scale = [1, 0.6, 1.3], translate = [{x}, {y}, {z}], material = \"{material}\" }}"
            ),
            3 => format!(
                "{{ kind = \"sphere\", centre = [{x}, {y}, {z}], radius = {radius}, material = \"glass\" }}, \
                 {{ kind = \"sphere\", centre = [{x}, {y}, {z}], radius = {}, material = \"{material}\" }}",
                0.5 * radius
            ),
            _ => format!(
                "{{ kind = \"sphere\", centre = [{x}, {y}, {z}], radius = {radius}, material = \"{material}\" }}"
            ),
        });
    }
    let far = if random.below(4) == 0 { 1000.0 } else { 1.0 };
    match random.below(4) {
        // Glass that touches glass, and glass around the camera, out of which rays may miss everything.
        0 => shapes.push(
            "{ kind = \"box\", minimum = [-2, -2, 0.1], maximum = [-1, -1, 1.1], material = \"glass\" }, \
             { kind = \"box\", minimum = [-1, -2, 0.1], maximum = [0, -1, 1.1], material = \"tinted\" }"
                .to_owned(),
        ),
        1 => shapes.push("{ kind = \"sphere\", centre = [0, -6, 2], radius = 1, material = \"tinted\" }".to_owned()),
        _ => {}
    }
    let lens = if random.below(4) == 0 { "aperture = 0.1, focus = 5," } else { "" };
    let (filter, samples) = (pick(random, &["box", "gaussian", "tent"]), 1 + random.below(3));
    let integrator = pick(random, &["whitted", "whitted", "whitted", "phong"]);
    let (depth, hierarchy) = (random.below(9), pick(random, &["auto", "off"]));
    let cutoff = [0.0, 0.001, 0.2][random.below(3)];
    let light = |random: &mut Random| match random.below(4) {
        0 => "{ kind = \"directional\", direction = [1, -2, -3], irradiance = 1 }".to_owned(),
        1 => {
            "{ kind = \"spot\", position = [3, 5, 4], target = [0, 0, 0], intensity = 60, angle = 25, inner_angle = 9 }"
                .to_owned()
        }
        2 => "{ kind = \"ambient\", radiance = 0.1 }".to_owned(),
        _ => format!("{{ kind = \"point\", position = [{}, -4, 6], intensity = 40 }}", 4.0 - 8.0 * random.unit()),
    };
    let lights: Vec<String> = (0..random.below(4)).map(|_| light(random)).collect();
    parse(&format!(
        "camera = {{ position = [0, {}, {}], target = [0, 0, 1], field_of_view = {}, {lens} size = [35, 18], \
                     filter = \"{filter}\", samples = {samples} }}\n\
         environment = {{ kind = \"gradient\", zenith = [0.2, 0.4, 0.9], horizon = [1, 0.9, 0.8] }}\n\
         integrator = {{ kind = \"{integrator}\", depth = {depth}, weight_cutoff = {cutoff}, hierarchy = \"{hierarchy}\" }}\n\
         materials.floor = {{ kind = \"lambert\", colour = {{ checker = [0.3, 0.6], repeat = 1 }} }}\n\
         materials.clay = {{ kind = \"lambert\", colour = 0.5 }}\nmaterials.glass = {{ kind = \"glass\" }}\n\
         materials.tinted = {{ kind = \"glass\", index = 1.3, absorption = [0.4, 0.1, 0.2] }}\n\
         materials.mirror = {{ kind = \"mirror\", colour = 0.9 }}\nmaterials.lamp = {{ kind = \"light\", radiance = 2 }}\n\
         materials.shiny = {{ kind = \"phong\", diffuse = 0.5, specular = 0.4, exponent = 30 }}\n\
         materials.metal = {{ kind = \"metal\", metal = \"gold\", roughness = 0.2 }}\n\
         lights = [{}]\nshapes = [{}]\n",
        -6.0 * far,
        1.0 + far,
        if far > 1.0 { 0.05 } else { 45.0 },
        lights.join(", "),
        shapes.join(", ")
    ))
}

/// A scene whose light goes through glass and over mirrors: spheres, a prism or glass in glass between lamps and a floor. The
/// lamps are so large that chance finds them, too.
pub fn random_focusing(seed: u64) -> Scene {
    let random = &mut Random(seed);
    let mut shapes = vec!["{ kind = \"plane\", material = \"floor\" }".to_owned()];
    for _ in 0..1 + random.below(2) {
        let material = pick(random, &["lamp", "warm"]);
        let (x, y, radius) = (3.0 * random.unit() - 1.5, 3.0 * random.unit() - 1.5, 1.0 + 0.5 * random.unit());
        shapes.push(match random.below(2) {
            0 => {
                format!("{{ kind = \"sphere\", centre = [{x}, {y}, 4], radius = {radius}, material = \"{material}\" }}")
            }
            _ => format!(
                "{{ kind = \"rectangle\", centre = [{x}, {y}, 4], normal = [0.2, 0.1, -1], size = [{radius}, 2], \
                 material = \"{material}\" }}"
            ),
        });
    }
    for number in 0..1 + random.below(3) {
        let material = pick(random, &["glass", "tinted", "mirror", "gold", "clay", "coated", "shiny"]);
        let (x, y, radius) = (1.5 * number as f64 - 1.0, random.unit() - 0.5, 0.4 + 0.3 * random.unit());
        shapes.push(match random.below(4) {
            0 => format!(
                "{{ kind = \"box\", minimum = [{x}, {y}, 0.2], maximum = [{}, {}, {}], rotate = [0, {}, 10], \
                 material = \"{material}\" }}",
                x + radius,
                y + radius,
                0.2 + radius,
                50.0 * random.unit()
            ),
            1 => format!(
                "{{ kind = \"sphere\", centre = [{x}, {y}, 0.9], radius = {radius}, material = \"glass\" }}, \
                 {{ kind = \"sphere\", centre = [{x}, {y}, 0.9], radius = {}, material = \"{material}\" }}",
                0.5 * radius
            ),
            _ => format!(
                "{{ kind = \"sphere\", centre = [{x}, {y}, 0.9], radius = {radius}, material = \"{material}\" }}"
            ),
        });
    }
    let sky = pick(random, &["0", "[0.3, 0.4, 0.6]"]);
    let (depth, strategy) = (3 + random.below(9), pick(random, &["auto", "auto", "mis", "light"]));
    // Dark floors let paths end at random.
    let floor = pick(random, &["0.6", "0.2", "[0.5, 0.2, 0.1]"]);
    let light = pick(
        random,
        &[
            "",
            "{ kind = \"point\", position = [-3, -2, 4], intensity = 9 }",
            "{ kind = \"directional\", direction = [1, 2, -3], irradiance = 0.8 }",
        ],
    );
    parse(&format!(
        "camera = {{ position = [0, -4, 2.5], target = [0, 0, 0.3], size = [12, 8], samples = 8 }}\n\
         environment = {{ kind = \"constant\", radiance = {sky} }}\n\
         integrator = {{ kind = \"path\", depth = {depth}, strategy = \"{strategy}\" }}\n\
         materials.floor = {{ kind = \"lambert\", colour = {floor} }}\nmaterials.clay = {{ kind = \"lambert\", colour = 0.5 }}\n\
         materials.coated = {{ kind = \"coated\", colour = 0.5 }}\n\
         materials.shiny = {{ kind = \"phong\", diffuse = 0.4, specular = 0.4, exponent = 30 }}\n\
         lights = [{light}]\nmaterials.lamp = {{ kind = \"light\", radiance = 8 }}\nmaterials.warm = {{ kind = \"light\", radiance = [9, 6, 3] }}\n\
         materials.glass = {{ kind = \"glass\" }}\nmaterials.mirror = {{ kind = \"mirror\", colour = [0.9, 0.7, 0.5] }}\n\
         materials.tinted = {{ kind = \"glass\", index = 1.8, absorption = [0.4, 0.1, 0] }}\n\
         materials.gold = {{ kind = \"metal\", metal = \"gold\", roughness = 0 }}\nshapes = [{}]\n",
        shapes.join(", ")
    ))
}

fn parse(text: &str) -> Scene {
    Scene::from_text(text, Path::new("random.toml")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}
