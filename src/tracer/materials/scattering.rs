//! Scattering at a surface point: the scattering function (BSDF) and its sampling.
//!
//! ```text
//!        view      z = shading normal, on the viewer's side        view.z > 0 always;
//!            \     ^     / light, reflected: light.z > 0           both are unit vectors that point
//!             \    |    /                                          away from the surface
//!              \   |   /
//!     ----------\--|--/----------
//!                   \
//!                    \ light, transmitted: light.z < 0
//! ```
//!
//! Light is carried as basic radiance L / n^2, which refraction does not change (Nicodemus 1963; Veach 1997, section
//! 5.2). So transmission has no factor n^2: a furnace of radiance 1 is 1 inside glass, too, and for directions a and b
//! on sides with the indices n_a and n_b reciprocity reads `n_a^2 f(a, b) = n_b^2 f(b, a)`.

use super::coated::Coated;
use super::diffuse::Diffuse;
use super::metal::Metal;
use super::phong::Phong;
use super::rough_glass::RoughBoundary;
use super::scattering_sample::{Evaluation, ScatteringSample};
use super::specular::{Mirror, SmoothBoundary};
use crate::math::{DVec3, Vec3};

/// The scattering function at one place of a surface, in the frame drawn above.
#[derive(Debug, Clone, Copy)]
pub enum Scattering<'a> {
    /// Lambert's law.
    Diffuse(Diffuse),
    /// Diffuse share and highlight.
    Phong(Phong),
    /// Ideal reflection.
    Mirror(Mirror),
    /// Reflection and refraction at a smooth dielectric.
    SmoothGlass(SmoothBoundary),
    /// Glass with nothing to refract at: both sides have the same index.
    Passing,
    /// Reflection and refraction at microfacets.
    RoughGlass(RoughBoundary<'a>),
    /// A conductor, smooth or rough.
    Metal(&'a Metal),
    /// A diffuse base under a dielectric coat.
    Coated(Coated<'a>),
}

impl Scattering<'_> {
    /// True if there are delta lobes only: [`evaluate`](Self::evaluate) is always zero and sampling lights is pointless.
    #[inline]
    pub fn is_specular(&self) -> bool {
        match self {
            Self::Mirror(_) | Self::SmoothGlass(_) | Self::Passing => true,
            Self::Metal(metal) => metal.is_smooth(),
            Self::Diffuse(_) | Self::Phong(_) | Self::RoughGlass(_) | Self::Coated(_) => false,
        }
    }

    /// The share of light that goes from `light` to `view`, and the density of finding `light` by [`sample`](Self::sample).
    #[inline]
    pub fn evaluate(&self, view: DVec3, light: DVec3) -> Evaluation {
        match self {
            Self::Diffuse(lobe) => lobe.evaluate(light),
            Self::Phong(lobe) => lobe.evaluate(view, light),
            Self::RoughGlass(lobe) => lobe.evaluate(view, light),
            Self::Metal(lobe) => lobe.evaluate(view, light),
            Self::Coated(lobe) => lobe.evaluate(view, light),
            Self::Mirror(_) | Self::SmoothGlass(_) | Self::Passing => Evaluation::NONE,
        }
    }

    /// Chooses a direction for a path from the viewer. `place` and `choice` are uniform in `[0, 1)`. `None` where the
    /// sample carries nothing (absorbed, or below the horizon): it counts as zero.
    #[inline]
    pub fn sample(&self, view: DVec3, place: [f64; 2], choice: f64) -> Option<ScatteringSample> {
        match self {
            Self::Diffuse(lobe) => lobe.sample(place),
            Self::Phong(lobe) => lobe.sample(view, place, choice),
            Self::Mirror(lobe) => lobe.sample(view),
            Self::SmoothGlass(lobe) => lobe.sample(view, choice),
            Self::Passing => Some(ScatteringSample::passing(view)),
            Self::RoughGlass(lobe) => lobe.sample(view, place, choice),
            Self::Metal(lobe) => lobe.sample(view, place, choice),
            Self::Coated(lobe) => lobe.sample(view, place, choice),
        }
    }

    /// The two delta lobes of a smooth glass, each with its share for a weight, to follow both; `None` for all else.
    #[inline]
    pub fn branches(&self, view: DVec3) -> Option<[ScatteringSample; 2]> {
        if let Self::SmoothGlass(lobe) = self { lobe.branches(view) } else { None }
    }

    /// Share of the light that is reflected or transmitted, for pictures of the surface colour alone: over all directions,
    /// but at normal incidence for Phong's highlight and for metals.
    pub fn albedo(&self) -> Vec3 {
        match self {
            Self::Diffuse(lobe) => lobe.colour,
            Self::Phong(lobe) => lobe.diffuse + lobe.specular,
            Self::Mirror(lobe) => lobe.colour,
            Self::SmoothGlass(_) | Self::Passing | Self::RoughGlass(_) => Vec3::ONE,
            Self::Metal(lobe) => lobe.reflectance(1.0),
            Self::Coated(lobe) => lobe.albedo(),
        }
    }
}
