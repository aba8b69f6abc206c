//! Local light and shadows: what the light sources show of the nearest surface.

use super::RayCounts;
use super::direct::{View, local_radiance};
use crate::math::{Ray, Vec3};
use crate::scene::{Plan, Scene};

/// Radiance along a ray; mirrors and glass stay black, since nothing is followed any further.
pub(super) fn radiance(scene: &Scene, plan: &Plan, ray: &Ray, counts: &mut RayCounts) -> Vec3 {
    let Some(hit) = scene.shapes.intersect(ray) else {
        counts.environment += 1;
        return scene.environment.radiance(ray.direction);
    };
    let surface = scene.shapes.surface(ray, &hit);
    let view = View::new(&surface, ray.direction);
    local_radiance(scene, plan, ray, &surface, &view, counts)
}
