//! Pixels, lens, layers and plan.

use clap::ValueEnum;
use glam::Vec3;
use skycube::render::{Renderer, Silent};
use skycube::sampling::{PixelFilter, SamplerKind, Sampling};
use skycube::scene::Plan;

use crate::support::*;

#[test]
fn an_even_picture_is_even_under_every_filter() {
    for filter in PixelFilter::value_variants().iter().copied() {
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
    // Half the picture is 0.5 at distance 1: 64 pixels per unit.
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
fn the_variance_layer_predicts_the_error_of_independent_samples() {
    // Without glass and mirrors: rare bright samples would need more pictures than a test has time for.
    let diffuse = MIXED
        .replace("\"glass\"", "\"floor\"")
        .replace("\"mirror\"", "\"floor\"")
        .replace("kind = \"floor\"", "kind = \"mirror\"");
    let mut scene = scene(&diffuse);
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
    no point, spot or directional light: no shadow rays to them
    no emissive shape, no environment, or only mirrors and smooth glass: no shadow rays to area lights and environment
    no shadow rays to area lights and environment: no photon pass
    no glass: no refracted rays, no media
    no environment picture: nothing to decode
    1 shape, too few: no hierarchy over them
    ");
    let matt = "materials.a = { kind = \"lambert\", colour = 1 }\nshapes = [{ kind = \"sphere\", material = \"a\" }]\n";
    insta::assert_snapshot!(left_out(matt), @r"
    no point, spot or directional light: no shadow rays to them
    no emissive shape, no environment, or only mirrors and smooth glass: no shadow rays to area lights and environment
    no shadow rays to area lights and environment: no photon pass
    no glass: no refracted rays, no media
    no environment picture: nothing to decode
    1 shape, too few: no hierarchy over them
    ");
    insta::assert_snapshot!(left_out(&format!("{FURNACE}{matt}")), @r"
    no point, spot or directional light: no shadow rays to them
    no mirrors or smooth glass beside other surfaces: no photon pass
    no glass: no refracted rays, no media
    no environment picture: nothing to decode
    1 shape, too few: no hierarchy over them
    ");
    let counts = rendering(&scene(&format!("{FURNACE}{mirror}"))).counts;
    assert_eq!((counts.shadow, counts.refracted), (0, 0));
}
