//! Light along single rays, against closed forms.

use clap::ValueEnum;
use glam::{DVec3, Vec3};
use skycube::picture::{Raster, WriteOptions, write};
use skycube::scene::{Scene, Strategy};

use crate::support::*;

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
        for strategy in
            Strategy::value_variants().iter().copied().filter(|&strategy| !rare || strategy != Strategy::Light)
        {
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

/// Direct light of an emissive shape on a white Lambert floor at the origin, in each strategy.
fn assert_shows_light(shapes: &str, expected: f64) {
    for strategy in Strategy::value_variants().iter().copied() {
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
fn emissive_shapes_light_a_floor_as_their_form_factors_say() {
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

#[test]
fn a_texel_that_is_no_number_harms_its_own_pixels_alone() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("texels.exr");
    let mut raster = Raster::filled(4, 4, Vec3::splat(0.5));
    raster.pixels_mut()[5] = Vec3::new(f32::INFINITY, 0.5, 0.5);
    raster.pixels_mut()[10] = Vec3::NAN;
    write(&raster, &file, &WriteOptions::default()).unwrap();
    let scene = scene(&format!(
        "environment = {{ kind = \"gradient\", zenith = [0.3, 0.5, 0.9], horizon = 0.6, nadir = 0.1 }}\n\
         camera = {{ position = [0, -0.01, 4], target = [0, 0, 0], size = [16, 16], samples = 2 }}\n\
         materials.floor = {{ kind = \"lambert\", colour = {{ image = \"{}\" }} }}\n\
         shapes = [{{ kind = \"rectangle\", size = [2, 2], material = \"floor\" }}]\n",
        file.display()
    ));
    let raster = rendering(&scene).raster;
    let finite = raster.pixels().iter().filter(|pixel| pixel.is_finite()).count();
    assert!((128..256).contains(&finite), "{finite}");
}
