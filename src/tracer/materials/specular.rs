//! Delta lobes: light that continues in exactly one direction, or two.

use super::fresnel::{boundary, refract};
use super::scattering_sample::ScatteringSample;
use crate::math::{DVec3, Vec3};

/// Ideal specular reflection, the same at every angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mirror {
    /// Reflectance, linear RGB in `[0, 1]`.
    pub colour: Vec3,
}

impl Mirror {
    /// The mirrored direction; `None` if the mirror is black.
    #[inline]
    pub fn sample(&self, view: DVec3) -> Option<ScatteringSample> {
        (self.colour != Vec3::ZERO).then_some(ScatteringSample::reflected_specularly(view, self.colour, 1.0))
    }
}

/// The smooth boundary of two dielectrics; reflection or transmission is chosen by its share of the light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothBoundary {
    /// Index of refraction on the viewer's side over that on the other.
    pub relative_index: f64,
}

impl SmoothBoundary {
    /// Reflection and transmission, each weighted by its share; `None` where all is reflected.
    pub fn branches(&self, view: DVec3) -> Option<[ScatteringSample; 2]> {
        let boundary = boundary(view.z, self.relative_index);
        boundary.cos_transmitted?;
        let share = |share: f64| Vec3::splat(share as f32);
        Some([
            ScatteringSample::reflected_specularly(view, share(boundary.reflectance), 1.0),
            self.transmitted(view, share(1.0 - boundary.reflectance), 1.0),
        ])
    }

    /// Reflection with the probability of the reflectance, refraction otherwise; `choice` is uniform in `[0, 1)`.
    #[inline]
    pub fn sample(&self, view: DVec3, choice: f64) -> Option<ScatteringSample> {
        let boundary = boundary(view.z, self.relative_index);
        Some(match boundary.cos_transmitted {
            Some(_) if choice >= boundary.reflectance => self.transmitted(view, Vec3::ONE, 1.0 - boundary.reflectance),
            _ => ScatteringSample::reflected_specularly(view, Vec3::ONE, boundary.reflectance),
        })
    }

    /// Refraction, chosen with a probability.
    #[inline]
    fn transmitted(&self, view: DVec3, weight: Vec3, probability: f64) -> ScatteringSample {
        let direction = refract(-view, DVec3::Z, self.relative_index);
        ScatteringSample { direction, weight, density: probability, specular: true, transmitted: true }
    }
}
