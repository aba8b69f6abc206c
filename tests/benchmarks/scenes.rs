//! Whole pictures on all cores: the lesson scene, three spheres as POV-Ray would have them, and rows of spheres that show
//! from how many shapes a hierarchy pays.
//!
//! `cargo bench --bench scenes`

use std::path::Path;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use skycube::render::{Silent, render};
use skycube::scene::{Plan, Scene};

const SPHERES: &str = r#"
camera = { position = [0, 2.2, 8], target = [0, 0.8, 0], up = [0, 1, 0], size = [640, 480] }
environment = { kind = "gradient", zenith = [0.25, 0.45, 0.9], horizon = [1, 0.95, 0.9], up = "+y" }
materials.ground = { kind = "lambert", colour = { checker = [0.3, 0.6], repeat = 1 } }
materials.glass = { kind = "glass" }
materials.mirror = { kind = "mirror", colour = 0.9 }
materials.grey = { kind = "lambert", colour = 0.5 }
lights = [{ kind = "point", position = [-8, 12, 9], intensity = 3.8, falloff = "constant" }, { kind = "ambient", radiance = 0.15 }]
shapes = [
    { kind = "plane", normal = [0, 1, 0], material = "ground" },
    { kind = "sphere", centre = [-2.2, 1, 0], material = "glass" },
    { kind = "sphere", centre = [0, 1, 0], material = "mirror" },
    { kind = "sphere", centre = [2.2, 1, 0], material = "grey" },
]
"#;

fn rows(count: usize) -> String {
    let spheres: String = (0..count)
        .map(|index| {
            let (x, y, z) = (index % 3, index / 9, index / 3 % 3);
            format!("{{ kind = \"sphere\", centre = [{x}, {y}, {z}], radius = 0.4, material = \"a\" }},\n")
        })
        .collect();
    format!(
        "camera = {{ position = [1, -4, 5], target = [1, 0.5, 1], size = [320, 240] }}\n\
         environment = {{ kind = \"constant\", radiance = 1 }}\nmaterials.a = {{ kind = \"mirror\" }}\nshapes = [\n{spheres}]\n"
    )
}

fn scenes(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("scenes");
    group.sample_size(10).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(3));
    let mut bench = |name: &str, scene: Scene| {
        let plan = Plan::new(&scene);
        group.bench_function(name, |bencher| bencher.iter(|| render(&scene, &plan, &Silent)));
    };
    let lesson = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/06-environment-map/environment-with.toml");
    let mut lesson = Scene::read(&lesson).expect("the lesson is a scene");
    lesson.camera = lesson.camera.resized([640, 400]);
    bench("lesson 06, 640 x 400, 4 samples", lesson);
    let scene = |text: &str| Scene::from_text(text, Path::new("benchmark.toml")).expect("the scene is right");
    bench("three spheres, 640 x 480", scene(SPHERES));
    for count in [2, 4, 6, 7, 8, 12, 16, 32] {
        bench(&format!("{count} mirror spheres, 320 x 240"), scene(&rows(count)));
    }
    group.finish();
}

criterion_group!(benches, scenes);
criterion_main!(benches);
