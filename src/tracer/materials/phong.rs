//! Diffuse reflection and Phong's highlight.

use std::f32::consts::PI;

use super::diffuse::{cosine_density, cosine_direction};
use super::fresnel::mirrored;
use super::scattering_sample::{Evaluation, ScatteringSample};
use crate::colour::luminance;
use crate::math::functions::{power, power_f64, sin_cos_turns};
use crate::math::{DVec3, Vec3};

/// The modified Phong model (Lafortune and Willems, Using the Modified Phong Reflectance Model for Physically Based
/// Rendering, 1994): `f = diffuse / pi + specular (n + 2) / (2 pi) cos^n`, the cosine between light and mirrored view.
///
/// It reflects `diffuse + specular` at normal incidence and less elsewhere, so the sum must not exceed 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phong {
    /// Reflectance of the diffuse share, linear RGB.
    pub diffuse: Vec3,
    /// Reflectance of the highlight at normal incidence, linear RGB.
    pub specular: Vec3,
    /// The exponent n of the cosine.
    pub exponent: f32,
}

impl Phong {
    /// Probability of sampling the highlight.
    fn highlight_share(&self) -> f64 {
        let (diffuse, specular) = (luminance(self.diffuse), luminance(self.specular));
        if specular > 0.0 { f64::from(specular / (diffuse + specular)) } else { 0.0 }
    }

    /// The scattering function times the cosine, and the density with which `sample` chooses `light`.
    #[inline]
    pub fn evaluate(&self, view: DVec3, light: DVec3) -> Evaluation {
        if light.z <= 0.0 {
            return Evaluation::NONE;
        }
        let highlight = phong_lobe(mirrored(view).dot(light) as f32, self.exponent);
        let value = (self.diffuse / PI + self.specular * highlight) * light.z as f32;
        // cos^n is sampled with its own normalisation, (n + 1) / (2 pi).
        let lobe_density = f64::from(highlight) * f64::from((self.exponent + 1.0) / (self.exponent + 2.0));
        let share = self.highlight_share();
        Evaluation { value, density: (1.0 - share) * cosine_density(light.z) + share * lobe_density }
    }

    /// A direction from the highlight or the diffuse share, chosen by `choice`; `place` and `choice` are uniform in `[0, 1)`.
    #[inline]
    pub fn sample(&self, view: DVec3, place: [f64; 2], choice: f64) -> Option<ScatteringSample> {
        let direction = if choice < self.highlight_share() {
            about_axis(mirrored(view), lobe_direction(place, f64::from(self.exponent)))
        } else {
            cosine_direction(place)
        };
        let Evaluation { value, density } = self.evaluate(view, direction);
        let weight = value / density as f32;
        (density > 0.0).then_some(ScatteringSample { direction, weight, density, specular: false, transmitted: false })
    }
}

/// The Phong lobe, normalised so that it never reflects more than arrives: `(n + 2) / (2 pi) cos^n`.
#[inline]
pub fn phong_lobe(cosine: f32, exponent: f32) -> f32 {
    if cosine <= 0.0 {
        return 0.0;
    }
    (exponent + 2.0) / (2.0 * PI) * power(cosine, exponent)
}

/// A direction about +z with the density `(n + 1) / (2 pi) cos^n`.
fn lobe_direction(place: [f64; 2], exponent: f64) -> DVec3 {
    let cosine = power_f64(1.0 - place[0], 1.0 / (exponent + 1.0));
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    let (sine_around, cosine_around) = sin_cos_turns(place[1]);
    DVec3::new(sine * cosine_around, sine * sine_around, cosine)
}

/// Turns +z to a unit axis (Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017).
fn about_axis(axis: DVec3, local: DVec3) -> DVec3 {
    let (x_axis, y_axis) = axis.any_orthonormal_pair();
    (x_axis * local.x + y_axis * local.y + axis * local.z).normalize()
}
