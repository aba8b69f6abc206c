//! The shading normal as a colour.

use crate::math::{DVec3, Ray, Vec3};
use crate::scene::Scene;

/// `(n + 1) / 2` at the nearest hit, black where nothing is hit.
pub(super) fn radiance(scene: &Scene, ray: &Ray) -> Vec3 {
    match scene.shapes.intersect(ray) {
        Some(hit) => colour(scene.shapes.surface(ray, &hit).shading_normal),
        None => Vec3::ZERO,
    }
}

/// A unit vector as a colour: each component from `[-1, 1]` to `[0, 1]`.
pub(super) fn colour(normal: DVec3) -> Vec3 {
    (normal.as_vec3() + 1.0) / 2.0
}
