//! Importance sampling of the environment: directions sampled in proportion to their light.
//!
//! The pictures are cut into cells of one texel (or a few, in very large pictures). A cell is sampled by its power,
//! luminance times solid angle; then a point in the cell.

mod brightness;
mod cells;
mod face_sampler;
mod height_sampler;
mod inversion;
mod panorama_sampler;
mod texel_angles;
mod texel_means;

use super::environment::{Environment, EnvironmentKind};
use super::{Gradient, SignedAxis};
use crate::error::Result;
use crate::math::DVec3;
use brightness::BrightnessHistogram;
use face_sampler::FaceSampler;
use height_sampler::HeightSampler;
use panorama_sampler::PanoramaSampler;

/// Draws directions in proportion to the environment's luminance, by solid angle. Built once per scene, only if the
/// plan needs it.
///
/// (Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed., 12.5.2 and A.5.5, there for a single picture.)
#[derive(Debug)]
pub struct EnvironmentSampler {
    kind: SamplerKind,
    power: f64,
    concentration: f64,
}

#[derive(Debug)]
enum SamplerKind {
    Heights(HeightSampler),
    Faces(Box<FaceSampler>),
    Panorama(PanoramaSampler),
}

impl EnvironmentSampler {
    /// Reads the pictures of the environment, decoding those that were not decoded yet, in parallel. An error if one
    /// cannot be decoded.
    pub fn new(environment: &Environment) -> Result<Self> {
        let mut histogram = BrightnessHistogram::new();
        let kind = SamplerKind::new(&environment.kind, &mut histogram)?;
        let power = kind.power() * f64::from(environment.scale.abs());
        Ok(Self { kind, power, concentration: histogram.power_of_brightest(0.001) })
    }

    /// A unit direction and its density by solid angle; `None` if the environment is black. `place` is uniform in
    /// `[0, 1)^2`. Neighbouring places give neighbouring directions nearly everywhere, so strata are kept.
    #[inline]
    pub fn sample(&self, place: [f64; 2]) -> Option<(DVec3, f64)> {
        if self.power <= 0.0 {
            return None;
        }
        Some(match &self.kind {
            SamplerKind::Heights(sampler) => sampler.sample(place),
            SamplerKind::Faces(sampler) => sampler.sample(place),
            SamplerKind::Panorama(sampler) => sampler.sample(place),
        })
    }

    /// The density by solid angle with which [`EnvironmentSampler::sample`] draws a unit direction. It is positive
    /// wherever the radiance is.
    #[inline]
    pub fn density(&self, direction: DVec3) -> f64 {
        if self.power <= 0.0 {
            return 0.0;
        }
        match &self.kind {
            SamplerKind::Heights(sampler) => sampler.density(direction),
            SamplerKind::Faces(sampler) => sampler.density(direction),
            SamplerKind::Panorama(sampler) => sampler.density(direction),
        }
    }

    /// The integral of the luminance over the sphere, with the environment's scale.
    pub fn power(&self) -> f64 {
        self.power
    }

    /// How concentrated the light is: the share of the power that comes from the brightest directions that together
    /// make 1/1000 of the sphere. 0.001 for a uniform sky, nearly 1 for a sun, 0 for no light at all.
    pub fn concentration(&self) -> f64 {
        self.concentration
    }
}

impl SamplerKind {
    fn new(kind: &EnvironmentKind, histogram: &mut BrightnessHistogram) -> Result<Self> {
        let from_gradient = |gradient: &Gradient, histogram: &mut BrightnessHistogram| {
            let sampler = HeightSampler::new(gradient);
            sampler.spread(histogram);
            Self::Heights(sampler)
        };
        Ok(match kind {
            EnvironmentKind::Constant(radiance) => {
                let [zenith, horizon, nadir] = [*radiance; 3];
                from_gradient(&Gradient { up: SignedAxis::POS_Z, zenith, horizon, nadir }, histogram)
            }
            EnvironmentKind::Gradient(gradient) => from_gradient(gradient, histogram),
            EnvironmentKind::CubeMap(map) => Self::Faces(Box::new(FaceSampler::new(map, histogram)?)),
            EnvironmentKind::Equirectangular(map) => Self::Panorama(PanoramaSampler::new(map, histogram)?),
        })
    }

    fn power(&self) -> f64 {
        match self {
            Self::Heights(sampler) => sampler.power(),
            Self::Faces(sampler) => sampler.power(),
            Self::Panorama(sampler) => sampler.power(),
        }
    }
}
