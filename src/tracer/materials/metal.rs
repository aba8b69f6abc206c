//! Metals, smooth or rough.
//!
//! Light that microfacets reflect onto one another is not traced. A second lobe returns it, with the energy that the
//! first one lacks: `(1 - E(mu_o)) (1 - E(mu_i)) / (pi (1 - E_avg))`, where E is the share that a surface without
//! absorption reflects at once (Kulla and Conty, Revisiting Physically Based Shading at Imageworks, SIGGRAPH 2017). Its
//! colour is that of the light after many reflections: `F_avg^2 E_avg / (1 - F_avg (1 - E_avg))` (Hill, A Multi-Faceted
//! Exploration, 2018).

use std::f64::consts::FRAC_1_PI;

use super::conductor::MetalReflectance;
use super::directional_table::DirectionalTable;
use super::microfacet::Microfacets;
use super::scattering_sample::{Evaluation, ScatteringSample};
use super::visible_average::Facet;
use crate::math::{DVec3, Vec3};

/// A metal surface with what its scattering function needs, computed once.
#[derive(Debug, Clone, PartialEq)]
pub struct Metal {
    reflectance: MetalReflectance,
    roughness: Option<Roughness>,
}

/// The microfacets and the lobe of light reflected many times.
#[derive(Debug, Clone, PartialEq)]
struct Roughness {
    microfacets: Microfacets,
    /// Share of light that is not reflected at once, `1 - E`.
    lost: DirectionalTable,
    /// What the metal leaves of it.
    regained: Vec3,
}

/// The two lobes for a pair of directions, before Fresnel's factor and the cosine is in both.
struct Lobes {
    single: f64,
    multiple: f64,
    fresnel: Vec3,
    density: f64,
}

impl Metal {
    /// `roughness` is the alpha of GGX, or 0 for a smooth surface.
    pub fn new(reflectance: MetalReflectance, roughness: f64) -> Self {
        let roughness = (roughness > 0.0).then(|| Roughness::new(&reflectance, roughness));
        Self { reflectance, roughness }
    }

    /// True if it reflects like a mirror.
    pub fn is_smooth(&self) -> bool {
        self.roughness.is_none()
    }

    /// Reflectance at a cosine with the normal of a microfacet, or of the smooth surface.
    pub fn reflectance(&self, cosine: f64) -> Vec3 {
        self.reflectance.at(cosine as f32)
    }

    #[inline]
    pub(super) fn evaluate(&self, view: DVec3, light: DVec3) -> Evaluation {
        let Some(rough) = &self.roughness else { return Evaluation::NONE };
        if light.z <= 0.0 {
            return Evaluation::NONE;
        }
        let lobes = self.lobes(rough, view, light, (view + light).normalize());
        let value = lobes.fresnel * lobes.single as f32 + rough.regained * lobes.multiple as f32;
        Evaluation { value, density: lobes.density }
    }

    #[inline]
    pub(super) fn sample(&self, view: DVec3, place: [f64; 2], choice: f64) -> Option<ScatteringSample> {
        let Some(rough) = &self.roughness else {
            return Some(ScatteringSample::reflected_specularly(view, self.reflectance(view.z), 1.0));
        };
        let (direction, normal) = if choice < rough.lost.at(view.z) {
            let direction = rough.lost.lobe_direction(place);
            (direction, (view + direction).normalize())
        } else {
            let normal = rough.microfacets.visible_normal(view, place);
            (normal * (2.0 * view.dot(normal)) - view, normal)
        };
        if direction.z <= 0.0 {
            return None;
        }
        let lobes = self.lobes(rough, view, direction, normal);
        let weight = lobes.fresnel * (lobes.single / lobes.density) as f32
            + rough.regained * (lobes.multiple / lobes.density) as f32;
        Some(ScatteringSample { direction, weight, density: lobes.density, specular: false, transmitted: false })
    }

    #[inline]
    fn lobes(&self, rough: &Roughness, view: DVec3, light: DVec3, normal: DVec3) -> Lobes {
        let distribution = rough.microfacets.distribution(normal);
        let single = distribution * rough.microfacets.visibility(view.z, light.z) * light.z;
        let at_once = 0.25 * distribution * rough.microfacets.visible_scale(view.z);
        let lost = rough.lost.at(view.z);
        let (lost_to_light, level) = rough.lost.at_with_lobe(light.z);
        let cosine = lost * light.z * FRAC_1_PI;
        Lobes {
            single,
            multiple: cosine * lost_to_light * rough.lost.inverse_average(),
            fresnel: self.reflectance(view.dot(normal)),
            density: (1.0 - lost) * at_once + cosine * level,
        }
    }
}

impl Roughness {
    fn new(reflectance: &MetalReflectance, alpha: f64) -> Self {
        let microfacets = Microfacets::new(alpha);
        let lost =
            DirectionalTable::over_visible_normals(&microfacets, None, |view, normal| lost(&microfacets, view, normal));
        let (average, lost_average) = (reflectance.average(), lost.average() as f32);
        let regained = average * average * (1.0 - lost_average) / (1.0 - average * lost_average);
        Self { microfacets, lost, regained }
    }
}

/// Share of light that a visible microfacet throws onto others.
#[inline]
fn lost(microfacets: &Microfacets, view: DVec3, normal: DVec3) -> Facet {
    let light = 2.0 * view.dot(normal) * normal.z - view.z;
    let value = if light > 0.0 { microfacets.shadowed(view.z, light) } else { 1.0 };
    Facet { value, kinks: [light, 1.0, 1.0] }
}

#[cfg(test)]
impl Metal {
    /// The table's error at a cosine.
    pub(super) fn table_error(&self, cosine: f64) -> f64 {
        let Some(Roughness { microfacets, lost: table, .. }) = &self.roughness else { return 0.0 };
        let exact = super::visible_average::average_over_visible(microfacets, cosine, 1e-9, |view, normal| {
            lost(microfacets, view, normal)
        });
        table.at(cosine) - exact
    }
}
