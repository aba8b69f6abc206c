//! Rays through several surfaces: thin shells, surfaces that touch or coincide, nested glasses, mirrors that face each other.

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, faults_of, worst_of};
use super::placed::{placed, sphere_at};
use super::reference::ulp_f32;
use super::wide::Wide;
use crate::limits::{NESTING, Range};
use crate::materials::fresnel::{boundary, reflect, refract};
use crate::materials::{Medium, MediumStack};
use crate::math::{DVec3, Departure, Ray, Side, SurfaceId};
use crate::random::{Random, power_of_ten};
use crate::scene::Aggregate;
use crate::shapes::{Geometry, Outline, Primitive};

const WRONG: &str = "rays through a wrong glass, per million";

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Optics,
        name: "shell",
        swept: "thickness / radius of a shell",
        error: "refracted rays that hit its surfaces in a wrong order, per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1e-6, 0.1),
        sweep: shell,
    },
    Subject {
        group: Group::Optics,
        name: "touching",
        swept: "gap / radius of two spheres",
        error: WRONG,
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1e-16, 1.0),
        sweep: touching,
    },
    Subject {
        group: Group::Optics,
        name: "coincident",
        swept: "size of boxes on one face",
        error: WRONG,
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1e-6, 1e6),
        sweep: coincident,
    },
    Subject {
        group: Group::Optics,
        name: "nested",
        swept: "glasses inside one another",
        error: WRONG,
        unit: "ppm",
        bound: 0.0,
        promised: NESTING.range,
        sweep: nested,
    },
    Subject {
        group: Group::Optics,
        name: "mirrors",
        swept: "bounces between two mirrors",
        error: "hit point, in f32 ulp of the distance travelled",
        unit: "ulp",
        bound: 4.0,
        promised: Range::new(1.0, 64.0),
        sweep: mirrors,
    },
];

/// A crossing of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Crossing {
    id: SurfaceId,
    side: Side,
}

/// The surfaces a ray goes through, at most 64. `bend` gives the ray's direction beyond each, from the direction before it
/// and the normal that looks against it.
fn crossings(
    shapes: &Aggregate,
    mut ray: Ray,
    mut bend: impl FnMut(&Crossing, DVec3, DVec3) -> DVec3,
) -> Vec<Crossing> {
    let mut found = Vec::new();
    while let Some(hit) = shapes.intersect(&ray).filter(|_| found.len() < 64) {
        let surface = shapes.surface(&ray, &hit);
        let side = Side::of(-ray.direction, surface.normal);
        let crossing = Crossing { id: surface.id, side };
        found.push(crossing);
        let normal = if side == Side::Front { surface.normal } else { -surface.normal };
        let departure = Some(Departure { surface: surface.id, side: side.opposite() });
        ray = Ray { origin: surface.position, direction: bend(&crossing, ray.direction, normal), departure };
    }
    found
}

/// A hollow sphere of glass: refracted in and out of both its surfaces.
fn shell(effort: Effort) -> Vec<Measurement> {
    let order = [(0, Side::Front), (1, Side::Front), (1, Side::Back), (0, Side::Back)];
    let of_thickness = |thickness: f64| {
        let (faults, first) = faults_of(effort.share(5e-4), thickness.to_bits(), |random| {
            let (radius, centre) = (random.decade(-3, 3), random.in_ball());
            let centre = centre * radius;
            let shapes = Aggregate::new(vec![sphere_at(centre, radius), sphere_at(centre, radius * (1.0 - thickness))]);
            let origin = centre + random.direction() * (5.0 * radius);
            let target = centre + random.in_ball() * (0.6 * radius * (1.0 - thickness));
            let ray = Ray::new(origin, (target - origin).normalize());
            let found = crossings(&shapes, ray, |crossing, direction, normal| {
                let enters_glass = (crossing.id.shape == 0) == (crossing.side == Side::Front);
                let index = if enters_glass { 1.0 / 1.5 } else { 1.5 };
                let refracted = boundary(-direction.dot(normal), index).cos_transmitted;
                refracted.map_or(direction, |_| refract(direction, normal, index))
            });
            let right = found.len() == 4
                && found.iter().zip(order).all(|(found, (shape, side))| (found.id.shape, found.side) == (shape, side));
            (!right).then_some((found.len(), radius))
        });
        let input = first.map_or("none".to_owned(), |(count, radius)| format!("{count} hits, radius {radius:.0e}"));
        Measurement::new(thickness, faults, input)
    };
    decades(-17, -1).map(of_thickness).collect()
}

/// True if light takes each stretch of its straight way through the right glass, and ends in none. `glass_at` tells the
/// shape that a point is in; stretches within `tolerance` do not count.
fn takes_right_glasses(
    shapes: &Aggregate,
    mut ray: Ray,
    tolerance: f64,
    glass_at: impl Fn(DVec3) -> Option<u32>,
) -> bool {
    let mut media = MediumStack::default();
    for _ in 0..64 {
        media = shapes.settled(&media, &ray);
        let Some(hit) = shapes.intersect(&ray) else { return media.innermost().is_none() };
        let surface = shapes.surface(&ray, &hit);
        let side = Side::of(-ray.direction, surface.normal);
        let met = Medium { shape: surface.id.shape, material: 0 };
        let through = media.before(met, side).map(|medium| medium.shape);
        if hit.t > tolerance && through != glass_at(ray.at(0.5 * hit.t)) {
            return false;
        }
        media.pass(met, side);
        let departure = Some(Departure { surface: surface.id, side: side.opposite() });
        ray = Ray { origin: surface.position, departure, ..ray };
    }
    false
}

