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

/// True if paths of the scene are guided, after a look at its light, too.
fn is_guided(scene: &Scene) -> bool {
    Integrator::new(scene, &Plan::new(scene)).unwrap().wing() == Wing::Guided
}

/// What is wrong if the means of both are more than four standard errors apart, or if these are more than `telling` of the
/// mean: then the comparison would say nothing.
fn differs_from_textbook(mut scene: Scene, telling: f64, what: &str) -> Option<String> {
    let plan = Plan::new(&scene);
    let (guided, error) = mean(&scene, &plan);
    let plan = scenes::textbook_plan(&mut scene);
    let (textbook, other) = mean(&scene, &plan);
    let apart = (guided - textbook).abs() / error.hypot(other);
    let told = 4.0 * error.hypot(other) < telling * textbook;
    (apart > 4.0 || !told)
        .then(|| format!("{what}: {guided} +- {error} and {textbook} +- {other}, {apart:.1} standard errors apart"))
}

#[test]
fn every_guided_scene_of_the_lessons_has_the_mean_of_the_textbook() {
    let lessons = scenes::of_lessons().into_iter().filter(|(_, scene)| scene.integrator.kind == IntegratorKind::Path);
    let guided: Vec<_> = lessons.filter(|(_, scene)| is_guided(scene)).collect();
    assert!(guided.len() >= 3, "{}", guided.len());
    let differs = |(file, mut scene): (std::path::PathBuf, Scene)| {
        // Small lamps behind glass: chance finds them rarely.
        scene.samples = 64;
        differs_from_textbook(scene, 0.2, &file.display().to_string())
    };
    let wrong: Vec<String> = guided.into_par_iter().filter_map(differs).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn random_scenes_have_the_mean_of_the_textbook() {
    let guided = (0..).filter(|&seed| is_guided(&scenes::random_focusing(seed)));
    let seeds: Vec<u64> = guided.take(scenes::RANDOM_SCENES as usize).collect();
    let differs = |&seed: &u64| differs_from_textbook(scenes::random_focusing(seed), 0.1, &format!("scene {seed}"));
    let wrong: Vec<String> = seeds.par_iter().filter_map(differs).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
