//! A closed mesh never leaks.

use skycube::math::{DVec3, Vec3};
use skycube::shapes::mesh::{Mesh, MeshGeometry};
use skycube::stress::Random;

use crate::icosphere::{bumps, icosphere, placed};

/// Rays that come out of a closed mesh: `rays` random ones, ones at every vertex and at points of every edge, and
/// ones along the axes; from points within `inside` of the mesh's centre.
fn leaks(geometry: MeshGeometry, centre: DVec3, inside: f64, rays: usize) -> usize {
    let mesh = Mesh::new(geometry).unwrap();
    let mut random = Random(7);
    let mut leaks = 0;
    let mut shoot = |origin: DVec3, direction: DVec3| {
        leaks += usize::from(mesh.intersect(origin, direction, f64::INFINITY, None).is_none());
    };
    let mut count = 0;
    while count < rays {
        let origin = centre + random.in_ball() * inside;
        shoot(origin, random.direction());
        let triangle = random.below(mesh.geometry().triangles.len()) as u32;
        let corners = mesh.geometry().corners(triangle).map(|corner| corner.as_dvec3());
        let along = random.unit();
        shoot(origin, corners[0] - origin);
        shoot(origin, corners[0].lerp(corners[1], along) - origin);
        // From a point that f32 holds, as a mesh from a file has them: exact zeros in the edge functions.
        let exact = centre + (random.in_ball() * 8.0).round() * (inside / 16.0);
        shoot(exact, corners[2] - exact);
        shoot(exact, corners[1].midpoint(corners[2]) - exact);
        shoot(exact, [DVec3::X, DVec3::NEG_Y, DVec3::Z][count % 3] * inside);
        count += 6;
    }
    leaks
}

#[test]
fn a_million_rays_stay_inside_an_icosphere() {
    assert_eq!(leaks(icosphere(12, |_| 1.0), DVec3::ZERO, 0.5, 700_000), 0);
    assert_eq!(leaks(icosphere(40, bumps), DVec3::ZERO, 0.5, 300_000), 0);
}

#[test]
fn size_and_place_do_not_matter() {
    for (scale, offset) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 1000.0), (1e-2, 100.0), (1e4, 1e6)] {
        let centre = Vec3::new(offset, -0.5 * offset, 0.25 * offset);
        let geometry = placed(icosphere(8, |_| 1.0), scale, centre);
        assert_eq!(leaks(geometry, centre.as_dvec3(), 0.4 * f64::from(scale), 30_000), 0, "{scale} at {offset}");
    }
}

#[test]
fn needles_do_not_leak() {
    let mut geometry = icosphere(10, |_| 1.0);
    geometry.positions.iter_mut().for_each(|position| *position *= Vec3::new(1e-5, 1.0, 1e3));
    assert_eq!(leaks(geometry, DVec3::ZERO, 4e-6, 30_000), 0);
}
