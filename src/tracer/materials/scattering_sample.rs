//! What a scattering function answers: its value for two directions, and a direction chosen at random.

use super::fresnel::mirrored;
use crate::math::{DVec3, Vec3};

/// What goes from one direction into another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaluation {
    /// The scattering function times the cosine: `f(view, light) |light.z|`, without the delta lobes.
    pub value: Vec3,
    /// Density, per solid angle, with which [`Scattering::sample`](super::Scattering::sample) chooses `light`; that of its delta lobes not counted.
    pub density: f64,
}

impl Evaluation {
    /// Nothing goes there, and nothing is sampled there.
    pub const NONE: Self = Self { value: Vec3::ZERO, density: 0.0 };
}

/// A direction chosen at random.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScatteringSample {
    /// Unit vector away from the surface, towards where light comes from.
    pub direction: DVec3,
    /// `f |cos| / density`; for a delta lobe its factor over its probability. Finite, never negative.
    pub weight: Vec3,
    /// Density per solid angle, of all lobes that are not delta lobes; for a delta lobe its probability.
    pub density: f64,
    /// True for a delta lobe: no other technique can find this direction.
    pub specular: bool,
    /// True if the light comes through the surface: `direction.z < 0`.
    pub transmitted: bool,
}

impl ScatteringSample {
    /// Straight on.
    #[inline]
    pub(super) fn passing(view: DVec3) -> Self {
        Self { direction: -view, weight: Vec3::ONE, density: 1.0, specular: true, transmitted: true }
    }

    /// Ideal reflection, chosen with a probability.
    #[inline]
    pub(super) fn reflected_specularly(view: DVec3, weight: Vec3, probability: f64) -> Self {
        Self { direction: mirrored(view), weight, density: probability, specular: true, transmitted: false }
    }
}
