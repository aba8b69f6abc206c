//! Self-intersection: rays that start on a surface must neither hit it again nor miss it.
//!
//! ```text
//!      primary      reflected, shadow: leave to the front, must not hit the convex shape again
//!          \  ^  ^
//!           \ | /
//!      ------\|/------        refracted: leaves to the back, must meet the closed shape from inside,
//!     (        \       )      again and again
//!      `---------\----'
//! ```

use std::sync::Arc;

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, faults_of};
use super::octasphere::octasphere;
use super::placed::{placed, sphere_at};
use crate::limits::REMOTENESS;
use crate::materials::fresnel::{reflect, refract};
use crate::math::{DVec3, Departure, Ray, Side};
use crate::random::Random;
use crate::shapes::mesh::Mesh;
use crate::shapes::{Geometry, Outline, Primitive, Surface};

const fn subject(name: &'static str, swept: &'static str, sweep: fn(Effort) -> Vec<Measurement>) -> Subject {
    Subject {
        group: Group::SelfIntersection,
        name,
        swept,
        error: "false hits and missed hits per million rays",
        unit: "ppm",
        bound: 0.0,
        promised: crate::limits::Range::new(1.0, REMOTENESS.range.most),
        sweep,
    }
}

pub(super) const SUBJECTS: &[Subject] = &[
    subject("self-sphere", "coordinate / size, sphere", |effort| sweep(effort, Kind::Sphere)),
    subject("self-ellipsoid", "coordinate / size, ellipsoid", |effort| sweep(effort, Kind::Ellipsoid)),
    subject("self-box", "coordinate / size, box", |effort| sweep(effort, Kind::Box)),
    subject("self-flat", "coordinate / size, rectangle", |effort| sweep(effort, Kind::Flat)),
    subject("self-mesh", "coordinate / size, mesh", |effort| sweep(effort, Kind::Mesh)),
];

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Sphere,
    Ellipsoid,
    Box,
    Flat,
    Mesh,
}

/// Rays spawned for each primary ray: two outwards, four inside.
const SPAWNED: usize = 6;

/// Decades of place over size.
const STEPS: (i32, i32) = (0, 10);

fn sweep(effort: Effort, kind: Kind) -> Vec<Measurement> {
    let mesh = Arc::new(Mesh::new(octasphere(6)).expect("a mesh"));
    let rays = effort.share(1.0 / (5.0 * (STEPS.1 - STEPS.0 + 1) as f64));
    let of_ratio = |ratio: f64| {
        let (faults, first) = faults_of(rays.div_ceil(SPAWNED), ratio.to_bits(), |random| {
            let size = random.decade(-6, 6);
            let shape = shape(kind, &mesh, random, size, ratio * size);
            fault(&shape, random, size).map(|what| (what, size))
        });
        let input = first.map_or_else(|| "none".to_owned(), |(what, size)| format!("{what}, size {size:.0e}"));
        Measurement::new(ratio, faults / SPAWNED as f64, input)
    };
    decades(STEPS.0, STEPS.1).map(of_ratio).collect()
}

fn shape(kind: Kind, mesh: &Arc<Mesh>, random: &mut Random, size: f64, place: f64) -> Primitive {
    let (translate, turn) = (random.direction() * place, random.in_ball() * 180.0);
    let uneven = DVec3::new(1.0, 0.5, 0.25) * size;
    match kind {
        Kind::Sphere => sphere_at(translate, size),
        Kind::Ellipsoid => placed(Geometry::Sphere, translate, turn, uneven),
        Kind::Box => placed(Geometry::Cuboid, translate, turn, uneven),
        Kind::Flat => placed(Geometry::Flat(Outline::Rectangle), translate, turn, uneven),
        Kind::Mesh => placed(Geometry::Mesh(mesh.clone()), translate, turn, DVec3::splat(size)),
    }
}

/// Follows one ray to the shape and those it spawns; what goes wrong first.
fn fault(shape: &Primitive, random: &mut Random, size: f64) -> Option<&'static str> {
    let to_world = shape.transform.to_world;
    let flat = matches!(shape.geometry, Geometry::Flat(_));
    let origin = to_world.translation + random.direction() * (10.0 * size);
    let inside = random.in_ball() * 0.4;
    let target = to_world.transform_point3(if flat { DVec3 { z: 0.0, ..inside } } else { inside });
    let ray = Ray::new(origin, (target - origin).normalize());
    let Some(hit) = shape.intersect(&ray, 0, f64::INFINITY) else { return Some("camera ray missed") };
    let surface = shape.surface(&ray, &hit);
    let towards_viewer = Side::of(-ray.direction, surface.normal);
    if !flat && towards_viewer == Side::Back {
        return Some("hit from inside");
    }
    let normal = if towards_viewer == Side::Front { surface.normal } else { -surface.normal };
    let reflected = on_side(reflect(ray.direction, normal), normal);
    let shadow = on_side(random.direction(), normal);
    for (what, direction) in [("reflected ray hits itself", reflected), ("shadow ray hits itself", shadow)] {
        if meets(shape, &departing(&surface, direction, towards_viewer)) {
            return Some(what);
        }
    }
    let index = 1.0 / 1.5;
    let refracted = on_side(refract(ray.direction, normal, index), -normal);
    let entering = departing(&surface, refracted, towards_viewer.opposite());
    if flat {
        return meets(shape, &entering).then_some("refracted ray hits itself");
    }
    trapped(shape, entering, random)
}

/// Four bounces inside of a closed shape, and a way out at the end.
fn trapped(shape: &Primitive, mut ray: Ray, random: &mut Random) -> Option<&'static str> {
    for bounce in 0..4 {
        let Some(hit) = shape.intersect(&ray, 0, f64::INFINITY) else {
            return Some(if bounce == 0 { "refracted ray leaks" } else { "inner reflection leaks" });
        };
        if !shape.occludes(&ray, 0, f64::INFINITY) {
            return Some("shadow ray leaks");
        }
        let surface = shape.surface(&ray, &hit);
        let normal = -surface.normal;
        let onwards = if bounce % 2 == 0 { reflect(ray.direction, normal) } else { random.direction() };
        let outwards = departing(&surface, on_side(ray.direction, -normal), Side::Front);
        if meets(shape, &outwards) {
            return Some("leaving ray hits itself");
        }
        ray = departing(&surface, on_side(onwards, normal), Side::Back);
    }
    None
}

/// Whether a ray finds the shape again, by either question.
fn meets(shape: &Primitive, ray: &Ray) -> bool {
    shape.intersect(ray, 0, f64::INFINITY).is_some() || shape.occludes(ray, 0, f64::INFINITY)
}

fn departing(surface: &Surface, direction: DVec3, side: Side) -> Ray {
    Ray { origin: surface.position, direction, departure: Some(Departure { surface: surface.id, side }) }
}

/// The direction, mirrored to the side of the normal if it is not there.
fn on_side(direction: DVec3, normal: DVec3) -> DVec3 {
    if direction.dot(normal) < 0.0 { reflect(direction, normal) } else { direction }
}
