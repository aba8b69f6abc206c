//! Every kind of environment: what is drawn, with which density, and what it adds up to.

use std::f64::consts::PI;

use skycube::colour::luminance;
use skycube::envmap::{CubeFilter, Environment, EnvironmentKind, EnvironmentSampler, SignedAxis};
use skycube::math::{DVec3, Vec3};
use skycube::stress::Random;

use crate::histogram::deviation;
use crate::maps::{cube, environment, gradient, lookups, noise, noise_cube, panorama};
use crate::support::{cube_bin, cube_integrals, mean_and_error, stratified};

const FILTERS: [CubeFilter; 3] = [CubeFilter::Nearest, CubeFilter::Bilinear, CubeFilter::Seamless];

/// Environments with the bins per side of the cube for which midpoints integrate the density well, and the error that
/// is left.
fn environments() -> Vec<(String, Environment, usize, f64)> {
    let mut all = Vec::new();
    for (name, lookup) in lookups() {
        for filter in FILTERS {
            all.push((format!("{name}, {filter:?}"), noise_cube(8, lookup, filter), 8, 1e-9));
        }
    }
    for size in [1, 2, 3] {
        for filter in FILTERS {
            let lookup = lookups()[2].1;
            all.push((format!("{size} texels, {filter:?}"), noise_cube(size, lookup, filter), 6, 1e-9));
        }
    }
    for (up, turns) in [(SignedAxis::POS_Z, 0.0), (SignedAxis::NEG_Y, 0.3), (SignedAxis::POS_X, 0.8)] {
        let mut texel = noise(5);
        all.push((format!("panorama {up}"), panorama(16, 8, up, turns, |_, _| texel()), 12, 5e-3));
    }
    for greys in [[1.0, 2.0, 3.0], [5.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        all.push((format!("gradient {greys:?}"), gradient(SignedAxis::NEG_Y, greys), 12, 1e-3));
    }
    all.push(("constant".to_owned(), environment(EnvironmentKind::Constant(Vec3::new(0.2, 0.5, 0.1))), 6, 1e-3));
    all
}

#[test]
fn densities_integrate_to_one() {
    for (name, environment, side, error) in environments() {
        let sampler = EnvironmentSampler::new(&environment).unwrap();
        let sum: f64 = cube_integrals(side, 24, |direction| sampler.density(direction)).iter().sum();
        assert!((sum - 1.0).abs() < error, "{name}: {sum}");
    }
}

#[test]
fn samples_follow_the_density() {
    for (name, environment, side, _) in environments() {
        let sampler = EnvironmentSampler::new(&environment).unwrap();
        let mut random = Random(3);
        let mut counts = vec![0; 6 * side * side];
        let samples = 100_000;
        for _ in 0..samples {
            let (direction, density) = sampler.sample([random.unit(), random.unit()]).unwrap();
            assert!((direction.length() - 1.0).abs() < 1e-14);
            let told = sampler.density(direction);
            assert!((told - density).abs() <= 1e-9 * density, "{name}: {direction}: {density} drawn, {told} told");
            counts[cube_bin(direction, side)] += 1;
        }
        let mut expected = cube_integrals(side, 48, |direction| sampler.density(direction));
        expected.iter_mut().for_each(|share| *share *= f64::from(samples));
        let deviation = deviation(&counts, &expected);
        assert!(deviation < 4.0, "{name}: {deviation} standard deviations");
    }
}

#[test]
fn means_are_the_integral_of_the_luminance() {
    for (name, environment, side, _) in environments() {
        let sampler = EnvironmentSampler::new(&environment).unwrap();
        let light = |direction: DVec3| f64::from(luminance(environment.radiance(direction)));
        let integral: f64 = cube_integrals(side, 40, light).iter().sum();
        let mut random = Random(9);
        let values: Vec<f64> = (0..40_000)
            .map(|_| sampler.sample([random.unit(), random.unit()]).unwrap())
            .map(|(direction, density)| light(direction) / density)
            .collect();
        let (mean, error) = mean_and_error(&values);
        // What is allowed beside the standard error: that of the integral.
        assert!((mean - integral).abs() < 3.0 * error + 1e-3 * integral, "{name}: {mean} +- {error}, {integral}");
        // The power takes texels for small.
        assert!((sampler.power() / integral - 1.0).abs() < 0.12, "{name}: power {} of {integral}", sampler.power());
    }
}

#[test]
fn wherever_there_is_light_directions_are_drawn() {
    let mut random = Random(21);
    for (name, environment, ..) in environments() {
        let sampler = EnvironmentSampler::new(&environment).unwrap();
        for _ in 0..20_000 {
            let direction = random.direction();
            let lit = environment.radiance(direction) != Vec3::ZERO;
            assert!(!lit || sampler.density(direction) > 0.0, "{name}: {direction}");
        }
    }
}

#[test]
fn black_environments_give_nothing() {
    let dark = cube(4, lookups()[0].1, CubeFilter::Bilinear, |_, _, _| Vec3::ZERO);
    let off = Environment { scale: 0.0, ..noise_cube(4, lookups()[0].1, CubeFilter::Bilinear) };
    let panorama = panorama(4, 2, SignedAxis::POS_Z, 0.0, |_, _| Vec3::ZERO);
    for environment in [dark, off, panorama, Environment::BLACK] {
        let sampler = EnvironmentSampler::new(&environment).unwrap();
        assert_eq!(sampler.sample([0.3, 0.7]), None);
        assert_eq!((sampler.density(DVec3::X), sampler.power()), (0.0, 0.0));
    }
}

#[test]
fn colours_that_are_no_numbers_or_negative_do_no_harm() {
    let odd = [Vec3::splat(f32::NAN), Vec3::splat(f32::INFINITY), Vec3::new(1.0, -0.5, 0.0), Vec3::ONE];
    let environment = cube(2, lookups()[0].1, CubeFilter::Nearest, |_, x, y| odd[2 * y + x]);
    let sampler = EnvironmentSampler::new(&environment).unwrap();
    let sum: f64 = cube_integrals(2, 8, |direction| sampler.density(direction)).iter().sum();
    assert!((sum - 1.0).abs() < 1e-9 && sampler.power().is_finite());
    // Red light with a negative green, whose luminance is below 0.
    assert!(sampler.density(DVec3::new(1.0, -0.5, 0.5).normalize()) > 0.0);
}

#[test]
fn a_picture_that_cannot_be_decoded_is_an_error() {
    use skycube::envmap::{CubeMap, LazyImage};
    let images = std::array::from_fn(|_| LazyImage::new(Box::new(|| Err(skycube::error::Error::new("damaged")))));
    let map = CubeMap::new(images, lookups()[0].1, CubeFilter::Bilinear);
    let error = EnvironmentSampler::new(&environment(EnvironmentKind::CubeMap(Box::new(map)))).unwrap_err();
    assert!(error.problem().contains("damaged"));
}

#[test]
fn a_scale_counts_in_the_power_alone() {
    let plain = EnvironmentSampler::new(&environment(EnvironmentKind::Constant(Vec3::ONE))).unwrap();
    let scaled = EnvironmentKind::Constant(Vec3::ONE);
    let scaled = EnvironmentSampler::new(&Environment { kind: scaled, scale: 3.0 }).unwrap();
    assert!((plain.power() - 4.0 * PI).abs() < 1e-5 && (scaled.power() - 12.0 * PI).abs() < 1e-5);
    assert!((plain.concentration() - 0.001).abs() < 1e-9);
    assert_eq!(plain.density(DVec3::X), scaled.density(DVec3::X));
}

/// By how much the variance of a mean over 64 x 64 strata is smaller than that of as many independent samples.
fn gain_of_strata(environment: &Environment) -> f64 {
    let sampler = EnvironmentSampler::new(environment).unwrap();
    let mut random = Random(7);
    let mut variance = |in_strata: bool| {
        let mut mean = || {
            let place =
                |index| if in_strata { stratified(index, 64, &mut random) } else { [random.unit(), random.unit()] };
            (0..4096).map(place).map(|place| sampler.sample(place).unwrap().0.z).sum::<f64>() / 4096.0
        };
        let means: Vec<f64> = (0..40).map(|_| mean()).collect();
        mean_and_error(&means).1.powi(2)
    };
    variance(false) / variance(true)
}

#[test]
fn strata_are_kept() {
    let hill = |x: usize, width: usize| (x * (width - 1 - x)) as f32 / (width * width) as f32;
    let panorama = panorama(32, 16, SignedAxis::POS_X, 0.0, |x, y| Vec3::splat(0.2 + hill(x, 32) + hill(y, 16)));
    let gain = gain_of_strata(&panorama);
    assert!(gain > 200.0, "panorama: {gain}");
    // In five of the 64 rows of strata one face ends and the next begins: there nothing is won, so the gain is about
    // 64 / 5 = 13. Without strata it would be 1.
    let cube = cube(16, lookups()[2].1, CubeFilter::Bilinear, |_, x, y| Vec3::splat(0.2 + hill(x, 16) + hill(y, 16)));
    let gain = gain_of_strata(&cube);
    assert!(gain > 8.0, "cube: {gain}");
}
