//! The mean of 1 / density over what is drawn is the solid angle under which a shape is seen.

use std::f64::consts::PI;

use skycube::math::{DVec3, Ray, Transform};
use skycube::shapes::{Geometry, Outline, Primitive, ShapeSampler};
use skycube::stress::Random;

use crate::histogram::deviation;
use crate::shape_hits::{mesh, placed, primitive, sampler, shapes, viewers};
use crate::support::{cube_bin, cube_integrals, mean_and_error, point_on_cube};

/// Solid angle from 1 / density, and its standard error; samples that something else of the shape hides count nothing.
fn estimated(primitive: &Primitive, sampler: &ShapeSampler, point: DVec3, samples: usize) -> (f64, f64) {
    let mut random = Random(17);
    let values: Vec<f64> = (0..samples)
        .map(|_| {
            let Some(sample) = sampler.sample_towards(point, [random.unit(), random.unit()], random.unit()) else {
                return 0.0;
            };
            let reach = sample.distance * (1.0 - 1e-6);
            let hidden = primitive.intersect(&Ray::new(point, sample.to_shape), 0, reach).is_some();
            if hidden { 0.0 } else { 1.0 / sample.density }
        })
        .collect();
    mean_and_error(&values)
}

/// Van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983.
fn triangle_solid_angle(corners: [DVec3; 3]) -> f64 {
    let [a, b, c] = corners.map(DVec3::normalize);
    2.0 * a.dot(b.cross(c)).abs().atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

fn check(name: &str, primitive: &Primitive, point: DVec3, wanted: f64) {
    let sampler = sampler(primitive);
    let (mean, error) = estimated(primitive, &sampler, point, 20_000);
    assert!((mean - wanted).abs() < 3.0 * error + 1e-9 * wanted, "{name} from {point}: {mean} +- {error}, {wanted}");
}

#[test]
fn spheres_have_the_solid_angle_of_their_cone() {
    for (radius, distance) in [(1.0, 1.0001), (1.0, 2.0), (0.5, 100.0), (1e-6, 1e3), (3.0, 1e8)] {
        let ball = primitive(Geometry::Sphere, placed([0.0; 3], [30.0, 0.0, 0.0], [radius; 3]));
        let point = DVec3::new(0.6, 0.0, 0.8) * distance * if distance < 2.0 { radius } else { 1.0 };
        let sine_square = radius * radius / point.length_squared();
        let wanted = 2.0 * PI * sine_square / (1.0 + (1.0 - sine_square).sqrt());
        let sampler = sampler(&ball);
        let sample = sampler.sample_towards(point, [0.3, 0.7], 0.0).unwrap();
        assert!((1.0 / sample.density / wanted - 1.0).abs() < 1e-9, "{radius} {distance}");
    }
    let ball = primitive(Geometry::Sphere, placed([1.0, 0.0, 0.0], [0.0; 3], [2.0; 3]));
    check("sphere from inside", &ball, DVec3::new(0.5, 1.0, 0.3), 4.0 * PI);
    let egg = primitive(Geometry::Sphere, placed([1.0, 0.0, 0.0], [0.0; 3], [2.0, 0.5, 3.0]));
    check("ellipsoid from inside", &egg, DVec3::new(0.5, 0.2, 0.3), 4.0 * PI);
}

#[test]
fn rectangles_have_the_solid_angle_of_two_triangles() {
    for transform in [
        Transform::IDENTITY,
        placed([0.2, 0.1, -0.4], [40.0, 20.0, 10.0], [0.1, 5.0, 1.0]),
        crate::shape_hits::sheared(),
    ] {
        let rectangle = primitive(Geometry::Flat(Outline::Rectangle), transform);
        for point in viewers(&rectangle) {
            let corner = |x: f64, y: f64| transform.to_world.transform_point3(DVec3::new(x, y, 0.0)) - point;
            let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
            check("rectangle", &rectangle, point, triangle_solid_angle([a, b, c]) + triangle_solid_angle([a, c, d]));
        }
    }
}

#[test]
fn discs_on_their_axis_have_the_solid_angle_of_a_cone() {
    let disc = primitive(Geometry::Flat(Outline::Disc), placed([1.0, 2.0, 3.0], [0.0; 3], [0.5; 3]));
    for height in [0.3_f64, 1.0, 7.0] {
        let wanted = 2.0 * PI * (1.0 - height / (height * height + 0.25).sqrt());
        check("disc", &disc, DVec3::new(1.0, 2.0, 3.0 + height), wanted);
        check("disc from behind", &disc, DVec3::new(1.0, 2.0, 3.0 - height), wanted);
    }
}

#[test]
fn closed_shapes_fill_the_sphere_around_a_point_inside() {
    let inside = DVec3::new(0.1, -0.2, 0.15);
    check("mesh", &primitive(mesh(6), Transform::IDENTITY), inside, 4.0 * PI);
    check("box", &primitive(Geometry::Cuboid, Transform::IDENTITY), inside, 4.0 * PI);
}

#[test]
fn a_fine_mesh_is_seen_as_the_sphere() {
    let point = DVec3::new(0.0, 1.0, 2.0);
    let sphere = 2.0 * PI * (1.0 - 0.8_f64.sqrt());
    let ball = primitive(mesh(24), Transform::IDENTITY);
    let (mean, error) = estimated(&ball, &sampler(&ball), point, 20_000);
    // The triangles lie inside the sphere by up to 1/1000.
    assert!((mean - sphere).abs() < 3.0 * error + 2e-3 * sphere, "{mean} +- {error}, {sphere}");
}

#[test]
fn a_tiny_light_far_away_keeps_its_digits() {
    let wanted = 1e-6 / 1e6;
    for (name, geometry, side) in [
        ("rectangle", Geometry::Flat(Outline::Rectangle), 5e-4),
        ("disc", Geometry::Flat(Outline::Disc), (1e-6 / PI).sqrt()),
    ] {
        let light = primitive(geometry, placed([0.0, 0.0, 1e3], [180.0, 0.0, 0.0], [side; 3]));
        let sampler = sampler(&light);
        assert!((sampler.area() / 1e-6 - 1.0).abs() < 1e-9);
        let sample = sampler.sample_towards(DVec3::ZERO, [0.2, 0.9], 0.5).unwrap();
        assert!((1.0 / sample.density / wanted - 1.0).abs() < 1e-6, "{name}: {}", sample.density);
    }
}

/// The hit of a shape in a direction: its density and part; none elsewhere.
fn density_and_part(
    primitive: &Primitive,
    sampler: &ShapeSampler,
    point: DVec3,
    direction: DVec3,
) -> Option<(f64, u32)> {
    let ray = Ray::new(point, direction);
    let hit = primitive.intersect(&ray, 0, f64::INFINITY)?;
    let surface = primitive.surface(&ray, &hit);
    let part = hit.id.part;
    Some((sampler.density_towards(point, direction, surface.position, surface.normal, part), part))
}

/// Whether one part of the shape fills a bin, and with a density that midpoints integrate well.
fn is_smooth(bin: usize, side: usize, at: impl Fn(DVec3) -> Option<(f64, u32)>) -> bool {
    let (face, row, column) = (bin / (side * side), bin / side % side, bin % side);
    let (mut densities, mut parts) = (Vec::new(), Vec::new());
    for step in 0..49 {
        let place = [column as f64 + f64::from(step % 7) / 6.0, row as f64 + f64::from(step / 7) / 6.0];
        let direction = point_on_cube(face, place.map(|place| place / side as f64)).normalize();
        let Some((density, part)) = at(direction) else { return false };
        densities.push(density);
        parts.push(part);
    }
    let (low, high) = densities.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), &d| (low.min(d), high.max(d)));
    parts.iter().all(|&part| part == parts[0]) && low > 0.0 && high < 1.5 * low
}

