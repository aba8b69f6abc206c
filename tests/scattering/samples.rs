//! Samples against their density: chi-square over the sphere, and weights against values.

use skycube::materials::{Evaluation, Scattering};
use skycube::math::DVec3;
use skycube::stress::Random;

use crate::chi_square::{Bins, Outcome, chi_square};
use crate::subjects::{glass, gold, lambert, phong, scattering, view, white_coated, white_metal};

const COUNT: usize = 100_000;
/// How many chi-square tests there are below, at least.
const TESTS: usize = 100;

fn reflected(view: DVec3) -> DVec3 {
    DVec3::new(-view.x, -view.y, view.z)
}

/// Tests the samples on one side of the surface, delta lobes left out, in bins about a pole.
fn test_side(scattering: &Scattering, view: DVec3, side: f64, bins: &Bins, name: &str) -> Outcome {
    let mut random = Random(view.z.to_bits() ^ side.to_bits());
    let sample = || {
        let place = [random.unit(), random.unit()];
        let sample = scattering.sample(view, place, random.unit())?;
        let Evaluation { value, density } = scattering.evaluate(view, sample.direction);
        if sample.specular {
            return None;
        }
        assert!((density / sample.density - 1.0).abs() < 1e-4, "{name}: {density} {sample:?}");
        assert!((value / density as f32 - sample.weight).abs().max_element() < 1e-3, "{name}: {value} {sample:?}");
        (sample.direction.z * side > 0.0).then_some(sample.direction)
    };
    let density = |light: DVec3| if light.z * side > 0.0 { scattering.evaluate(view, light).density } else { 0.0 };
    let outcome = chi_square(bins, COUNT, sample, density);
    assert!(outcome.passes(TESTS), "{name}, view {view}, side {side}: {outcome:?}");
    assert!(outcome.integral < 1.0 + 1e-3, "{name}: {outcome:?}");
    outcome
}

fn test_reflection(name: &str, scattering: &Scattering, spread: f64) {
    for cosine in [0.05, 0.5, 0.98] {
        let view = view(cosine);
        test_side(scattering, view, 1.0, &Bins::focused(reflected(view), spread, 24, 12), name);
    }
}

#[test]
fn reflecting_materials_follow_their_density() {
    test_reflection("lambert", &scattering(&lambert(), 1.0), 1.0);
    for exponent in [2.0, 100.0] {
        test_reflection("phong", &scattering(&phong(exponent), 1.0), 1.0 / f64::from(exponent).sqrt());
    }
    for roughness in [0.003, 0.1, 0.5, 1.0] {
        test_reflection("metal", &scattering(&white_metal(roughness), 1.0), roughness);
        test_reflection("gold", &scattering(&gold(roughness), 1.0), roughness);
        test_reflection("coated", &scattering(&white_coated(roughness), 1.0), roughness);
    }
    test_reflection("smooth coat", &scattering(&white_coated(0.0), 1.0), 1.0);
}

#[test]
fn rough_glass_follows_its_density_on_both_sides() {
    for (roughness, relative_index) in
        [(0.01, 1.0 / 1.5), (0.01, 1.5), (0.2, 1.0 / 1.5), (0.2, 1.5), (1.0, 1.0 / 1.5), (1.0, 1.5)]
    {
        let material = glass(1.5, roughness);
        let scattering = scattering(&material, relative_index);
        for cosine in [0.1, 0.6, 0.95] {
            let view = view(cosine);
            test_side(&scattering, view, 1.0, &Bins::focused(reflected(view), roughness, 24, 12), "glass");
            let refracted = DVec3::new(-view.x * relative_index, -view.y * relative_index, 0.0);
            let height = 1.0 - refracted.length_squared();
            let pole = if height > 0.0 { refracted - DVec3::Z * height.sqrt() } else { refracted.normalize() };
            test_side(&scattering, view, -1.0, &Bins::focused(pole, roughness, 24, 12), "glass");
        }
    }
}

#[test]
fn a_wrong_density_is_found() {
    let mut random = Random(7);
    let sample = || Some(skycube::materials::cosine_direction([random.unit(), random.unit()]));
    let right = |light: DVec3| skycube::materials::cosine_density(light.z);
    let bins = Bins::even(DVec3::Z, 16, 16);
    assert!(chi_square(&bins, COUNT, sample, right).passes(1));
    let mut random = Random(7);
    let sample = || Some(skycube::materials::cosine_direction([random.unit(), random.unit()]));
    let wrong = |light: DVec3| right(light) * (1.0 + 0.1 * light.x);
    assert!(!chi_square(&bins, COUNT, sample, wrong).passes(TESTS));
}
