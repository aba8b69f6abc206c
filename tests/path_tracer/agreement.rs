//! Pictures agree, however they were computed.

use std::path::Path;

use skycube::render::{Budget, Renderer, Silent, render_progressively};
use skycube::sampling::SamplerKind;
use skycube::scene::{Caustics, IntegratorKind, Plan, Scene, Strategy};

use crate::support::*;

#[test]
fn strategies_samplers_and_filters_agree() {
    let mut scene = scene(MIXED);
    let (expected, error) = mean_of_pictures(&mut scene, 12);
    let check = |change: &dyn Fn(&mut Scene), what: &str| {
        let mut changed =
            Scene::from_text(&format!("integrator = {{ kind = \"path\", depth = 64 }}\n{MIXED}"), Path::new("t"))
                .unwrap();
        change(&mut changed);
        let (mean, other) = mean_of_pictures(&mut changed, 12);
        let tolerance = 4.0 * (error * error + other * other).sqrt();
        assert!((mean - expected).abs() <= tolerance, "{what}: {mean} and {expected} differ by more than {tolerance}");
    };
    check(&|scene| scene.integrator.strategy = Strategy::Bsdf, "bsdf");
    check(&|scene| scene.integrator.strategy = Strategy::Light, "light");
    check(&|scene| scene.integrator.caustics = Caustics::Off, "caustics off");
    check(&|scene| scene.sampling.sampler = SamplerKind::Independent, "independent");
    check(&|scene| scene.integrator.weight_cutoff = 0.0, "no roulette");
}

#[test]
fn mirrors_and_glass_alone_look_as_whitted_shows_them() {
    let text = MIXED
        .replace("material = \"floor\"", "material = \"mirror\"")
        .replace("material = \"metal\"", "material = \"glass\"");
    let text = text.replace("material = \"lamp\"", "material = \"mirror\"");
    let mut path = scene(&text);
    path.integrator.depth = 20;
    let (mean, error) = mean_of_pictures(&mut path, 12);
    path.integrator.kind = IntegratorKind::Whitted;
    path.integrator.weight_cutoff = 0.0;
    let (whitted, other) = mean_of_pictures(&mut path, 4);
    assert!((mean - whitted).abs() <= 4.0 * error.hypot(other), "{mean} +- {error}, {whitted} +- {other}");
}

#[test]
fn passes_and_threads_do_not_change_the_picture() {
    let mut scene = scene(MIXED);
    scene.samples = 11;
    let plan = Plan::new(&scene);
    let whole = rendering(&scene).raster;
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let passes = pool.install(|| {
            render_progressively(Renderer::new(&scene, &plan).unwrap(), Budget::Samples(11), &Silent).unwrap()
        });
        assert_eq!(passes.raster, whole, "{threads} threads");
    }
}
