//! Scenes, and what they show on average.

use std::path::Path;

use glam::DVec3;
use skycube::integrators::{Integrator, RayCounts};
use skycube::math::Ray;
use skycube::render::{Rendering, Silent, render};
use skycube::sampling::{PixelSampler, SamplerKind, Sampling};
use skycube::scene::{Plan, Scene};

pub fn scene(text: &str) -> Scene {
    let head = "integrator = { kind = \"path\", depth = 64 }\n";
    let camera = "camera = { position = [0, -5, 1], target = [0, 0, 0], size = [48, 32] }\n";
    let camera = if text.contains("camera = ") { "" } else { camera };
    let head = if text.contains("integrator = ") { "" } else { head };
    Scene::from_text(&format!("{head}{camera}{text}"), Path::new("test.toml")).unwrap_or_else(|error| panic!("{error}"))
}

pub fn rendering(scene: &Scene) -> Rendering {
    render(scene, &Plan::new(scene), &Silent).unwrap()
}

/// Mean radiance along one ray and its standard error, by independent samples.
pub fn along(scene: &Scene, origin: DVec3, direction: DVec3, samples: u32) -> (f64, f64) {
    let plan = Plan::new(scene);
    let integrator = Integrator::new(scene, &plan).unwrap();
    let ray = Ray::new(origin, direction.normalize());
    let media = integrator.media_around(origin);
    let sampling = Sampling { sampler: SamplerKind::Independent, ..Sampling::default() };
    let (mut sum, mut squares) = (0.0, 0.0);
    for index in 0..samples {
        let mut sampler = PixelSampler::chosen(sampling, 3, 5, index);
        let radiance = integrator.radiance(&ray, &media, &mut sampler, &mut RayCounts::default());
        assert!(radiance.is_finite() && radiance.min_element() >= 0.0, "{radiance}");
        let value = f64::from(radiance.element_sum()) / 3.0;
        sum += value;
        squares += value * value;
    }
    let count = f64::from(samples);
    let mean = sum / count;
    (mean, ((squares / count - mean * mean).max(0.0) / count).sqrt())
}

pub fn assert_agrees((mean, error): (f64, f64), expected: f64, what: &str) {
    assert!((mean - expected).abs() <= 4.0 * error + 1e-5, "{what}: {mean} +- {error}, expected {expected}");
}

pub const FURNACE: &str = "environment = { kind = \"constant\", radiance = 1 }\n";

/// Mean of a picture's pixels, all channels, and its standard error from pictures with other seeds.
pub fn mean_of_pictures(scene: &mut Scene, pictures: u32) -> (f64, f64) {
    let means: Vec<f64> = (0..pictures)
        .map(|seed| {
            scene.sampling.seed = seed;
            let raster = rendering(scene).raster;
            let sum: f64 = raster.pixels().iter().map(|pixel| f64::from(pixel.element_sum())).sum();
            sum / (3 * raster.pixels().len()) as f64
        })
        .collect();
    let count = means.len() as f64;
    let mean = means.iter().sum::<f64>() / count;
    let variance = means.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / (count - 1.0);
    (mean, (variance / count).sqrt())
}

/// Glass, mirror, rough metal and floor under a bright spot in a dim sky, given as a mesh of light far above.
pub const MIXED: &str = "
camera = { position = [0, -6, 2], target = [0, 0, 0.6], size = [32, 24], samples = 16 }
environment = { kind = \"gradient\", zenith = [0.3, 0.5, 0.9], horizon = 0.6, nadir = 0.1 }
materials.floor = { kind = \"lambert\", colour = 0.6 }
materials.glass = { kind = \"glass\" }
materials.mirror = { kind = \"mirror\" }
materials.metal = { kind = \"metal\", metal = \"gold\", roughness = 0.3 }
materials.lamp = { kind = \"light\", radiance = 20 }
shapes = [
    { kind = \"plane\", material = \"floor\" },
    { kind = \"sphere\", centre = [-1.5, 0, 1], material = \"glass\" },
    { kind = \"sphere\", centre = [0.4, 0.6, 0.7], radius = 0.7, material = \"mirror\" },
    { kind = \"sphere\", centre = [1.8, 0, 0.6], radius = 0.6, material = \"metal\" },
    { kind = \"rectangle\", centre = [-2, -1, 4], normal = [0.3, 0.1, -1], size = [1, 1], material = \"lamp\" },
]
";
