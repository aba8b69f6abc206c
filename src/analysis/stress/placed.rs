//! Shapes placed in the world, and the errors of their hits.

use super::reference::{Chord, WideRay, distance, point_at};
use crate::math::{DVec3, Ray, Transform};
use crate::shapes::{Geometry, MaterialChoice, Outline, Primitive};

/// A shape at a place, turned (degrees), scaled along its axes.
pub fn placed(geometry: Geometry, translate: DVec3, turn: DVec3, scale: DVec3) -> Primitive {
    let transform = Transform::from_parts(translate, turn, scale).expect("scales are not zero");
    Primitive::new(geometry, transform, MaterialChoice::Whole(0), true)
}

/// A round sphere.
pub fn sphere_at(centre: DVec3, radius: f64) -> Primitive {
    placed(Geometry::Sphere, centre, DVec3::ZERO, DVec3::splat(radius))
}

/// Distance between the point where the kernels say that a ray from free space hits a shape, and the true one.
///
/// A hit that is overlooked is off by half the chord, one that is none by as much as the line misses: both are what
/// rounding the line's place does.
pub fn hit_error(primitive: &Primitive, ray: &Ray) -> f64 {
    let found = primitive.intersect(ray, 0, f64::INFINITY).map(|hit| primitive.surface(ray, &hit).position);
    let local = WideRay::in_space_of(&primitive.transform, ray);
    let chord = match (&primitive.geometry, primitive.as_sphere()) {
        (_, Some((_, radius))) => {
            let offset = Transform::from_parts(primitive.transform.to_world.translation, DVec3::ZERO, DVec3::ONE);
            WideRay::in_space_of(&offset.expect("a translation"), ray).in_sphere(radius)
        }
        (Geometry::Sphere, None) => local.in_sphere(1.0),
        (Geometry::Cuboid, _) => local.in_cube(),
        (Geometry::Flat(Outline::Plane), _) => {
            let truth = point_at(ray, local.at_plane());
            return found.map_or(f64::INFINITY, |point| distance(point, truth));
        }
        _ => unreachable!("no reference for this shape"),
    };
    of_chord(&chord, ray, found)
}

fn of_chord(chord: &Chord, ray: &Ray, found: Option<DVec3>) -> f64 {
    match (chord.nearest(), found) {
        (Some(parameter), Some(point)) => distance(point, point_at(ray, parameter)),
        (None, None) => 0.0,
        _ => chord.half() * ray.direction.length(),
    }
}
