//! The hierarchy finds what looking at every triangle finds.

use proptest::prelude::*;
use skycube::math::{DVec3, Vec3};
use skycube::shapes::mesh::{Mesh, MeshGeometry, MeshHit, ShearedRay};
use skycube::stress::Random;

use crate::icosphere::{icosphere, placed};

/// Every triangle by itself; of equal ones the lowest number.
fn brute_force(geometry: &MeshGeometry, origin: DVec3, direction: DVec3) -> Option<MeshHit> {
    let ray = ShearedRay::new(origin, direction);
    let hit = |triangle: u32| {
        let corners = geometry.corners(triangle).map(|corner| corner.as_dvec3().to_array());
        let hit = ray.intersect(corners).filter(|hit| hit.t > 0.0)?;
        (geometry.area_vector(triangle) != DVec3::ZERO).then_some(MeshHit {
            t: hit.t,
            triangle,
            barycentric: hit.barycentric,
        })
    };
    let all = 0..geometry.triangles.len() as u32;
    all.filter_map(hit).min_by(|a, b| a.t.total_cmp(&b.t).then(a.triangle.cmp(&b.triangle)))
}

/// Compares closest and any hit for rays of many kinds; returns how many hit.
fn compare(geometry: MeshGeometry, rays: usize, seed: u64) -> usize {
    let mesh = Mesh::new(geometry).unwrap();
    let (geometry, bounds) = (mesh.geometry(), mesh.bounds());
    let mut random = Random(seed);
    let mut hits = 0;
    for number in 0..rays {
        let mut origin = bounds.minimum + bounds.extent() * (random.in_ball() + 0.5);
        let mut direction = random.direction() * 10.0_f64.powi(number as i32 % 9 - 4);
        let vertex = geometry.positions[random.below(geometry.positions.len())].as_dvec3();
        match number % 6 {
            0 => direction = vertex - origin,
            1 => direction = [DVec3::X, DVec3::NEG_Y, DVec3::Z][number / 6 % 3],
            // In the planes of the sides of a box: through a vertex along an axis, and along a diagonal of two axes.
            2 => (origin, direction) = (vertex.with_x(origin.x), DVec3::NEG_X),
            3 => (origin, direction) = (vertex - DVec3::new(2.0, 0.0, -2.0), DVec3::new(1.0, -0.0, -1.0)),
            4 => origin -= direction * (1000.0 * bounds.extent().max_element() / direction.length()),
            _ => {}
        }
        let expected = brute_force(geometry, origin, direction);
        assert_eq!(mesh.intersect(origin, direction, f64::INFINITY, None), expected, "{origin} {direction}");
        assert_eq!(mesh.occluded(origin, direction, f64::INFINITY, None), expected.is_some());
        if let Some(hit) = expected {
            assert_eq!(mesh.intersect(origin, direction, hit.t, None), None);
            assert!(!mesh.occluded(origin, direction, hit.t, None));
            assert!(mesh.occluded(origin, direction, hit.t.next_up(), None));
            hits += 1;
        }
    }
    hits
}

fn soup(count: usize, size: f32, shape: Vec3, seed: u64) -> MeshGeometry {
    let mut random = Random(seed);
    let mut geometry = MeshGeometry::default();
    for number in 0..count as u32 {
        let centre = random.in_ball().as_vec3();
        for _ in 0..3 {
            geometry.positions.push((centre + random.in_ball().as_vec3() * size) * shape);
        }
        geometry.triangles.push([3 * number, 3 * number + 1, 3 * number + 2]);
    }
    geometry
}

#[test]
fn agrees_with_brute_force_at_any_size() {
    for exponent in [-6, -3, 0, 3, 6] {
        let scale = Vec3::splat(10.0_f32.powi(exponent));
        assert!(compare(soup(300, 0.3, scale, 3), 1500, 4) > 500, "1e{exponent}");
    }
}

#[test]
fn agrees_with_brute_force_for_needles_and_flat_soups() {
    compare(soup(300, 0.3, Vec3::new(1e-5, 1.0, 1.0), 5), 1500, 6);
    compare(soup(300, 0.3, Vec3::new(1.0, 0.0, 1.0), 7), 1500, 8);
    compare(soup(300, 1e-4, Vec3::ONE, 9), 1500, 10);
    compare(placed(soup(300, 0.3, Vec3::ONE, 11), 1.0, Vec3::splat(1e4)), 1500, 12);
}

#[test]
fn agrees_with_brute_force_on_an_icosphere() {
    assert!(compare(icosphere(6, |_| 1.0), 4000, 13) > 1000);
}

#[test]
fn many_copies_of_one_triangle_give_the_lowest_number() {
    let mut geometry = soup(1, 1.0, Vec3::ONE, 1);
    geometry.triangles = vec![[0, 1, 2]; 5000];
    compare(geometry, 200, 2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn agrees_with_brute_force_for_any_soup(count in 1usize..40, size in 1e-3f32..2.0, seed: u64) {
        compare(soup(count, size, Vec3::ONE, seed), 60, seed ^ 1);
    }
}
