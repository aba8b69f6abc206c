//! The tables against quadratures that are as good as exact, at cosines between the nodes.

use super::conductor::MetalReflectance;
use super::{Coat, Material, Metal, RoughGlass};
use crate::math::{DVec3, Vec3};

const ROUGHNESSES: [f64; 9] = [1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0];

/// Cosines from grazing on, and some about the critical angle of glass, where tables are hardest.
fn cosines() -> impl Iterator<Item = f64> {
    let crowded = (1..60).step_by(2).map(|step| (f64::from(step) / 60.0 + 0.003).powi(3));
    crowded.chain([1e-5, 1e-4, 1e-3, 0.7453, 0.7459])
}

/// The largest error and its cosine.
fn worst(error: impl Fn(f64) -> f64) -> (f64, f64) {
    let larger = |one: (f64, f64), other: (f64, f64)| if other.0 > one.0 { other } else { one };
    cosines().map(|cosine| (error(cosine).abs(), cosine)).fold((0.0, 0.0), larger)
}

#[test]
fn tables_are_exact_to_a_ten_thousandth() {
    for roughness in ROUGHNESSES {
        let metal = Metal::new(MetalReflectance::Schlick { normal: Vec3::ONE }, roughness);
        let coat = Coat::new(1.5, roughness);
        let glass = RoughGlass::new(1.5, roughness);
        let errors = [
            ("metal", worst(|cosine| metal.table_error(cosine))),
            ("coat", worst(|cosine| coat.table_error(cosine))),
            ("glass from inside", worst(|cosine| glass.table_error(0, cosine))),
            ("glass from outside", worst(|cosine| glass.table_error(1, cosine))),
        ];
        for (name, (error, cosine)) in errors {
            println!("{name}, roughness {roughness}: {error:.1e} at the cosine {cosine:.4}");
            assert!(error < 1e-4, "{name}, roughness {roughness}: {error:.1e} at the cosine {cosine:.4}");
        }
    }
}

#[test]
fn rough_glass_sends_no_negative_light_at_the_horizon() {
    let roughness = 0.080_375_205_230_998_73_f64;
    let rough = Some(RoughGlass::new(1.5, roughness).into());
    let glass = Material::Glass { index: 1.5, absorption: Vec3::ZERO, rough };
    for cosine in [9.662_194_643_758_287e-11_f64, 1e-9, 1e-12] {
        let view = DVec3::new(((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, cosine);
        for step in 1..100 {
            let depth = f64::from(step) / 100.0;
            let light = DVec3::new(0.0, -(1.0 - depth * depth).sqrt(), -depth);
            let evaluation = glass.scattering(Default::default(), 1.0 / 1.5).unwrap().evaluate(view, light);
            assert!(evaluation.value.min_element() >= 0.0 && evaluation.density >= 0.0, "{cosine} {evaluation:?}");
        }
    }
}
