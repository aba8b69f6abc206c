//! Guided paths find as much light as the textbook's, on average.

#[path = "support/scenes.rs"]
mod scenes;

use rayon::prelude::*;
use skycube::integrators::{Integrator, RayCounts};
use skycube::sampling::{PixelSampler, Sampling};
use skycube::scene::{IntegratorKind, Plan, Scene, Wing};

/// Pictures with noise of their own: their spread tells the error of their mean.
const PICTURES: u32 = 32;

/// Mean of all pixels and channels, and its standard error.
fn mean(scene: &Scene, plan: &Plan) -> (f64, f64) {
    let integrator = Integrator::new(scene, plan).unwrap();
    let media = integrator.media_around(scene.camera.position());
    let [width, height] = scene.camera.size();
    let radiance = |seed: u32, x: usize, y: usize, index: u32| {
        let sampling = Sampling { seed, ..scene.sampling };
        let mut sampler = PixelSampler::chosen(sampling, x, y, index);
        let ray = scene.camera.ray(x as f64 + 0.5, y as f64 + 0.5);
        f64::from(integrator.radiance(&ray, &media, &mut sampler, &mut RayCounts::default()).element_sum()) / 3.0
    };
    let of_picture = |seed: u32| {
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let samples = pixels.flat_map(|(x, y)| (0..scene.samples).map(move |index| (x, y, index)));
        samples.map(|(x, y, index)| radiance(seed, x, y, index)).sum::<f64>() / (width * height) as f64
    };
    let means: Vec<f64> = (1..=PICTURES).map(|seed| of_picture(seed) / f64::from(scene.samples)).collect();
    let count = f64::from(PICTURES);
    let mean = means.iter().sum::<f64>() / count;
    let variance = means.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / (count - 1.0);
    (mean, (variance / count).sqrt())
}

/// An error says by how many standard errors the means of both are apart, if that is more than four.
fn differs_from_textbook(mut scene: Scene, what: &str) -> Option<String> {
    let plan = Plan::new(&scene);
    assert_eq!(plan.wing, Wing::Guided, "{what}");
    let (guided, error) = mean(&scene, &plan);
    let plan = scenes::textbook_plan(&mut scene);
    let (textbook, other) = mean(&scene, &plan);
    let apart = (guided - textbook).abs() / error.hypot(other);
    (apart > 4.0)
        .then(|| format!("{what}: {guided} +- {error} and {textbook} +- {other}, {apart:.1} standard errors apart"))
}

#[test]
fn every_guided_scene_of_the_lessons_has_the_mean_of_the_textbook() {
    let guided = |scene: &Scene| scene.integrator.kind == IntegratorKind::Path && Plan::new(scene).wing == Wing::Guided;
    let lessons: Vec<_> = scenes::of_lessons().into_iter().filter(|(_, scene)| guided(scene)).collect();
    let wrong: Vec<String> = lessons
        .into_iter()
        .filter_map(|(file, scene)| differs_from_textbook(scene, &file.display().to_string()))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn random_scenes_have_the_mean_of_the_textbook() {
    let seeds = (0..).filter(|&seed| Plan::new(&scenes::random_focusing(seed)).wing == Wing::Guided);
    let seeds: Vec<u64> = seeds.take(scenes::RANDOM_SCENES as usize).collect();
    let differs = |&seed: &u64| differs_from_textbook(scenes::random_focusing(seed), &format!("scene {seed}"));
    let wrong: Vec<String> = seeds.par_iter().filter_map(differs).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
