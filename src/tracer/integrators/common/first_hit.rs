//! The first hit of a camera ray, for the layers of a picture.

use super::view::View;
use crate::math::{DVec3, Ray, Vec3};
use crate::scene::Scene;

/// What a camera ray meets first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstHit {
    /// Unit shading normal in the world, on the viewer's side.
    pub normal: DVec3,
    /// Share of the light that is reflected or transmitted.
    pub albedo: Vec3,
    /// From the ray's origin, in units of the world.
    pub distance: f64,
}

impl FirstHit {
    /// What a camera ray meets first; `None` if nothing.
    pub fn of(scene: &Scene, ray: &Ray) -> Option<Self> {
        let hit = scene.shapes.intersect(ray)?;
        let surface = scene.shapes.surface(ray, &hit);
        let albedo = scene.materials[surface.material as usize].albedo(surface.texture);
        Some(Self { normal: View::new(&surface, ray.direction).shading_normal, albedo, distance: hit.t })
    }
}
