//! Ideal diffuse reflection.

use std::f64::consts::FRAC_1_PI;

use super::scattering_sample::{Evaluation, ScatteringSample};
use crate::math::functions::sin_cos_turns;
use crate::math::{DVec3, Vec3};

/// Lambert's law: the same radiance in all directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diffuse {
    /// Reflectance, linear RGB in `[0, 1]`.
    pub colour: Vec3,
}

impl Diffuse {
    /// The value `colour / pi * cos`; zero for a light below the horizon.
    #[inline]
    pub fn evaluate(&self, light: DVec3) -> Evaluation {
        let density = cosine_density(light.z);
        Evaluation { value: self.colour * density as f32, density }
    }

    /// A direction with a density proportional to the cosine; `None` if the surface is black. `place` lies in `[0, 1)^2`.
    #[inline]
    pub fn sample(&self, place: [f64; 2]) -> Option<ScatteringSample> {
        let direction = cosine_direction(place);
        let density = cosine_density(direction.z);
        let weight = self.colour;
        (density > 0.0).then_some(ScatteringSample { direction, weight, density, specular: false, transmitted: false })
    }
}

/// A direction about +z with the density `cos / pi` (Malley's method: a disc projected upwards).
#[inline]
pub fn cosine_direction(place: [f64; 2]) -> DVec3 {
    let (sine, cosine) = sin_cos_turns(place[1]);
    let radius = place[0].sqrt();
    DVec3::new(radius * cosine, radius * sine, (1.0 - place[0]).sqrt())
}

/// The density of [`cosine_direction`], zero below the horizon.
#[inline]
pub fn cosine_density(cosine: f64) -> f64 {
    if cosine > 0.0 { cosine * FRAC_1_PI } else { 0.0 }
}
