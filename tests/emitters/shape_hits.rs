//! Points drawn on shapes: they are where they say, hit by the ray, and have the density told.

use std::sync::Arc;

use skycube::math::{DAffine3, DMat3, DVec3, Ray, Transform};
use skycube::shapes::mesh::Mesh;
use skycube::shapes::{Geometry, MaterialChoice, Outline, Primitive, ShapeSampler};
use skycube::stress::Random;

use crate::icosphere::icosphere;

/// A transform: moved, turned, scaled.
pub fn placed(translate: [f64; 3], rotate: [f64; 3], scale: [f64; 3]) -> Transform {
    Transform::from_parts(translate.into(), rotate.into(), scale.into()).unwrap()
}

/// A transform that slants rectangles and spheres.
pub fn sheared() -> Transform {
    let linear = DMat3::from_cols(DVec3::new(1.0, 0.2, 0.0), DVec3::new(0.7, 1.1, 0.3), DVec3::new(-0.2, 0.5, -0.8));
    Transform::from_affine(DAffine3::from_mat3_translation(linear, DVec3::new(0.5, -1.0, 2.0))).unwrap()
}

pub fn primitive(geometry: Geometry, transform: Transform) -> Primitive {
    Primitive::new(geometry, transform, MaterialChoice::Whole(0), true)
}

pub fn sampler(primitive: &Primitive) -> ShapeSampler {
    ShapeSampler::new(primitive, |_| true)
}

pub fn mesh(frequency: usize) -> Geometry {
    Geometry::Mesh(Arc::new(Mesh::new(icosphere(frequency, |_| 1.0)).unwrap()))
}

/// Shapes of all kinds under transforms of all kinds.
pub fn shapes() -> Vec<(String, Primitive)> {
    let geometries = [
        ("sphere", Geometry::Sphere),
        ("rectangle", Geometry::Flat(Outline::Rectangle)),
        ("disc", Geometry::Flat(Outline::Disc)),
        ("box", Geometry::Cuboid),
        ("mesh", mesh(2)),
    ];
    let transforms = [
        ("as it is", Transform::IDENTITY),
        ("turned", placed([0.3, -0.2, 1.0], [20.0, 130.0, -40.0], [0.7; 3])),
        ("stretched", placed([0.0, 0.5, 0.2], [50.0, 10.0, 70.0], [0.3, 1.5, 0.8])),
        ("mirrored", placed([0.1, 0.0, -0.5], [0.0, 30.0, 10.0], [1.0, -0.6, 0.5])),
        ("slanted", sheared()),
    ];
    let mut shapes = Vec::new();
    for (name, geometry) in &geometries {
        for (how, transform) in &transforms {
            shapes.push((format!("{name}, {how}"), primitive(geometry.clone(), *transform)));
        }
    }
    shapes
}

/// Viewers: far, near, very near, in the plane of flat shapes or nearly, and in the middle.
pub fn viewers(primitive: &Primitive) -> Vec<DVec3> {
    let local = [
        [3.0, 4.0, 5.0],
        [0.2, -0.3, 1.2],
        [-1.5, 0.4, 1e-3],
        [0.3, 0.2, 1.0 + 1e-3],
        [0.1, 0.2, -2.0],
        [40.0, 3.0, 0.5],
        [0.1, 0.25, 0.3],
    ];
    local.map(|point| primitive.transform.to_world.transform_point3(point.into())).into()
}

#[test]
fn samples_lie_where_a_ray_hits_the_shape() {
    let mut random = Random(5);
    for (name, primitive) in shapes() {
        let sampler = sampler(&primitive);
        let (mut drawn, mut seen) = (0, 0);
        for point in viewers(&primitive) {
            for _ in 0..400 {
                let place = [random.unit(), random.unit()];
                let Some(sample) = sampler.sample_towards(point, place, random.unit()) else { continue };
                assert!((sample.to_shape.length() - 1.0).abs() < 1e-14 && (sample.normal.length() - 1.0).abs() < 1e-14);
                assert!(
                    (point + sample.to_shape * sample.distance - sample.position).length()
                        < 1e-12 * sample.distance.max(1.0)
                );
                drawn += 1;
                let ray = Ray::new(point, sample.to_shape);
                // Edges and rims may be missed by rounding; what is hit before is another part of the same shape.
                let Some(hit) = primitive.intersect(&ray, 0, f64::INFINITY) else { continue };
                if (hit.t - sample.distance).abs() > 1e-6 * sample.distance.max(0.1) {
                    continue;
                }
                seen += 1;
                let surface = primitive.surface(&ray, &hit);
                assert!(surface.normal.dot(sample.normal) > 1.0 - 1e-6, "{name}");
                assert_eq!(hit.id.part, sample.id_part, "{name}");
                let told =
                    sampler.density_towards(point, sample.to_shape, surface.position, surface.normal, hit.id.part);
                assert!((told / sample.density - 1.0).abs() < 1e-4, "{name} from {point}: {told} {}", sample.density);
            }
        }
        // Of a mesh half the triangles are hidden by the others; of all else nothing.
        let share = f64::from(seen) / f64::from(drawn);
        assert!(share > if name.starts_with("mesh") { 0.3 } else { 0.995 }, "{name}: {share} of {drawn}");
    }
}

