//! Hit points of spheres, ellipsoids, boxes and planes.

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, worst_of};
use super::placed::{hit_error, placed, sphere_at};
use super::reference::{WideRay, distance, point_at, ulp_f32};
use crate::limits::{COORDINATE, RADIUS, Range, SCALE};
use crate::math::{DVec3, Ray, Side, SurfaceId};
use crate::random::Random;
use crate::shapes::{Geometry, Outline, Primitive};

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Shapes,
        name: "sphere-distance",
        swept: "distance / radius",
        error: "hit point, in f32 ulp of the larger of distance and radius",
        unit: "ulp",
        bound: 4.0,
        promised: Range::new(1e-9, 1e13),
        sweep: sphere_distance,
    },
    Subject {
        group: Group::Shapes,
        name: "sphere-f64",
        swept: "distance / radius",
        error: "the same, in f64 ulp",
        unit: "f64 ulp",
        bound: 32.0,
        promised: Range::new(1e-3, 1e6),
        sweep: sphere_double,
    },
    Subject {
        group: Group::Shapes,
        name: "sphere-remote",
        swept: "distance / radius",
        error: "hit point, in radii",
        unit: "radii",
        bound: 1e-6,
        promised: Range::new(1e-9, 1e6),
        sweep: sphere_remote,
    },
    Subject {
        group: Group::Shapes,
        name: "sphere-radius",
        swept: "radius, 1 above its top",
        error: "hit point, in units of the scene",
        unit: "units",
        bound: 1e-3,
        promised: RADIUS.range,
        sweep: ground_sphere,
    },
    Subject {
        group: Group::Shapes,
        name: "tangent",
        swept: "depth of the ray / radius",
        error: "hit point, in f32 ulp of the distance",
        unit: "ulp",
        bound: 4.0,
        promised: Range::new(1e-12, 1.0),
        sweep: tangent,
    },
    Subject {
        group: Group::Shapes,
        name: "chord",
        swept: "coordinate / radius",
        error: "other end of the chord of a ray from the surface, in radii",
        unit: "radii",
        bound: 1e-6,
        promised: Range::new(1.0, 1e6),
        sweep: chord,
    },
    Subject {
        group: Group::Shapes,
        name: "coordinates",
        swept: "coordinate, shape of size 1",
        error: "hit point on sphere, ellipsoid, box, in units of the scene",
        unit: "units",
        bound: 1e-6,
        promised: Range::new(1.0, COORDINATE.range.most),
        sweep: coordinates,
    },
    Subject {
        group: Group::Shapes,
        name: "plane-grazing",
        swept: "angle to the plane, rad",
        error: "hit point, in f32 ulp of the distance",
        unit: "ulp",
        bound: 4.0,
        promised: Range::new(1e-6, 1.0),
        sweep: plane_grazing,
    },
    Subject {
        group: Group::Shapes,
        name: "transforms",
        swept: "scale along an axis",
        error: "hit point on ellipsoid and box, one scale of either sign, in f32 ulp of the larger of distance and size",
        unit: "ulp",
        bound: 4.0,
        promised: SCALE.range,
        sweep: transforms,
    },
];

/// A sphere of any size somewhere, and a ray from this many radii off its surface to a point of its disc.
fn aimed_at_sphere(random: &mut Random, ratio: f64) -> (Primitive, Ray, f64) {
    let radius = loop {
        let radius = random.decade(-6, 6);
        // Outside of the distances only where no radius is left.
        if (1e-3..=1e7).contains(&(radius * ratio)) || !(1e-9..=1e13).contains(&ratio) {
            break radius;
        }
    };
    let span = ratio * radius;
    let centre = random.in_ball() * span.max(radius);
    let outwards = random.direction();
    let origin = centre + outwards * (radius + span);
    let target = centre + random.in_ball() * radius;
    (sphere_at(centre, radius), Ray::new(origin, (target - origin).normalize()), radius)
}