fn ppm_of(magnitude: f64, (faults, first): (f64, Option<f64>), what: &str) -> Measurement {
    let input = first.map_or("none".to_owned(), |figure| format!("{what} {figure:.1e}"));
    Measurement::new(magnitude, faults, input)
}

/// Two spheres side by side, and the ray through their near contact.
fn touching(effort: Effort) -> Vec<Measurement> {
    let of_gap = |gap: f64| {
        let faults = faults_of(effort.share(5e-4), gap.to_bits(), |random| {
            let radius = random.decade(-3, 3);
            let axis = random.direction();
            let centres = [-axis * radius, axis * (radius * (1.0 + gap))];
            let shapes = Aggregate::new(centres.map(|centre| sphere_at(centre, radius)).to_vec());
            let aside = axis.any_orthonormal_vector() * (random.decade(-16, -1) * radius);
            let ray = Ray::new(aside - axis * (5.0 * radius), axis);
            let glass_at = |point: DVec3| {
                (0..2).find(|&sphere| (point - centres[sphere]).length() < radius).map(|sphere| sphere as u32)
            };
            (!takes_right_glasses(&shapes, ray, 1e-9 * radius, glass_at)).then_some(radius)
        });
        ppm_of(gap, faults, "radius")
    };
    decades(-18, 0).map(of_gap).collect()
}

/// A box on a box: they share a face, and rounding decides which is met first.
fn coincident(effort: Effort) -> Vec<Measurement> {
    let of_size = |size: f64| {
        let faults = faults_of(effort.share(5e-4), size.to_bits(), |random| {
            let heights = [size * (0.5 + random.unit()), size * (0.5 + random.unit())];
            let floor = random.unit() * size;
            let stacked = |floor: f64, height: f64| {
                let half = DVec3::new(size, size, 0.5 * height);
                placed(Geometry::Cuboid, DVec3::new(0.0, 0.0, floor + 0.5 * height), DVec3::ZERO, half)
            };
            let shapes = Aggregate::new(vec![stacked(floor, heights[0]), stacked(floor + heights[0], heights[1])]);
            let inside = |random: &mut Random| (random.in_ball() * 0.4 * size).truncate();
            let (below, above) = (inside(random).extend(floor - size), inside(random).extend(floor + 4.0 * size));
            let (from, to) = if random.unit() < 0.5 { (below, above) } else { (above, below) };
            let glass_at = |point: DVec3| {
                let height = point.z - floor;
                let within = (0.0..heights[0] + heights[1]).contains(&height);
                within.then_some(u32::from(height > heights[0]))
            };
            let ray = Ray::new(from, (to - from).normalize());
            (!takes_right_glasses(&shapes, ray, 1e-9 * size, glass_at)).then_some(heights[0])
        });
        ppm_of(size, faults, "height")
    };
    decades(-9, 9).map(of_size).collect()
}

/// Spheres inside of one another.
fn nested(effort: Effort) -> Vec<Measurement> {
    let of_depth = |depth: u32| {
        let faults = faults_of(effort.share(2e-4), u64::from(depth), |random| {
            let radius = |shell: u32| 1.0 - f64::from(shell) * 0.05;
            let shapes = Aggregate::new((0..depth).map(|shell| sphere_at(DVec3::ZERO, radius(shell))).collect());
            let origin = random.direction() * 5.0;
            let target = random.in_ball() * 0.3;
            let glass_at = |point: DVec3| (0..depth).rev().find(|&shell| point.length() < radius(shell));
            let ray = Ray::new(origin, (target - origin).normalize());
            (!takes_right_glasses(&shapes, ray, 1e-9, glass_at)).then_some(f64::from(depth))
        });
        ppm_of(f64::from(depth), faults, "depth")
    };
    (1..=12).map(of_depth).collect()
}

/// A ray up and down between two planes: each bounce is one gap further up in the unfolded world.
fn mirrors(effort: Effort) -> Vec<Measurement> {
    let planes: [Primitive; 2] = [0.0, 1.0]
        .map(|height| placed(Geometry::Flat(Outline::Plane), DVec3::new(0.0, 0.0, height), DVec3::ZERO, DVec3::ONE));
    let shapes = Aggregate::new(planes.to_vec());
    let of_bounces = |bounces: i32| {
        let (error, slope) = worst_of(effort.share(2e-4).min(1_000), bounces as u64, |random| {
            let slope = power_of_ten(random.below(4) as i32) * (0.5 + random.unit());
            let start = DVec3::new(slope, slope, 1.0).normalize();
            let mut ray = Ray::new(DVec3::new(0.0, 0.0, 0.5), start);
            let mut position = ray.origin;
            for _ in 0..bounces {
                let Some(hit) = shapes.intersect(&ray) else { return (f64::INFINITY, slope) };
                let surface = shapes.surface(&ray, &hit);
                let side = Side::of(-ray.direction, surface.normal);
                position = surface.position;
                let departure = Some(Departure { surface: surface.id, side });
                ray = Ray { origin: position, direction: reflect(ray.direction, surface.normal), departure };
            }
            let travelled = Wide::from(f64::from(bounces) - 0.5) / Wide::from(start.z);
            let off = [0, 1].map(|axis| (Wide::from(position[axis]) - travelled * start[axis].into()).value());
            ((off[0] * off[0] + off[1] * off[1]).sqrt() / ulp_f32(travelled.value()), slope)
        });
        Measurement::new(f64::from(bounces), error, format!("slope {slope:.1e}"))
    };
    (0..=12).map(|power| of_bounces(1 << power)).collect()
}
