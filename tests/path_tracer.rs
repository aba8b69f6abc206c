//! The path tracer against closed forms and against itself: its strategies, its caustics, its samplers must agree.

use std::path::Path;

use glam::{DVec3, Vec3};
use skycube::integrators::{Integrator, RayCounts};
use skycube::math::Ray;
use skycube::render::{Budget, Renderer, Rendering, Silent, render, render_progressively};
use skycube::sampling::{PixelFilter, PixelSampler, SamplerKind, Sampling};
use skycube::scene::{Caustics, IntegratorKind, Plan, Scene, Strategy};

fn scene(text: &str) -> Scene {
    let head = "integrator = { kind = \"path\", depth = 64 }\n";
    let camera = "camera = { position = [0, -5, 1], target = [0, 0, 0], size = [48, 32] }\n";
    let camera = if text.contains("camera = ") { "" } else { camera };
    let head = if text.contains("integrator = ") { "" } else { head };
    Scene::from_text(&format!("{head}{camera}{text}"), Path::new("test.toml")).unwrap_or_else(|error| panic!("{error}"))
}

fn rendering(scene: &Scene) -> Rendering {
    render(scene, &Plan::new(scene), &Silent).unwrap()
}

/// Mean radiance along one ray and its standard error, by independent samples.
fn along(scene: &Scene, origin: DVec3, direction: DVec3, samples: u32) -> (f64, f64) {
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

fn assert_agrees((mean, error): (f64, f64), expected: f64, what: &str) {
    assert!((mean - expected).abs() <= 4.0 * error + 1e-5, "{what}: {mean} +- {error}, expected {expected}");
}

const FURNACE: &str = "environment = { kind = \"constant\", radiance = 1 }\n";

#[test]
fn a_white_furnace_stays_white_whatever_stands_in_it() {
    let mut materials = vec![
        "kind = \"lambert\", colour = 1".to_owned(),
        "kind = \"mirror\", colour = 1".to_owned(),
        "kind = \"glass\"".to_owned(),
    ];
    for roughness in ["0.0001", "0.003", "0.03", "0.1", "0.3", "0.6", "1"] {
        materials.push(format!("kind = \"metal\", reflectance = 1, roughness = {roughness}"));
        materials.push(format!("kind = \"glass\", roughness = {roughness}"));
        materials.push(format!("kind = \"coated\", colour = 1, roughness = {roughness}"));
    }
    for material in materials {
        // Rays to lights alone find a sharp lobe, or a way through glass, too rarely for their spread to tell how rarely.
        let sharp =
            ["0.0001", "0.003", "0.03", "0.1"].iter().any(|roughness| material.ends_with(&format!("= {roughness}")));
        let rare = sharp || material.starts_with("kind = \"glass\"");
        for strategy in Strategy::ALL.into_iter().filter(|&strategy| !rare || strategy != Strategy::Light) {
            // A sphere shows every angle; light goes through rough glass many times.
            let text = format!(
                "{FURNACE}materials.a = {{ {material} }}\nshapes = [{{ kind = \"sphere\", material = \"a\" }}]\n"
            );
            let mut scene = scene(&text);
            scene.integrator.strategy = strategy;
            // Light that grazes glass from within goes round for very long.
            scene.integrator.depth = 200_000;
            for height in [0.0, 0.6, 0.95, 0.999] {
                let shown = along(&scene, DVec3::new(height, -5.0, 0.0), DVec3::Y, 4000);
                // A table that keeps the energy to 1e-4 at every scattering may add up over a few of them.
                let (mean, error) = shown;
                assert!(
                    (mean - 1.0).abs() <= 3.0 * error + 1e-3,
                    "{material} {strategy:?} at {height}: {mean} +- {error}"
                );
            }
        }
    }
}

/// Direct light of a shining shape on a white Lambert floor at the origin, in each strategy.
fn assert_shows_light(shapes: &str, expected: f64) {
    for strategy in Strategy::ALL {
        let text = format!(
            "materials.floor = {{ kind = \"lambert\", colour = 0.5 }}\nmaterials.light = {{ kind = \"light\", radiance = 3 }}\n\
             shapes = [{{ kind = \"plane\", material = \"floor\" }}, {shapes}]\n"
        );
        let mut scene = scene(&text);
        scene.integrator.depth = 1;
        scene.integrator.strategy = strategy;
        let samples = if strategy == Strategy::Bsdf { 400_000 } else { 40_000 };
        let shown = along(&scene, DVec3::new(0.4, -0.3, 0.2), DVec3::new(-0.4, 0.3, -0.2), samples);
        assert_agrees(shown, expected, &format!("{shapes} {strategy:?}"));
    }
}

#[test]
fn shining_shapes_light_a_floor_as_their_form_factors_say() {
    let (albedo, radiance) = (0.5, 3.0);
    // A sphere of radius r straight above at the distance d: E = pi L (r / d)^2.
    assert_shows_light(
        "{ kind = \"sphere\", centre = [0, 0, 2], radius = 0.5, material = \"light\" }",
        albedo * radiance * 0.0625,
    );
    // A disc that faces the floor: E = pi L r^2 / (r^2 + d^2).
    assert_shows_light(
        "{ kind = \"disc\", centre = [0, 0, 2], normal = [0, 0, -1], radius = 1, material = \"light\" }",
        albedo * radiance / 5.0,
    );
    // A rectangle of half sides a, b at the distance d: four times the form factor of a corner (Siegel and Howell).
    let (a, b): (f64, f64) = (0.5 / 1.5, 1.0 / 1.5);
    let part = |a: f64, b: f64| a / (1.0 + a * a).sqrt() * (b / (1.0 + a * a).sqrt()).atan();
    let factor = 4.0 * (part(a, b) + part(b, a)) / std::f64::consts::TAU;
    assert_shows_light(
        "{ kind = \"rectangle\", centre = [0, 0, 1.5], normal = [0, 0, -1], size = [1, 2], material = \"light\" }",
        albedo * radiance * factor,
    );
}

#[test]
fn lights_shine_on_their_front_side_only() {
    let text = "materials.light = { kind = \"light\", radiance = 3 }\n\
                shapes = [{ kind = \"rectangle\", normal = [0, -1, 0], size = [9, 9], material = \"light\" }]\n";
    let scene = scene(text);
    assert_eq!(along(&scene, DVec3::new(0.0, -5.0, 0.0), DVec3::Y, 8).0, 3.0);
    assert_eq!(along(&scene, DVec3::new(0.0, 5.0, 0.0), DVec3::NEG_Y, 8).0, 0.0);
}

#[test]
fn the_depth_limit_counts_the_surfaces_that_light_meets() {
    // Between two facing mirrors of colour 1/2 the ray meets the upper one at x = -0.95, the lower one at 0.05, the upper one
    // at 1.05, and leaves at 2.05: three of them.
    let mut scene = scene(
        "environment = { kind = \"constant\", radiance = 1 }\nmaterials.m = { kind = \"mirror\", colour = 0.5 }\n\
         shapes = [{ kind = \"disc\", centre = [0, 0, -1], radius = 2, material = \"m\" },\n\
                   { kind = \"disc\", centre = [0, 0, 1], normal = [0, 0, -1], radius = 2, material = \"m\" }]\n",
    );
    let shown = |scene: &Scene| along(scene, DVec3::new(-1.9, 0.0, -0.9), DVec3::new(0.5, 0.0, 1.0), 16).0;
    assert_eq!(shown(&scene), 0.125);
    scene.integrator.depth = 3;
    assert_eq!(shown(&scene), 0.125);
    scene.integrator.depth = 2;
    assert_eq!(shown(&scene), 0.0);
}

/// Mean of a picture's pixels, all channels, and its standard error from pictures with other seeds.
fn mean_of_pictures(scene: &mut Scene, pictures: u32) -> (f64, f64) {
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
const MIXED: &str = "
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

#[test]
fn an_even_picture_is_even_under_every_filter() {
    for filter in PixelFilter::ALL {
        let mut scene = scene(FURNACE);
        scene.sampling.filter = filter;
        scene.samples = 7;
        for pixel in rendering(&scene).raster.pixels() {
            assert!((*pixel - Vec3::ONE).abs().max_element() < 1e-6, "{filter:?} {pixel}");
        }
    }
}

#[test]
fn a_point_out_of_focus_is_spread_over_the_disc_that_the_lens_casts() {
    // A far small light, focus at 2: the disc of confusion has the radius r |1/f - 1/d| d as an angle... seen on the plane at
    // distance 1: aperture / 2 * (1/2 - 1/10).
    let text = "camera = { position = [0, 0, 0], target = [0, 10, 0], size = [64, 64], field_of_view = 53.13010235415598, \
                samples = 256, aperture = 1, focus = 2 }\n\
                materials.lamp = { kind = \"light\", radiance = 1000 }\n\
                shapes = [{ kind = \"sphere\", centre = [0, 10, 0], radius = 0.05, material = \"lamp\" }]\n";
    let raster = rendering(&scene(text)).raster;
    // Half the picture is 0.5 at distance 1: 64 pixels a unit.
    let radius = 0.5 * (0.5 - 0.1) * 64.0;
    for y in 0..64 {
        for x in 0..64 {
            let distance = (x as f64 - 31.5).hypot(y as f64 - 31.5);
            let lit = raster.pixel(x, y) != Vec3::ZERO;
            assert!(!lit || distance < radius + 2.0, "{x} {y} lies outside of the disc");
        }
    }
    // The disc is evenly lit: the inner half of its area has half of the light.
    let within = |limit: f64| -> f64 {
        let inside = |index: &usize| ((index % 64) as f64 - 31.5).hypot((index / 64) as f64 - 31.5) < limit;
        (0..64 * 64).filter(inside).map(|index| f64::from(raster.pixels()[index].x)).sum()
    };
    let share = within(radius / std::f64::consts::SQRT_2) / within(64.0);
    assert!((share - 0.5).abs() < 0.05, "{share}");
}

#[test]
fn layers_hold_what_the_camera_meets_first() {
    let scene = scene(
        "materials.a = { kind = \"lambert\", colour = [0.1, 0.2, 0.3] }\n\
         shapes = [{ kind = \"rectangle\", normal = [0, -1, 0], size = [1, 9], material = \"a\" }]\n\
         camera = { position = [0, -5, 0], target = [0, 0, 0], size = [9, 9] }\n",
    );
    let plan = Plan::new(&scene);
    let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
    renderer.add_samples(1, &Silent).unwrap();
    let layers = renderer.rendering(false).layers.unwrap();
    assert_eq!(layers.normal.pixel(4, 4), Vec3::NEG_Y);
    assert_eq!(layers.albedo.pixel(4, 4), Vec3::new(0.1, 0.2, 0.3));
    assert_eq!(layers.depth.pixel(4, 4), Vec3::splat(5.0));
    assert_eq!(layers.depth.pixel(0, 4), Vec3::INFINITY);
    assert!(rendering(&scene).layers.is_none());
}

#[test]
fn the_variance_layer_foretells_the_error_of_independent_samples() {
    // Without glass and mirrors: rare bright samples would need more pictures than a test has time for.
    let dull = MIXED
        .replace("\"glass\"", "\"floor\"")
        .replace("\"mirror\"", "\"floor\"")
        .replace("kind = \"floor\"", "kind = \"mirror\"");
    let mut scene = scene(&dull);
    let plan = Plan::new(&scene);
    let independent = |seed| Sampling { sampler: SamplerKind::Independent, seed, ..Sampling::default() };
    scene.sampling = independent(1);
    let variance = {
        let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
        renderer.add_samples(256, &Silent).unwrap();
        renderer.rendering(false).layers.unwrap().variance
    };
    let mut picture = |seed| {
        scene.sampling = independent(seed);
        rendering(&scene).raster
    };
    // The floor in front, far from all edges: the squared difference of two pictures of 16 samples is twice the variance.
    let floor = |index: &usize| index / 32 > 18 && (2..30).contains(&(index % 32));
    let (mut foretold, mut found) = (0.0, 0.0);
    for seed in 0..8 {
        let (one, other) = (picture(2 * seed + 100), picture(2 * seed + 101));
        for index in (0..32 * 24).filter(floor) {
            foretold += 2.0 * 16.0 * f64::from(variance.pixels()[index].y);
            let difference = f64::from(one.pixels()[index].y - other.pixels()[index].y);
            found += difference * difference;
        }
    }
    assert!((found / foretold - 1.0).abs() < 0.25, "{found} {foretold}");
}

#[test]
fn the_plan_of_the_path_tracer_leaves_out_what_the_scene_does_not_need() {
    let left_out = |text: &str| {
        let scene = scene(text);
        Plan::new(&scene).left_out(&scene).join("\n")
    };
    let mirror = "materials.a = { kind = \"mirror\" }\nshapes = [{ kind = \"sphere\", material = \"a\" }]\n";
    insta::assert_snapshot!(left_out(&format!("{FURNACE}{mirror}")), @r"
    no point, spot or directional light: no rays to such
    no shining shape, no environment, or nothing but mirrors and smooth glass: no rays sent to lights with an extent
    no mirror and no smooth glass beside other surfaces: no light sent ahead to find caustics
    no glass: no refracted rays, no media
    no environment picture: nothing decoded
    1 shape (at most 4 with bounds): no hierarchy over them
    ");
    let matt = "materials.a = { kind = \"lambert\", colour = 1 }\nshapes = [{ kind = \"sphere\", material = \"a\" }]\n";
    insta::assert_snapshot!(left_out(matt), @r"
    no point, spot or directional light: no rays to such
    no shining shape, no environment, or nothing but mirrors and smooth glass: no rays sent to lights with an extent
    no mirror and no smooth glass beside other surfaces: no light sent ahead to find caustics
    no glass: no refracted rays, no media
    no environment picture: nothing decoded
    1 shape (at most 4 with bounds): no hierarchy over them
    ");
    insta::assert_snapshot!(left_out(&format!("{FURNACE}{matt}")), @r"
    no point, spot or directional light: no rays to such
    no mirror and no smooth glass beside other surfaces: no light sent ahead to find caustics
    no glass: no refracted rays, no media
    no environment picture: nothing decoded
    1 shape (at most 4 with bounds): no hierarchy over them
    ");
    let counts = rendering(&scene(&format!("{FURNACE}{mirror}"))).counts;
    assert_eq!((counts.shadow, counts.refracted), (0, 0));
}
