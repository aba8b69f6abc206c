//! Scattering functions: rough and nearly smooth, upright and at grazing angles.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, faults_of};
use crate::limits::{ROUGHNESS, Range};
use crate::materials::{Coat, ColourSource, Material, Metal, MetalReflectance, RoughGlass, Scattering};
use crate::math::functions::sin_cos_turns;
use crate::math::{DVec3, Vec3};
use crate::parallel;
use crate::random::{Random, power_of_ten};

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Lobes,
        name: "density",
        swept: "roughness",
        error: "|integral of the density - share of samples that leave|, metal",
        unit: "",
        bound: 0.01,
        promised: ROUGHNESS.range,
        sweep: density,
    },
    Subject {
        group: Group::Lobes,
        name: "furnace",
        swept: "roughness",
        error: "|share of light given back - 1| by white metal, coat and glass",
        unit: "",
        bound: 0.02,
        promised: ROUGHNESS.range,
        sweep: furnace,
    },
    Subject {
        group: Group::Lobes,
        name: "grazing-lobes",
        swept: "cosine of the view",
        error: "samples and values that are negative or not numbers, per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1e-15, 1.0),
        sweep: grazing,
    },
];

/// Materials that give back all light, and the relative index they are seen with.
fn white_materials(roughness: f64) -> Vec<(&'static str, Material, f64)> {
    let metal = Metal::new(MetalReflectance::Schlick { normal: Vec3::ONE }, roughness);
    let (coat, colour) = (Arc::new(Coat::new(1.5, roughness)), ColourSource::Uniform(Vec3::ONE));
    let glass = || {
        let rough = Some(Arc::new(RoughGlass::new(1.5, roughness)));
        Material::Glass { index: 1.5, absorption: Vec3::ZERO, rough }
    };
    vec![
        ("metal", Material::Metal(Arc::new(metal)), 1.0),
        ("coat", Material::Coated { coat, colour }, 1.0),
        ("glass", glass(), 1.0 / 1.5),
        ("inner glass", glass(), 1.5),
    ]
}

