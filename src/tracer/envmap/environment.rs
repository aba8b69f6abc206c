//! The environment: the radiance of rays that hit nothing.

use super::background::{Equirectangular, Gradient};
use super::cube_map::CubeMap;
use crate::error::Error;
use crate::math::{DVec3, Vec3};

/// The surroundings of a scene, infinitely far away: only the direction counts.
#[derive(Debug)]
pub struct Environment {
    /// Where the radiance comes from.
    pub kind: EnvironmentKind,
    /// Factor on all radiance.
    pub scale: f32,
}

/// The sources of environment radiance.
#[derive(Debug)]
pub enum EnvironmentKind {
    /// The same linear RGB radiance from everywhere.
    Constant(Vec3),
    /// Three colours blended by height.
    Gradient(Gradient),
    /// A panorama: longitude and latitude.
    Equirectangular(Equirectangular),
    /// Six images on the faces of a cube.
    CubeMap(Box<CubeMap>),
}

impl Environment {
    /// No light at all.
    pub const BLACK: Self = Self { kind: EnvironmentKind::Constant(Vec3::ZERO), scale: 1.0 };

    /// Linear radiance arriving from a unit direction.
    #[inline]
    pub fn radiance(&self, direction: DVec3) -> Vec3 {
        let radiance = match &self.kind {
            EnvironmentKind::CubeMap(map) => map.sample(direction.as_vec3()),
            EnvironmentKind::Constant(radiance) => *radiance,
            EnvironmentKind::Gradient(gradient) => gradient.sample(direction),
            EnvironmentKind::Equirectangular(map) => map.sample(direction),
        };
        radiance * self.scale
    }

    /// The cube map, if the environment is one.
    pub fn cube_map(&self) -> Option<&CubeMap> {
        match &self.kind {
            EnvironmentKind::CubeMap(map) => Some(map),
            _ => None,
        }
    }

    /// The cube map to change, if the environment is one.
    pub fn cube_map_mut(&mut self) -> Option<&mut CubeMap> {
        match &mut self.kind {
            EnvironmentKind::CubeMap(map) => Some(map),
            _ => None,
        }
    }

    /// The first picture that a ray reached and that could not be decoded.
    pub fn error(&self) -> Option<&Error> {
        match &self.kind {
            EnvironmentKind::CubeMap(map) => map.errors().next(),
            EnvironmentKind::Equirectangular(map) => map.image.error(),
            EnvironmentKind::Constant(_) | EnvironmentKind::Gradient(_) => None,
        }
    }
}
