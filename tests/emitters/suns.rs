//! Suns: one bright spot in a dim sky.

use std::f64::consts::PI;

use skycube::colour::luminance;
use skycube::envmap::{CubeFilter, EnvironmentSampler, SignedAxis};
use skycube::math::{DVec3, Vec3};
use skycube::stress::Random;

use crate::maps::{cube, lookups, panorama};
use crate::support::{cube_integrals, mean_and_error};

#[test]
fn one_bright_texel_is_drawn_nearly_always() {
    let size = 64;
    for (name, lookup) in lookups() {
        // Image posx, 21st column, 41st row.
        let sunlit = |image, x, y| Vec3::splat(if (image, x, y) == (0, 20, 40) { 1e6 } else { 1.0 });
        let environment = cube(size, lookup, CubeFilter::Nearest, sunlit);
        let sampler = EnvironmentSampler::new(&environment).unwrap();
        let mut random = Random(1);
        let mut hits = 0;
        for _ in 0..10_000 {
            let (direction, density) = sampler.sample([random.unit(), random.unit()]).unwrap();
            let radiance = f64::from(luminance(environment.radiance(direction)));
            hits += usize::from(radiance > 1.0);
            // Solid angles of the texel differ from point to point by the cube of the distance alone.
            let ratio = radiance / density / sampler.power();
            assert!((ratio - 1.0).abs() < 0.06, "{name}: {ratio}");
        }
        // The sun's texel (two of them, where two faces show the image) is 1e6 of 1e6 + 24575 or a little less.
        assert!((9_600..10_000).contains(&hits), "{name}: {hits}");
        assert!(sampler.concentration() > 0.97, "{name}: {}", sampler.concentration());
    }
}

#[test]
fn dim_directions_beside_a_sun_keep_an_honest_density() {
    // The sky is 1e-9 of the light, less than the table's resolution: still in reach and unbiased.
    let size = 16;
    let sunlit = |image, x, y| Vec3::splat(if (image, x, y) == (2, 3, 4) { 1e13 } else { 1.0 });
    let environment = cube(size, lookups()[0].1, CubeFilter::Bilinear, sunlit);
    let sampler = EnvironmentSampler::new(&environment).unwrap();
    assert!(
        cube_integrals(size, 2, |direction| f64::from(u8::from(sampler.density(direction) == 0.0)))
            .iter()
            .all(|&none| none == 0.0)
    );
    let sum: f64 = cube_integrals(size, 8, |direction| sampler.density(direction)).iter().sum();
    assert!((sum - 1.0).abs() < 1e-9);
}

#[test]
fn cells_of_several_texels_stay_exact() {
    // 1030 texels a side: more than cells. Bins of ten texels are five cells.
    let (size, side) = (1030, 103);
    let sun = |x: usize, y: usize| (x as f32 - 400.0).powi(2) + (y as f32 - 700.0).powi(2) < 9.0;
    let sunlit = |image, x, y| Vec3::splat(if image == 4 && sun(x, y) { 1e5 } else { 0.5 });
    let environment = cube(size, lookups()[2].1, CubeFilter::Bilinear, sunlit);
    let sampler = EnvironmentSampler::new(&environment).unwrap();
    let sum: f64 = cube_integrals(side, 10, |direction| sampler.density(direction)).iter().sum();
    assert!((sum - 1.0).abs() < 1e-9, "{sum}");
    let light = |direction: DVec3| f64::from(luminance(environment.radiance(direction)));
    let integral: f64 = cube_integrals(side, 20, light).iter().sum();
    let mut random = Random(2);
    let values: Vec<f64> = (0..100_000)
        .map(|_| sampler.sample([random.unit(), random.unit()]).unwrap())
        .map(|(direction, density)| light(direction) / density)
        .collect();
    let (mean, error) = mean_and_error(&values);
    assert!((mean - integral).abs() < 3.0 * error + 2e-3 * integral, "{mean} +- {error}, {integral}");
}

#[test]
fn a_sun_at_the_seam_of_a_panorama_shines_on_both_sides() {
    // The bright column is the last; the filter carries half of its light over to the first.
    let environment =
        panorama(32, 16, SignedAxis::POS_Z, 0.0, |x, y| Vec3::splat(if (x, y) == (31, 8) { 1e4 } else { 0.0 }));
    let sampler = EnvironmentSampler::new(&environment).unwrap();
    // The left border is +y, and growing u goes towards +x.
    let beyond = DVec3::new(0.05, 1.0, -0.1).normalize();
    assert!(luminance(environment.radiance(beyond)) > 0.0 && sampler.density(beyond) > 0.0);
    let mut random = Random(4);
    let (mut values, mut right) = (Vec::new(), 0);
    for _ in 0..20_000 {
        let (direction, density) = sampler.sample([random.unit(), random.unit()]).unwrap();
        right += usize::from(direction.x > 0.0);
        values.push(f64::from(luminance(environment.radiance(direction))) / density);
    }
    // An eighth of the light, (1/8 of the three columns), lies beyond the seam.
    assert!((2_300..2_700).contains(&right), "{right}");
    let (mean, error) = mean_and_error(&values);
    // Integral of the two tents: texel width times the integral over the latitude, midpoint rule.
    let width = 2.0 * PI / 32.0;
    let steps = 2000;
    let tent = |v: f64| (1.0 - (v * 16.0 - 8.5).abs()).max(0.0);
    let down: f64 = (0..steps)
        .map(|step| (f64::from(step) + 0.5) / f64::from(steps))
        .map(|v| tent(v) * (PI * v).sin() * PI / f64::from(steps))
        .sum();
    let integral = 1e4 * width * down;
    assert!((mean - integral).abs() < 3.0 * error, "{mean} +- {error}, {integral}");
}
