//! The shading normal as a colour.

use super::observer::{Event, Observer};
use super::view::View;
use crate::math::{DVec3, Ray, Vec3};
use crate::scene::Scene;

/// `(n + 1) / 2` at the nearest hit, black where nothing is hit.
pub(super) fn radiance<O: Observer>(scene: &Scene, ray: &Ray, observer: &mut O) -> Vec3 {
    let radiance = match scene.shapes.intersect(ray) {
        Some(hit) => {
            let surface = scene.shapes.surface(ray, &hit);
            observer.note(|| View::new(&surface, ray.direction).hit(&surface, ray, hit.t, Vec3::ONE));
            let colour = colour(surface.shading_normal);
            observer.note(|| Event::Own { what: NORMAL_COLOUR, colour });
            colour
        }
        None => {
            observer.note(|| Event::Nothing);
            Vec3::ZERO
        }
    };
    observer.note(|| Event::End { radiance: Some(radiance) });
    radiance
}

/// What the colour of a normal is called.
pub(super) const NORMAL_COLOUR: &str = "shading normal as a colour, (n + 1) / 2";

/// A unit vector as a colour: each component from `[-1, 1]` to `[0, 1]`.
pub(super) fn colour(normal: DVec3) -> Vec3 {
    (normal.as_vec3() + 1.0) / 2.0
}
