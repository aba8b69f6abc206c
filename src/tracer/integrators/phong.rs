//! Local light and shadows: what the light sources show of the nearest surface.

use super::Task;
use super::direct::{View, local_radiance};
use super::observer::{Event, Observer};
use crate::math::{Ray, Vec3};

/// Radiance along a ray; mirrors and glass stay black, since nothing is followed any further.
pub(super) fn radiance<O: Observer>(mut task: Task<O>, ray: &Ray) -> Vec3 {
    let radiance = nearest_radiance(&mut task, ray);
    task.observer.note(|| Event::End { radiance: Some(radiance) });
    radiance
}

#[inline(always)]
fn nearest_radiance<O: Observer>(task: &mut Task<O>, ray: &Ray) -> Vec3 {
    let Task { scene, plan, counts, observer, .. } = task;
    let Some(hit) = scene.shapes.intersect(ray) else {
        counts.environment += 1;
        let environment = scene.environment.radiance(ray.direction);
        observer.note(|| Event::Missed { direction: ray.direction, environment, transmittance: Vec3::ONE });
        return environment;
    };
    let surface = scene.shapes.surface(ray, &hit);
    let view = View::new(&surface, ray.direction);
    observer.note(|| view.hit(&surface, ray, hit.t, Vec3::ONE));
    local_radiance(scene, plan, ray, &surface, &view, counts, *observer)
}
