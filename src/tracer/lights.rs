//! Light sources without extent: they reach a point from one direction.

use crate::math::{DVec3, Vec3};

/// A light source. Colours are linear RGB, unbounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// The same radiance from everywhere, unshadowed: a stand-in for light reflected many times.
    Ambient {
        /// Per steradian, from every direction.
        radiance: Vec3,
    },
    /// Parallel light. `direction` is the unit direction it travels in, `irradiance` what a surface facing it gets.
    Directional {
        /// From the light to the scene.
        direction: DVec3,
        /// On a surface that faces the light.
        irradiance: Vec3,
    },
    /// Light from a point, in all directions.
    Point {
        /// In the world.
        position: DVec3,
        /// Power per steradian.
        intensity: Vec3,
        /// How the light decreases with distance.
        falloff: Falloff,
    },
    /// Light from a point in a cone.
    Spot {
        /// In the world.
        position: DVec3,
        /// Power per steradian, within the inner angle.
        intensity: Vec3,
        /// How the light decreases with distance.
        falloff: Falloff,
        /// Axis and angles.
        cone: Cone,
    },
}

/// How the light of a point grows weaker with distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum Falloff {
    /// Physical: irradiance = intensity / distance^2.
    #[default]
    InverseSquare,
    /// The simplification of the first lessons: irradiance = intensity at any distance.
    Constant,
}

/// The cone of a spot: full light within the inner angle, none beyond the outer one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Unit direction of the cone's axis, away from the light.
    pub axis: DVec3,
    /// Cosine of the inner angle, measured from the axis.
    pub cos_inner: f64,
    /// Cosine of the outer angle; at most `cos_inner`.
    pub cos_outer: f64,
}

/// Light arriving at a point from one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Illumination {
    /// Unit direction from the point to the light.
    pub to_light: DVec3,
    /// Distance to the light; infinite for parallel light.
    pub distance: f64,
    /// Irradiance on a surface that faces the light.
    pub irradiance: Vec3,
}

impl Light {
    /// The point of origin of its light; `None` if the light has no position.
    pub fn position(&self) -> Option<DVec3> {
        match *self {
            Light::Point { position, .. } | Light::Spot { position, .. } => Some(position),
            Light::Ambient { .. } | Light::Directional { .. } => None,
        }
    }

    /// True if something between light and point can shadow it.
    pub fn casts_shadows(&self) -> bool {
        !matches!(self, Light::Ambient { .. })
    }

    /// What arrives at `point` if nothing is in between; `None` where no light is sent, and for ambient light.
    #[inline]
    pub fn illumination(&self, point: DVec3) -> Option<Illumination> {
        match *self {
            Light::Ambient { .. } => None,
            Light::Directional { direction, irradiance } => {
                Some(Illumination { to_light: -direction, distance: f64::INFINITY, irradiance })
            }
            Light::Point { position, intensity, falloff } => from_point(position, intensity, falloff, point),
            Light::Spot { position, intensity, falloff, cone } => {
                let arriving = from_point(position, intensity, falloff, point)?;
                let share = cone.share(-arriving.to_light);
                (share > 0.0).then_some(Illumination { irradiance: arriving.irradiance * share as f32, ..arriving })
            }
        }
    }
}

impl Cone {
    /// Share of the full intensity sent in a unit direction, in `[0, 1]`, smooth between inner and outer angle.
    fn share(&self, direction: DVec3) -> f64 {
        let cosine = direction.dot(self.axis);
        if cosine >= self.cos_inner {
            return 1.0;
        }
        let x = ((cosine - self.cos_outer) / (self.cos_inner - self.cos_outer)).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    }
}

fn from_point(position: DVec3, intensity: Vec3, falloff: Falloff, point: DVec3) -> Option<Illumination> {
    let offset = position - point;
    let distance = offset.length();
    if distance == 0.0 {
        return None;
    }
    let weight = match falloff {
        Falloff::InverseSquare => (1.0 / (distance * distance)) as f32,
        Falloff::Constant => 1.0,
    };
    Some(Illumination { to_light: offset / distance, distance, irradiance: (intensity * weight).min(Vec3::MAX) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn point_light_falls_off_with_the_square_of_the_distance() {
        let light =
            Light::Point { position: DVec3::Z * 2.0, intensity: Vec3::ONE * 8.0, falloff: Falloff::InverseSquare };
        let arriving = light.illumination(DVec3::ZERO).unwrap();
        assert_eq!((arriving.to_light, arriving.distance, arriving.irradiance), (DVec3::Z, 2.0, Vec3::ONE * 2.0));
        assert_eq!(light.illumination(DVec3::Z * 2.0), None);
    }

    #[test]
    fn spot_is_full_inside_and_dark_outside() {
        let cone = Cone { axis: DVec3::NEG_Z, cos_inner: 0.9, cos_outer: 0.8 };
        let share = |cosine: f64| cone.share(DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, -cosine));
        assert_eq!((share(1.0), share(0.91), share(0.79)), (1.0, 1.0, 0.0));
        assert!((share(0.85) - 0.5).abs() < 1e-12);
    }
}