fn sweep_spheres(effort: Effort, unit: impl Fn(f64, f64) -> f64 + Sync) -> Vec<Measurement> {
    let of_ratio = |ratio: f64| {
        let (error, radius) = worst_of(effort.share(2e-3), ratio.to_bits(), |random| {
            let (sphere, ray, radius) = aimed_at_sphere(random, ratio);
            (hit_error(&sphere, &ray) / unit(radius, ratio * radius), radius)
        });
        Measurement::new(ratio, error, format!("radius {radius:.0e} at {:.0e}", radius * ratio))
    };
    decades(-12, 16).map(of_ratio).collect()
}

fn sphere_distance(effort: Effort) -> Vec<Measurement> {
    sweep_spheres(effort, |radius, distance| ulp_f32(radius.max(distance)))
}

fn sphere_double(effort: Effort) -> Vec<Measurement> {
    sweep_spheres(effort, |radius, distance| {
        let size = radius.max(distance);
        size.next_up() - size
    })
}

fn sphere_remote(effort: Effort) -> Vec<Measurement> {
    sweep_spheres(effort, |radius, _| radius)
}

/// A ground of a large sphere: seen from 1 above its top, from straight down to nearly the horizon. Small ones are seen from
/// as far.
fn ground_sphere(effort: Effort) -> Vec<Measurement> {
    let of_radius = |radius: f64| {
        let (error, slope) = worst_of(effort.share(1e-3), radius.to_bits(), |random| {
            let sphere = sphere_at(DVec3::new(0.0, 0.0, -radius), radius);
            let (sine, cosine) = crate::math::functions::sin_cos_turns(random.unit());
            // Down to the horizon, which lies sqrt(2 / radius) below the horizontal; a small sphere is aimed at.
            let slope = if radius > 10.0 {
                random.decade(-3, 0) + (2.0 / radius).sqrt()
            } else {
                1.0 / (random.unit() * 0.9 * radius).max(1e-9)
            };
            let ray = Ray::new(DVec3::Z, DVec3::new(cosine, sine, -slope).normalize());
            (hit_error(&sphere, &ray), slope)
        });
        Measurement::new(radius, error, format!("1 down on {:.1e} across", 1.0 / slope))
    };
    decades(-9, 16).map(of_radius).collect()
}

fn tangent(effort: Effort) -> Vec<Measurement> {
    let of_depth = |depth: f64| {
        let (error, distance) = worst_of(effort.share(1e-3), depth.to_bits(), |random| {
            let distance = random.decade(0, 4);
            let direction = random.direction();
            let aside = direction.any_orthonormal_vector();
            let centre = random.in_ball();
            let ray = Ray::new(centre - direction * (1.0 + distance) + aside * (1.0 - depth), direction);
            (hit_error(&sphere_at(centre, 1.0), &ray) / ulp_f32(distance + 1.0), distance)
        });
        Measurement::new(depth, error, format!("radius 1 at {distance:.0e}"))
    };
    decades(-16, 0).map(of_depth).collect()
}

/// A ray that leaves a sphere inwards meets it at the other end of the chord, wherever the sphere is.
fn chord(effort: Effort) -> Vec<Measurement> {
    let of_ratio = |ratio: f64| {
        let (error, radius) = worst_of(effort.share(1e-3), ratio.to_bits(), |random| {
            let radius = random.decade(-6, 6);
            let centre = random.direction() * (ratio * radius);
            let sphere = sphere_at(centre, radius);
            let origin = centre + random.direction() * radius;
            let direction = (centre + random.in_ball() * radius - origin).normalize();
            let departure = Some(crate::math::Departure { surface: SurfaceId { shape: 0, part: 0 }, side: Side::Back });
            let ray = Ray { origin, direction, departure };
            let truth = {
                let offset =
                    crate::math::Transform::from_parts(centre, DVec3::ZERO, DVec3::ONE).expect("a translation");
                let chord = WideRay::in_space_of(&offset, &ray).in_sphere(radius);
                point_at(&ray, chord.middle + chord.half_squared.sqrt())
            };
            let found = sphere.intersect(&ray, 0, f64::INFINITY).map(|hit| sphere.surface(&ray, &hit).position);
            (found.map_or(f64::INFINITY, |point| distance(point, truth) / radius), radius)
        });
        Measurement::new(ratio, error, format!("radius {radius:.0e}"))
    };
    decades(0, 16).map(of_ratio).collect()
}

