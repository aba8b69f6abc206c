//! The shading normal as a colour: the first picture of a ray tracer with shapes.

use crate::integrators::common::observer::{Event, Observer};
use crate::integrators::common::task::Task;
use crate::integrators::common::view::{NORMAL_COLOUR, View, normal_colour};
use crate::math::{Ray, Vec3};

/// `(n + 1) / 2` at the nearest hit, black where nothing is hit.
pub fn radiance<O: Observer>(task: &mut Task<O>, ray: &Ray) -> Vec3 {
    let radiance = match task.scene.shapes.intersect(ray) {
        Some(hit) => {
            let surface = task.scene.shapes.surface(ray, &hit);
            task.observer.note(|| View::new(&surface, ray.direction).hit(&surface, ray, hit.t, Vec3::ONE));
            let colour = normal_colour(surface.shading_normal);
            task.observer.note(|| Event::Own { what: NORMAL_COLOUR, colour });
            colour
        }
        None => {
            task.observer.note(|| Event::Nothing);
            Vec3::ZERO
        }
    };
    task.observer.note(|| Event::End { radiance: Some(radiance) });
    radiance
}