#[test]
fn samples_follow_the_density_told_for_hits() {
    let (side, samples) = (24, 60_000);
    let mut tested = 0;
    for (name, primitive) in shapes() {
        let sampler = sampler(&primitive);
        for point in viewers(&primitive).into_iter().take(5) {
            let at = |direction| density_and_part(&primitive, &sampler, point, direction);
            let mut random = Random(31);
            let mut counts = vec![0; 6 * side * side];
            for _ in 0..samples {
                let drawn = sampler.sample_towards(point, [random.unit(), random.unit()], random.unit());
                let Some(sample) = drawn else { continue };
                let ray = Ray::new(point, sample.to_shape);
                if primitive.intersect(&ray, 0, sample.distance * (1.0 - 1e-6)).is_none() {
                    counts[cube_bin(sample.to_shape, side)] += 1;
                }
            }
            let expected = cube_integrals(side, 8, |direction| at(direction).map_or(0.0, |(density, _)| density));
            let smooth: Vec<usize> = (0..counts.len()).filter(|&bin| is_smooth(bin, side, at)).collect();
            let counts: Vec<u64> = smooth.iter().map(|&bin| counts[bin]).collect();
            let expected: Vec<f64> = smooth.iter().map(|&bin| expected[bin] * f64::from(samples)).collect();
            if expected.iter().filter(|&&expected| expected >= 5.0).count() < 4 {
                continue;
            }
            tested += 1;
            let deviation = deviation(&counts, &expected);
            assert!(deviation < 4.0, "{name} from {point}: {deviation} standard deviations in {} bins", counts.len());
        }
    }
    assert!(tested > 60, "{tested}");
}
