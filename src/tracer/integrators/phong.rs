//! Local light and shadows: what the light sources show of the nearest surface.

use super::RayCounts;
use super::direct::{View, local_radiance};
use super::observer::{Event, Observer, RayKind};
use crate::math::{Ray, Vec3};
use crate::scene::{Plan, Scene};

/// Radiance along a ray; mirrors and glass stay black, since nothing is followed any further.
pub(super) fn radiance<O: Observer>(
    scene: &Scene,
    plan: &Plan,
    ray: &Ray,
    counts: &mut RayCounts,
    observer: &mut O,
) -> Vec3 {
    observer.note(|| Event::Ray { kind: RayKind::Camera, ray: *ray, factor: Vec3::ONE });
    let radiance = nearest_radiance(scene, plan, ray, counts, observer);
    observer.note(|| Event::End { radiance: Some(radiance) });
    radiance
}

#[inline(always)]
fn nearest_radiance<O: Observer>(
    scene: &Scene,
    plan: &Plan,
    ray: &Ray,
    counts: &mut RayCounts,
    observer: &mut O,
) -> Vec3 {
    let Some(hit) = scene.shapes.intersect(ray) else {
        counts.environment += 1;
        let environment = scene.environment.radiance(ray.direction);
        observer.note(|| Event::Missed { direction: ray.direction, environment, transmittance: Vec3::ONE });
        return environment;
    };
    let surface = scene.shapes.surface(ray, &hit);
    let view = View::new(&surface, ray.direction);
    observer.note(|| view.hit(&surface, ray, hit.t, Vec3::ONE));
    local_radiance(scene, plan, ray, &surface, &view, counts, observer)
}
