//! What the open environment throws onto a plane.

use std::f64::consts::PI;

use skycube::envmap::{CubeFilter, Environment, EnvironmentKind, SignedAxis};
use skycube::math::{DVec3, Vec3};

use crate::maps::{environment, gradient, lookups, noise, noise_cube, panorama};
use crate::support::cube_integrals;

const NORMALS: [DVec3; 3] = [DVec3::Z, DVec3::new(0.48, -0.64, 0.6), DVec3::new(-0.8, 0.0, -0.6)];

/// Channel y of front and back, by summing over a fine grid of directions.
fn summed(environment: &Environment, normal: DVec3, side: usize) -> [f64; 2] {
    [normal, -normal].map(|normal| {
        let light = |direction: DVec3| f64::from(environment.radiance(direction).y) * direction.dot(normal).max(0.0);
        cube_integrals(side, 1, light).iter().sum()
    })
}

fn assert_agrees(environment: &Environment, side: usize, tolerance: f64, name: &str) {
    for normal in NORMALS {
        let irradiance = environment.irradiance(normal).unwrap();
        let expected = summed(environment, normal, side);
        for (found, expected) in [irradiance.front, irradiance.back].into_iter().zip(expected) {
            let difference = (f64::from(found.y) / expected - 1.0).abs();
            assert!(difference < tolerance, "{name}, normal {normal}: {} and {expected}", found.y);
        }
    }
}

#[test]
fn closed_forms() {
    let even = environment(EnvironmentKind::Constant(Vec3::new(0.2, 0.5, 0.1)));
    assert_eq!(even.irradiance(DVec3::Y).unwrap().back, Vec3::new(0.2, 0.5, 0.1) * PI as f32);
    // Over the horizontal: the integral of the cosine times h + (z - h) cosine, pi h + 2/3 pi (z - h).
    let irradiance = gradient(SignedAxis::POS_Z, [1.0, 2.0, 4.0]).irradiance(DVec3::Z).unwrap();
    // Channel y is half the grey: 0.5, 1 and 2.
    let over = |end: f32| PI as f32 * (1.0 + (end - 1.0) * 2.0 / 3.0);
    let (found, expected) = ([irradiance.front.y, irradiance.back.y], [over(0.5), over(2.0)]);
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
    }
}

#[test]
fn cube_maps_of_any_size_lookup_and_filter() {
    for (name, lookup) in lookups() {
        for filter in [CubeFilter::Nearest, CubeFilter::Bilinear, CubeFilter::Seamless] {
            // With three times as many directions on a side the two agree to 1e-5.
            assert_agrees(&noise_cube(8, lookup, filter), 256, 2e-5, &format!("{name}, {filter:?}"));
        }
    }
    let lookup = lookups()[1].1;
    for size in [1, 3, 48] {
        assert_agrees(&noise_cube(size, lookup, CubeFilter::Bilinear), 288, 2e-5, &format!("{size} texels"));
    }
    // As large that the texels are read themselves.
    assert_agrees(&noise_cube(768, lookup, CubeFilter::Nearest), 768, 1e-5, "768 texels");
}

#[test]
fn panoramas_and_gradients() {
    for (up, turns) in [(SignedAxis::POS_Z, 0.0), (SignedAxis::NEG_Y, 0.3), (SignedAxis::POS_X, 0.8)] {
        for (width, height) in [(16, 8), (1, 1)] {
            let mut texel = noise(5);
            let map = panorama(width, height, up, turns, |_, _| texel());
            assert_agrees(&map, 384, 2e-4, &format!("panorama {up}, {width} x {height}"));
        }
        // As large that the texels are read themselves: a pattern that the sum over directions can follow.
        let stripes = |x: usize, y: usize| Vec3::splat(((x / 64 + y / 32) % 3) as f32);
        assert_agrees(&panorama(1024, 512, up, turns, stripes), 384, 5e-4, &format!("panorama {up}, stripes"));
    }
    assert_agrees(&gradient(SignedAxis::NEG_Y, [5.0, 0.5, 1.0]), 256, 2e-5, "gradient");
}

#[test]
fn the_scale_counts() {
    let mut map = noise_cube(8, lookups()[0].1, CubeFilter::Bilinear);
    let once = map.irradiance(DVec3::X).unwrap();
    map.scale = 3.0;
    let thrice = map.irradiance(DVec3::X).unwrap();
    assert!((thrice.front / once.front - 3.0).abs().max_element() < 1e-5);
}
