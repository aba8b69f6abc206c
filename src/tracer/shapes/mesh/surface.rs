//! A point on the mesh.

use super::Mesh;
use crate::math::{DVec3, Vec2, Vec3};

/// What there is to know of a point on the mesh, in the mesh's own space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshPoint {
    /// The point itself.
    pub position: DVec3,
    /// Unit length, to the front of the triangle: where its vertices run counter-clockwise.
    pub geometric_normal: DVec3,
    /// Unit length, interpolated between the vertices and turned to the same side as the geometric normal; equal to
    /// it where a vertex has no normal.
    pub shading_normal: DVec3,
    /// Interpolated, not wrapped. (0, 0) if the mesh has none. In OBJ files `v` grows upwards in the picture.
    pub texture_coordinates: Vec2,
    /// Linear RGB, interpolated; black if the mesh has no colours.
    pub vertex_colour: Vec3,
    /// Material group of the triangle.
    pub material: u32,
}

impl Mesh {
    /// The point of a triangle with these barycentric coordinates, as a hit gives them.
    pub fn surface(&self, triangle: u32, barycentric: [f64; 3]) -> MeshPoint {
        let sum = barycentric[0] + barycentric[1] + barycentric[2];
        let weights = barycentric.map(|weight| weight / sum);
        let geometry = self.geometry();
        let vertices = geometry.triangles[triangle as usize].map(|vertex| vertex as usize);
        let mix = |values: [DVec3; 3]| values[0] * weights[0] + values[1] * weights[1] + values[2] * weights[2];
        let geometric_normal = geometry.area_vector(triangle).normalize();
        let texture_coordinates = if geometry.texture_coordinates.is_empty() {
            Vec2::ZERO
        } else {
            mix(vertices.map(|vertex| geometry.texture_coordinates[vertex].extend(0.0).as_dvec3())).truncate().as_vec2()
        };
        let vertex_colour = if geometry.colours.is_empty() {
            Vec3::ZERO
        } else {
            mix(vertices.map(|vertex| geometry.colours[vertex].as_dvec3())).as_vec3()
        };
        MeshPoint {
            position: mix(vertices.map(|vertex| geometry.positions[vertex].as_dvec3())),
            geometric_normal,
            shading_normal: self
                .shading_normal(vertices, mix)
                .map_or(geometric_normal, |normal| if normal.dot(geometric_normal) < 0.0 { -normal } else { normal }),
            texture_coordinates,
            vertex_colour,
            material: geometry.materials.get(triangle as usize).copied().unwrap_or(0),
        }
    }

    /// The interpolated normal; `None` if one of the vertices has none, or they cancel.
    fn shading_normal(&self, vertices: [usize; 3], mix: impl Fn([DVec3; 3]) -> DVec3) -> Option<DVec3> {
        let normals = &self.geometry().normals;
        if normals.is_empty() {
            return None;
        }
        let normals = vertices.map(|vertex| normals[vertex].as_dvec3().try_normalize());
        mix([normals[0]?, normals[1]?, normals[2]?]).try_normalize()
    }
}
