//! Rays that start on a convex mesh: outwards they never hit it, inwards they always do.

use skycube::math::{DAffine3, DVec3, Side, Transform, Vec3};
use skycube::shapes::mesh::{Mesh, MeshGeometry, MeshHit};
use skycube::stress::Random;

use crate::icosphere::{icosphere, placed};

/// The cube [-1, 1]^3 of twelve triangles, front outside.
fn cube() -> MeshGeometry {
    let corner = |bits: u32| Vec3::new((bits & 1) as f32, (bits >> 1 & 1) as f32, (bits >> 2) as f32) * 2.0 - 1.0;
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    MeshGeometry {
        positions: (0..8).map(corner).collect(),
        triangles: quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        ..Default::default()
    }
}

/// False hits outwards and misses inwards among `rays` rays each, from points hit at random; every third one is hit
/// at an edge or a vertex, every fifth leaves at a grazing angle. All goes through the world and back.
fn faults(geometry: MeshGeometry, to_world: DAffine3, rays: usize) -> (usize, usize) {
    let mesh = Mesh::new(geometry).unwrap();
    let place = Transform::from_affine(to_world).unwrap();
    let centre = mesh.bounds().minimum.midpoint(mesh.bounds().maximum);
    let mut random = Random(11);
    let mut faults = (0, 0);
    for number in 0..rays {
        let inside = centre + random.in_ball() * 0.4 * mesh.bounds().extent().min_element();
        let mut direction = random.direction();
        if number % 3 == 0 {
            let corners = mesh.geometry().corners(random.below(mesh.geometry().triangles.len()) as u32);
            let weight = if number % 2 == 0 { 0.0 } else { random.unit() };
            direction = corners[0].as_dvec3().lerp(corners[1].as_dvec3(), weight) - inside;
        }
        let hit = mesh.intersect(inside, direction, f64::INFINITY, None).expect("closed");
        for side in [Side::Front, Side::Back] {
            let (origin, direction) = spawned(&mesh, &place, hit, side, number % 5 == 0, &mut random);
            let leaving = Some((hit.triangle, side));
            let again = mesh.intersect(origin, direction, f64::INFINITY, leaving);
            assert_eq!(again.is_some(), mesh.occluded(origin, direction, f64::INFINITY, leaving));
            match side {
                Side::Front => faults.0 += usize::from(again.is_some()),
                Side::Back => faults.1 += usize::from(again.is_none()),
            }
        }
    }
    faults
}

/// A random ray from a hit to one side, in the mesh's own space after a journey through the world.
fn spawned(
    mesh: &Mesh,
    place: &Transform,
    hit: MeshHit,
    side: Side,
    grazing: bool,
    random: &mut Random,
) -> (DVec3, DVec3) {
    let point = mesh.surface(hit.triangle, hit.barycentric);
    let normal = place.normal_to_world(point.geometric_normal);
    let mut direction = random.direction();
    if grazing {
        direction = (direction - normal * direction.dot(normal) * (1.0 - 1e-5)).normalize();
    }
    if Side::of(direction, normal) != side {
        direction -= 2.0 * normal * direction.dot(normal);
    }
    let origin = place.to_world.transform_point3(point.position);
    (place.to_object.transform_point3(origin), place.to_object.transform_vector3(direction))
}

fn check(geometry: &MeshGeometry, to_world: DAffine3, rays: usize, what: &str) {
    assert_eq!(faults(geometry.clone(), to_world, rays), (0, 0), "(false hits, misses) of {what}");
}

fn check_all(rays: usize) {
    let meshes = [("cube", cube()), ("icosphere", icosphere(6, |_| 1.0)), ("icosahedron", icosphere(1, |_| 1.0))];
    for (name, geometry) in &meshes {
        check(geometry, DAffine3::IDENTITY, rays, name);
        for scale in [1e-4, 1e-2, 1e2, 1e4] {
            let what = format!("{name} scaled by {scale}");
            check(&placed(geometry.clone(), scale, Vec3::ZERO), DAffine3::IDENTITY, rays, &what);
            let turned = DAffine3::from_scale(DVec3::splat(f64::from(scale))) * DAffine3::from_rotation_y(0.7);
            check(geometry, turned, rays, &format!("{what} in the world"));
        }
        let offset = Vec3::new(100.0, -30.0, 7.0);
        check(&placed(geometry.clone(), 1.0, offset), DAffine3::IDENTITY, rays, &format!("{name} beside the origin"));
        let far = DAffine3::from_translation(DVec3::new(1e4, 1e3, -1e4)) * DAffine3::from_rotation_x(0.3);
        check(geometry, far, rays, &format!("{name} far off in the world"));
    }
}

#[test]
fn rays_leave_convex_meshes_and_do_not_come_back() {
    check_all(2_000);
}

#[test]
#[ignore = "whole table: a minute in release mode"]
fn rays_leave_convex_meshes_whole_table() {
    check_all(200_000);
}
