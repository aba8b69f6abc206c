//! The metrics against closed forms, an independent slow implementation, and their symmetries.

use proptest::prelude::*;

use super::*;
use crate::math::Vec3;
use crate::metrics::display;
use crate::picture::Raster;

fn textured(width: usize, height: usize, seed: usize) -> Raster {
    Raster::from_function(width, height, |x, y| {
        let code = |channel: usize| ((x * (7 + seed) + y * 13 + channel * 5 + x * y * seed) % 29) as f32 / 28.0;
        Vec3::new(code(0), code(1), code(2))
    })
}

#[test]
fn a_constant_difference_has_closed_forms() {
    let (dark, light) = (Raster::filled(40, 30, Vec3::splat(0.25)), Raster::filled(40, 30, Vec3::splat(0.75)));
    assert!((root_mean_square_error(&light, &dark) - 0.5).abs() < 1e-12);
    let relative = RelativeError::between(&light, &dark);
    let expected = 0.25 / (0.0625 + 0.01);
    assert!((relative.mean - expected).abs() < 1e-9 && (relative.tail - expected).abs() < 1e-9, "{relative:?}");
    let step = f64::from(display(Vec3::splat(0.75)).x - display(Vec3::splat(0.25)).x);
    assert!((peak_signal_to_noise(&light, &dark) + 20.0 * step.log10()).abs() < 1e-4);
    // Without variance only the first factor of SSIM is left.
    let [a, b] = [0.25, 0.75].map(|value| f64::from(display(Vec3::splat(value)).x));
    let expected = (2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4);
    assert!((structural_similarity(&light, &dark) - expected).abs() < 1e-3);
}

#[test]
fn equal_pictures_are_equal_in_every_measure() {
    let picture = textured(50, 40, 3);
    let (metrics, _) = Metrics::with_flip_map(&picture, &picture);
    assert_eq!((metrics.rmse, metrics.flip), (0.0, 0.0));
    assert!(metrics.psnr == f64::INFINITY && (metrics.ssim - 1.0).abs() < 1e-9, "{metrics:?}");
    assert_eq!(RelativeError::between(&picture, &picture), RelativeError { mean: 0.0, trimmed: 0.0, tail: 0.0 });
}

#[test]
fn the_tail_is_the_worst_thousandth() {
    let reference = Raster::filled(100, 50, Vec3::ONE);
    let mut picture = reference.clone();
    // Five of 5000 pixels are fireflies, and a sixth one is a little off.
    for x in 0..5 {
        picture.set(x * 7, x * 9, Vec3::splat(11.0));
    }
    picture.set(50, 20, Vec3::splat(2.0));
    let error = RelativeError::between(&picture, &reference);
    assert!((error.tail - 100.0 / 1.01).abs() < 1e-9, "{error:?}");
    assert!((error.trimmed - 1.0 / 1.01 / 4995.0).abs() < 1e-12, "{error:?}");
    assert!((error.mean - (5.0 * error.tail + 4995.0 * error.trimmed) / 5000.0).abs() < 1e-12, "{error:?}");
}

#[test]
fn what_is_not_a_number_shows() {
    let reference = textured(20, 20, 1);
    let mut picture = reference.clone();
    picture.set(3, 4, Vec3::new(f32::NAN, 0.5, 0.5));
    let (metrics, map) = Metrics::with_flip_map(&picture, &reference);
    assert!([metrics.rmse, metrics.psnr, metrics.ssim, metrics.flip].iter().all(|value| value.is_nan()), "{metrics:?}");
    assert!(map.at(3, 4).is_nan());
}

/// SSIM as its formula reads, window by window in double precision.
fn slow_similarity(a: &Raster, b: &Raster) -> f64 {
    let luma = |raster: &Raster, x: usize, y: usize| {
        let code = display(raster.pixel(x, y)).as_dvec3();
        0.2126 * code.x + 0.7152 * code.y + 0.0722 * code.z
    };
    let weight = |i: usize, j: usize| {
        let square = |offset: usize| (offset as f64 - 5.0).powi(2);
        (-(square(i) + square(j)) / (2.0 * 1.5 * 1.5)).exp()
    };
    let total: f64 = (0..121).map(|index| weight(index % 11, index / 11)).sum();
    let (mut sum, mut count) = (0.0, 0.0);
    for (left, top) in (0..a.width() - 10).flat_map(|x| (0..a.height() - 10).map(move |y| (x, y))) {
        let window = |value: &dyn Fn(f64, f64) -> f64| -> f64 {
            let term = |index: usize| {
                let (i, j) = (index % 11, index / 11);
                weight(i, j) / total * value(luma(a, left + i, top + j), luma(b, left + i, top + j))
            };
            (0..121).map(term).sum()
        };
        let (mean_a, mean_b) = (window(&|a, _| a), window(&|_, b| b));
        let variance_a = window(&|a, _| (a - mean_a).powi(2));
        let variance_b = window(&|_, b| (b - mean_b).powi(2));
        let covariance = window(&|a, b| (a - mean_a) * (b - mean_b));
        sum += (2.0 * mean_a * mean_b + 1e-4) * (2.0 * covariance + 9e-4)
            / ((mean_a * mean_a + mean_b * mean_b + 1e-4) * (variance_a + variance_b + 9e-4));
        count += 1.0;
    }
    sum / count
}

#[test]
fn structural_similarity_is_its_formula() {
    let (a, b) = (textured(24, 19, 2), textured(24, 19, 5));
    let (fast, slow) = (structural_similarity(&a, &b), slow_similarity(&a, &b));
    assert!((fast - slow).abs() < 1e-4, "{fast} {slow}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn all_but_the_relative_error_are_symmetric(
        width in 1usize..30, height in 1usize..30, first in 0usize..20, second in 0usize..20
    ) {
        let (a, b) = (textured(width, height, first), textured(width, height, second));
        prop_assert_eq!(root_mean_square_error(&a, &b), root_mean_square_error(&b, &a));
        prop_assert_eq!(peak_signal_to_noise(&a, &b), peak_signal_to_noise(&b, &a));
        prop_assert!((structural_similarity(&a, &b) - structural_similarity(&b, &a)).abs() < 1e-9);
        let map = flip_map(&a, &b);
        prop_assert_eq!(&map, &flip_map(&b, &a));
        prop_assert!(map.values().iter().all(|value| (0.0..=1.0).contains(value)));
    }
}
