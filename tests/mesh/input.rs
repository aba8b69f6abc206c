//! What a mesh refuses, and what it says of its surface.

use skycube::math::{DVec3, Side, Vec2, Vec3};
use skycube::shapes::mesh::{Mesh, MeshGeometry};

fn triangle() -> MeshGeometry {
    MeshGeometry { positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y], triangles: vec![[0, 1, 2]], ..Default::default() }
}

fn refusal(change: impl FnOnce(&mut MeshGeometry)) -> String {
    let mut geometry = triangle();
    change(&mut geometry);
    Mesh::new(geometry).unwrap_err().to_string()
}

#[test]
fn refuses_what_cannot_be_traced() {
    insta::assert_snapshot!(refusal(|g| g.triangles.clear()), @r#"
    the mesh has no triangles
      expected: at least one triangle
    "#);
    insta::assert_snapshot!(refusal(|g| g.triangles.push([0, 1, 3])), @r#"
    triangle 1 has the vertices [0, 1, 3], but there are only 3
      expected: numbers from 0 to 2
    "#);
    insta::assert_snapshot!(refusal(|g| g.positions[1].y = f32::NAN), @r#"
    vertex 1 is at [1, NaN, 0]
      expected: finite coordinates of at most 1e12
    "#);
    insta::assert_snapshot!(refusal(|g| g.normals.push(Vec3::Z)), @r#"
    the mesh has 1 normals
      expected: 3, or none
    "#);
    insta::assert_snapshot!(refusal(|g| g.triangles = vec![[0, 1, 1], [2, 2, 2]]), @r#"
    all triangles of the mesh have zero area
      expected: one triangle with an area
    "#);
}

#[test]
fn triangles_without_area_keep_their_numbers_but_are_never_hit() {
    let mut geometry = triangle();
    geometry.triangles = vec![[0, 0, 1], [0, 1, 2]];
    let mesh = Mesh::new(geometry).unwrap();
    assert_eq!(mesh.degenerate_triangles(), 1);
    let hit = mesh.intersect(DVec3::new(0.25, 0.25, 2.0), DVec3::NEG_Z * 0.5, f64::INFINITY, None).unwrap();
    assert_eq!((hit.triangle, hit.t, hit.barycentric), (1, 4.0, [0.5, 0.25, 0.25]));
}

#[test]
fn interpolates_what_the_vertices_have() {
    let mut geometry = triangle();
    geometry.normals = vec![Vec3::Z, Vec3::new(3.0, 0.0, 4.0), Vec3::Z];
    geometry.texture_coordinates = vec![Vec2::ZERO, Vec2::X, Vec2::Y];
    geometry.materials = vec![5];
    let point = Mesh::new(geometry).unwrap().surface(0, [0.5, 0.25, 0.25]);
    assert_eq!(point.position, DVec3::new(0.25, 0.25, 0.0));
    assert_eq!(point.geometric_normal, DVec3::Z);
    assert!((point.shading_normal - DVec3::new(0.15, 0.0, 0.95).normalize()).length() < 1e-7);
    assert_eq!((point.texture_coordinates, point.material), (Vec2::splat(0.25), 5));
}

#[test]
fn rays_that_are_none_hit_nothing() {
    let mesh = Mesh::new(triangle()).unwrap();
    let inside = DVec3::new(0.2, 0.2, 1.0);
    for direction in [DVec3::ZERO, DVec3::NAN, DVec3::new(0.0, 0.0, f64::NEG_INFINITY)] {
        assert_eq!(mesh.intersect(inside, direction, f64::INFINITY, None), None);
    }
    for origin in [DVec3::NAN, DVec3::INFINITY] {
        assert_eq!(mesh.intersect(origin, DVec3::NEG_Z, f64::INFINITY, Some((0, Side::Front))), None);
    }
}
