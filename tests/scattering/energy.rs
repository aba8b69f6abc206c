//! Nothing is lost and nothing is gained: under light from everywhere a surface that absorbs nothing cannot be seen.

use std::sync::Arc;

use skycube::materials::{Material, RoughGlass, Scattering};
use skycube::math::Vec3;
use skycube::stress::Random;

use crate::subjects::{ROUGHNESSES, glass, lambert, phong, scattering, view, white_coated, white_metal};

const COSINES: [f64; 9] = [1e-3, 0.01, 0.03, 0.1, 0.3, 0.5, 0.75, 0.9, 1.0];
/// Strata along each coordinate of the place.
const STRATA: usize = 128;

/// Mean weight over stratified samples and its standard error.
///
/// The error is that of independent samples, which is more than that of stratified ones; and one sample of weight 1 more,
/// since what has a probability of less than one in all samples may have been missed.
fn furnace(scattering: &Scattering, cosine: f64) -> (f64, f64) {
    let mut random = Random(STRATA as u64 ^ cosine.to_bits());
    let view = view(cosine);
    let (mut sum, mut squares) = (0.0, 0.0);
    for column in 0..STRATA {
        for row in 0..STRATA {
            let place = [column, row].map(|stratum| (stratum as f64 + random.unit()) / STRATA as f64);
            let weight = scattering.sample(view, place, random.unit()).map_or(0.0, |sample| {
                assert!(sample.weight.is_finite() && sample.weight.min_element() >= 0.0, "{sample:?}");
                assert!((sample.direction.length() - 1.0).abs() < 1e-9, "{sample:?}");
                assert_eq!(sample.transmitted, sample.direction.z < 0.0);
                f64::from(sample.weight.x)
            });
            sum += weight;
            squares += weight * weight;
        }
    }
    let count = (STRATA * STRATA) as f64;
    let mean = sum / count;
    (mean, ((squares / count - mean * mean).max(0.0) / count).sqrt() + 1.0 / count)
}

/// Checks a scattering function that gives back everything and gives its largest deviation.
fn check(name: &str, scattering: &Scattering) -> f64 {
    let mut worst = 0.0_f64;
    for cosine in COSINES {
        let (mean, sigma) = furnace(scattering, cosine);
        assert!((mean - 1.0).abs() < 3.0 * sigma, "{name}, cosine {cosine}: {mean} +- {sigma}");
        assert!(sigma < 0.01, "{name}, cosine {cosine}: {mean} +- {sigma} says nothing");
        worst = worst.max((mean - 1.0).abs());
    }
    println!("{name}: largest deviation {worst:.1e}");
    worst
}

#[test]
fn white_furnace_of_metal_and_coat() {
    check("lambert", &scattering(&lambert(), 1.0));
    for roughness in ROUGHNESSES.into_iter().chain([0.0]) {
        check(&format!("metal {roughness}"), &scattering(&white_metal(roughness), 1.0));
        check(&format!("coated {roughness}"), &scattering(&white_coated(roughness), 1.0));
    }
}

#[test]
fn white_furnace_of_glass_from_both_sides() {
    for roughness in ROUGHNESSES.into_iter().chain([0.0]) {
        let glass = glass(1.5, roughness);
        check(&format!("glass {roughness} from outside"), &scattering(&glass, 1.0 / 1.5));
        check(&format!("glass {roughness} from inside"), &scattering(&glass, 1.5));
    }
    for index in [1.0, 1.0 - 1e-6, 1.0 + 1e-6, 0.5, 2.4, 100.0] {
        for roughness in [1e-4, 0.1, 1.0] {
            let glass = glass(index, roughness);
            check(&format!("index {index} {roughness} from outside"), &scattering(&glass, 1.0 / index));
            check(&format!("index {index} {roughness} from inside"), &scattering(&glass, index));
        }
    }
}

/// Two tables a medium that the glass meets; from 1.5 straight to 1.33, water, a table of vacuum would lose some.
#[test]
fn white_furnace_of_nested_glass() {
    for roughness in [0.1, 1.0] {
        let mut surface = RoughGlass::new(1.5, roughness);
        surface.meet(1.5, 1.33);
        let glass = Material::Glass { index: 1.5, absorption: Vec3::ZERO, rough: Some(Arc::new(surface)) };
        for relative_index in [1.0 / 1.5, 1.5, 1.33 / 1.5, 1.5 / 1.33] {
            check(&format!("nested {roughness}, {relative_index}"), &scattering(&glass, relative_index));
        }
    }
}

#[test]
fn phong_reflects_its_sum_straight_on_and_never_more() {
    for exponent in [0.0, 1.0, 10.0, 1000.0, 1e6] {
        let material = phong(exponent);
        let scattering = scattering(&material, 1.0);
        let (mean, sigma) = furnace(&scattering, 1.0);
        assert!((mean - 1.0).abs() < 3.0 * sigma + 1e-4, "{exponent}: {mean} {sigma}");
        for cosine in COSINES {
            let (mean, sigma) = furnace(&scattering, cosine);
            assert!(mean < 1.0 + 3.0 * sigma + 1e-4, "{exponent} {cosine}: {mean} {sigma}");
        }
    }
}