/// Sphere, ellipsoid and box.
fn closed_shapes(translate: DVec3, turn: DVec3, size: f64) -> [(&'static str, Primitive); 3] {
    let uneven = DVec3::new(1.0, 0.5, 0.25) * size;
    [
        ("sphere", sphere_at(translate, size)),
        ("ellipsoid", placed(Geometry::Sphere, translate, turn, uneven)),
        ("box", placed(Geometry::Cuboid, translate, turn, uneven)),
    ]
}

fn coordinates(effort: Effort) -> Vec<Measurement> {
    let of_place = |place: f64| {
        let (error, name) = worst_of(effort.share(1e-3), place.to_bits(), |random| {
            let shapes = closed_shapes(random.direction() * place, random.in_ball() * 180.0, 1.0);
            let (name, shape) = &shapes[random.below(3)];
            let centre = shape.transform.to_world.translation;
            let origin = centre + random.direction() * 10.0;
            let target = centre + random.in_ball() * 0.2;
            (hit_error(shape, &Ray::new(origin, (target - origin).normalize())), *name)
        });
        Measurement::new(place, error, name)
    };
    decades(0, 14).map(of_place).collect()
}

/// A plane somewhere, turned anyhow, seen from a height of 1.
fn plane_grazing(effort: Effort) -> Vec<Measurement> {
    let of_angle = |angle: f64| {
        let (error, place) = worst_of(effort.share(1e-3), angle.to_bits(), |random| {
            let place = random.decade(0, 2);
            let turn = random.in_ball() * 180.0;
            let plane = placed(Geometry::Flat(Outline::Plane), random.direction() * place, turn, DVec3::ONE);
            let matrix = plane.transform.to_world.matrix3;
            let origin = plane.transform.to_world.translation + matrix.z_axis;
            let ray = Ray::new(origin, (matrix.x_axis - matrix.z_axis * angle).normalize());
            (hit_error(&plane, &ray) / ulp_f32(1.0 / angle), place)
        });
        Measurement::new(angle, error, format!("plane at {place:.0e}, height 1"))
    };
    decades(-12, 0).map(of_angle).collect()
}

fn transforms(effort: Effort) -> Vec<Measurement> {
    let of_scale = |scale: f64| {
        let (error, (name, other)) = worst_of(effort.share(1e-3), scale.to_bits(), |random| {
            let other = random.decade(-4, 4);
            let sign = if random.unit() < 0.5 { -1.0 } else { 1.0 };
            let scales = DVec3::new(sign * scale, other, 1.0);
            let (name, geometry) =
                if random.unit() < 0.5 { ("ellipsoid", Geometry::Sphere) } else { ("box", Geometry::Cuboid) };
            let shape = placed(geometry, random.in_ball(), random.in_ball() * 180.0, scales);
            let size = scales.abs().max_element();
            let to_world = shape.transform.to_world;
            let origin = to_world.transform_point3(random.direction() * 3.0);
            let target = to_world.transform_point3(random.in_ball() * 0.5);
            let far = (target - origin).length();
            (hit_error(&shape, &Ray::new(origin, (target - origin) / far)) / ulp_f32(far.max(size)), (name, other))
        });
        Measurement::new(scale, error, format!("{name} {scale:.0e} x {other:.0e} x 1"))
    };
    decades(-10, 10).map(of_scale).collect()
}