#[test]
fn only_groups_that_give_light_are_drawn() {
    let mut geometry = icosphere(3, |_| 1.0);
    geometry.materials = (0..geometry.triangles.len() as u32).map(|triangle| triangle % 3).collect();
    let mesh = Geometry::Mesh(Arc::new(Mesh::new(geometry).unwrap()));
    let primitive = Primitive::new(mesh, Transform::IDENTITY, MaterialChoice::PerGroup([7, 8, 9].into()), true);
    let (all, some) =
        (ShapeSampler::new(&primitive, |_| true), ShapeSampler::new(&primitive, |material| material == 8));
    assert!((some.area() / all.area() - 1.0 / 3.0).abs() < 0.05);
    let (mut random, point) = (Random(1), DVec3::new(0.0, 0.0, 3.0));
    for _ in 0..500 {
        let sample = some.sample_towards(point, [random.unit(), random.unit()], random.unit()).unwrap();
        assert_eq!(sample.id_part % 3, 1);
    }
    let density = |part| some.density_towards(point, DVec3::NEG_Z, DVec3::Z, DVec3::Z, part);
    assert!(density(1) > 0.0 && density(0) == 0.0);
    let none = ShapeSampler::new(&primitive, |_| false);
    assert!(none.area() == 0.0 && none.sample_towards(point, [0.5; 2], 0.5).is_none());
}

#[test]
fn a_plane_has_no_end_and_edges_are_not_seen() {
    let plane = sampler(&primitive(Geometry::Flat(Outline::Plane), Transform::IDENTITY));
    assert!(plane.sample_towards(DVec3::Z, [0.5; 2], 0.5).is_none());
    assert_eq!(plane.density_towards(DVec3::Z, DVec3::NEG_Z, DVec3::ZERO, DVec3::Z, 0), 0.0);
    for outline in [Outline::Disc, Outline::Rectangle] {
        let flat = sampler(&primitive(Geometry::Flat(outline), Transform::IDENTITY));
        assert!(flat.sample_towards(DVec3::X * 3.0, [0.3, 0.6], 0.5).is_none());
    }
}

#[test]
fn areas_are_those_of_geometry() {
    use std::f64::consts::PI;
    let area = |geometry: Geometry, scale: [f64; 3]| {
        sampler(&primitive(geometry, placed([1.0, 2.0, 3.0], [10.0, 20.0, 30.0], scale))).area()
    };
    let close = |found: f64, wanted: f64, error: f64| assert!((found / wanted - 1.0).abs() < error, "{found} {wanted}");
    close(area(Geometry::Sphere, [2.0; 3]), 16.0 * PI, 1e-12);
    close(area(Geometry::Flat(Outline::Rectangle), [2.0, 3.0, 7.0]), 24.0, 1e-12);
    close(area(Geometry::Flat(Outline::Disc), [2.0, 3.0, 7.0]), 6.0 * PI, 1e-12);
    close(area(Geometry::Cuboid, [1.0, 2.0, 3.0]), 8.0 * (2.0 + 6.0 + 3.0), 1e-12);
    close(area(mesh(40), [1.5; 3]), 9.0 * PI, 1e-3);
    // Prolate spheroid a = 1, c = 3: 2 pi a^2 (1 + c / (a e) asin e); oblate a = 3, c = 1: 2 pi a^2 (1 + (1 - e^2) / e atanh e).
    let e = (1.0_f64 - 1.0 / 9.0).sqrt();
    close(area(Geometry::Sphere, [1.0, 1.0, 3.0]), 2.0 * PI * (1.0 + 3.0 / e * e.asin()), 1e-5);
    close(area(Geometry::Sphere, [3.0, 3.0, 1.0]), 18.0 * PI * (1.0 + (1.0 - e * e) / e * e.atanh()), 1e-5);
}