fn scattering<'a>((_, material, index): &'a (&'static str, Material, f64)) -> Scattering<'a> {
    material.scattering(Default::default(), *index).expect("it scatters")
}

fn view(cosine: f64) -> DVec3 {
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    DVec3::new(sine * 0.8, sine * 0.6, cosine)
}

/// Roughnesses from below what scenes may hold to 1.
fn roughnesses() -> impl Iterator<Item = f64> {
    (-6..=0).flat_map(|exponent| [power_of_ten(exponent), 3.0 * power_of_ten(exponent)]).filter(|&alpha| alpha <= 1.0)
}

/// The integral of the density over the upper half, over half vectors h: `d omega = 4 (view . h) d omega_h`. Their angle t
/// to the normal is spread by `tan t = c u^2 / (1 - u)^3`: half of the steps lie within the peak of microfacets of roughness
/// c, and the last ones reach far beyond, where a wide lobe of little weight may lie. With x = tan t
///
/// ```text
///   d omega_h = x / (1 + x^2)^(3/2) dx d phi          dx = c u (2 + u) / (1 - u)^4 du
/// ```
fn integral(scattering: &Scattering, view: DVec3, spread: f64) -> f64 {
    const RINGS: usize = 384;
    const STEPS: usize = 96;
    let ring = |ring: usize| {
        let place = (ring as f64 + 0.5) / RINGS as f64;
        let rest = 1.0 - place;
        let tangent = spread * place * place / (rest * rest * rest);
        let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
        let sine = tangent * cosine;
        let stretch = spread * place * (2.0 + place) / (rest * rest * rest * rest);
        let solid_angle = tangent * cosine * cosine * cosine * stretch;
        let values = (0..STEPS).map(|step| {
            let (up, right) = sin_cos_turns((step as f64 + 0.5) / STEPS as f64);
            let half_vector = DVec3::new(sine * right, sine * up, cosine);
            let light = half_vector * (2.0 * view.dot(half_vector)) - view;
            let seen = view.dot(half_vector) > 0.0 && light.z > 0.0;
            if seen { scattering.evaluate(view, light).density * 4.0 * view.dot(half_vector) } else { 0.0 }
        });
        values.sum::<f64>() * solid_angle
    };
    (0..RINGS).map(ring).sum::<f64>() * TAU / (RINGS * STEPS) as f64
}

/// The mean over stratified samples of what `value` makes of each; `side * side` of them.
fn mean_of_samples(scattering: &Scattering, view: DVec3, side: usize, value: impl Fn(Vec3) -> f64) -> f64 {
    let mut random = Random(side as u64 ^ view.z.to_bits());
    let mut sum = 0.0;
    for index in 0..side * side {
        let place = [index % side, index / side].map(|stratum| (stratum as f64 + random.unit()) / side as f64);
        let sample = scattering.sample(view, place, random.unit());
        sum += sample.map_or(0.0, |sample| value(sample.weight));
    }
    sum / (side * side) as f64
}

/// Strata along each side for a share of the rays, from 32 to 192.
fn strata(effort: Effort, share: f64) -> usize {
    ((effort.share(share) as f64).sqrt() as usize).clamp(64, 192)
}

/// The worst over materials and views at each roughness.
fn by_roughness(measure: impl Fn(&(&'static str, Material, f64), f64, f64) -> f64 + Sync) -> Vec<Measurement> {
    let of_roughness = |roughness: f64| {
        let mut worst = Measurement::new(roughness, 0.0, "none");
        for material in &white_materials(roughness) {
            for cosine in [1.0, 0.7, 0.3, 0.03] {
                let error = measure(material, roughness, cosine);
                let error = if error.is_nan() { f64::INFINITY } else { error };
                if error > worst.error {
                    worst = Measurement::new(roughness, error, format!("{}, cos {cosine}", material.0));
                }
            }
        }
        worst
    };
    parallel::map(roughnesses(), of_roughness)
}

fn density(effort: Effort) -> Vec<Measurement> {
    let side = strata(effort, 4e-3);
    by_roughness(|material, roughness, cosine| {
        let (scattering, view) = (scattering(material), view(cosine));
        // A peak over a wide base, and one refracted besides the reflected, would ask for other coordinates.
        if !matches!(scattering, Scattering::Metal(_)) {
            return 0.0;
        }
        let leaving = mean_of_samples(&scattering, view, side, |_| 1.0);
        (integral(&scattering, view, roughness) - leaving).abs()
    })
}

fn furnace(effort: Effort) -> Vec<Measurement> {
    let side = strata(effort, 4e-3);
    by_roughness(|material, _, cosine| {
        let mean = mean_of_samples(&scattering(material), view(cosine), side, |weight| f64::from(weight.x));
        (mean - 1.0).abs()
    })
}

fn grazing(effort: Effort) -> Vec<Measurement> {
    let materials: Vec<_> = [1e-4, 1e-2, 0.3, 1.0].into_iter().flat_map(white_materials).collect();
    let of_cosine = |cosine: f64| {
        let (faults, first) = faults_of(effort.share(1e-3), cosine.to_bits(), |random| {
            let material = &materials[random.below(materials.len())];
            let (scattering, view) = (scattering(material), view(cosine));
            let corner = |random: &mut Random| match random.below(8) {
                0 => 0.0,
                1 => 1.0 - f64::EPSILON,
                _ => random.unit(),
            };
            let place = [corner(random), corner(random)];
            let sample = scattering.sample(view, place, corner(random));
            let sound = |value: Vec3, density: f64| {
                value.is_finite() && value.min_element() >= 0.0 && density.is_finite() && density >= 0.0
            };
            let sampled = sample.is_none_or(|sample| {
                sound(sample.weight, sample.density) && (sample.direction.length() - 1.0).abs() < 1e-6
            });
            let mut light = random.direction();
            if random.unit() < 0.5 {
                light = DVec3 { z: light.z.signum() * random.decade(-16, -1), ..light }.normalize();
            }
            let evaluation = scattering.evaluate(view, light);
            (!(sampled && sound(evaluation.value, evaluation.density))).then_some(material.0)
        });
        Measurement::new(cosine, faults, first.unwrap_or("none"))
    };
    decades(-18, 0).map(of_cosine).collect()
}
