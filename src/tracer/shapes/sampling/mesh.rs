//! Meshes: a triangle by its area in the world, then a point uniform in it.

use std::sync::Arc;

use super::ShapeSample;
use crate::math::{DVec3, Transform};
use crate::shapes::mesh::Mesh;

/// Draws points of the triangles of a mesh that give light.
#[derive(Debug)]
pub(super) struct MeshSampler {
    mesh: Arc<Mesh>,
    transform: Transform,
    /// Numbers of the triangles, in order, and the sum of the areas up to and including each.
    triangles: Vec<u32>,
    areas_until: Vec<f64>,
    /// Of the triangles of the mesh, whether they are drawn; empty if all are.
    drawn: Vec<bool>,
}

impl MeshSampler {
    /// Triangles of groups that give light and have an area.
    pub(super) fn new(mesh: &Arc<Mesh>, transform: &Transform, emits: impl Fn(u32) -> bool) -> Self {
        let geometry = mesh.geometry();
        let group = |triangle: u32| geometry.materials.get(triangle as usize).copied().unwrap_or(0);
        // An area vector is carried to the world by the cofactors of the map.
        let cofactors = transform.to_object.matrix3.transpose();
        let scale = transform.to_world.matrix3.determinant().abs() / 2.0;
        let (mut triangles, mut areas_until, mut sum) = (Vec::new(), Vec::new(), 0.0);
        for triangle in (0..geometry.triangles.len() as u32).filter(|&triangle| emits(group(triangle))) {
            let area = (cofactors * geometry.area_vector(triangle)).length() * scale;
            if area > 0.0 {
                sum += area;
                triangles.push(triangle);
                areas_until.push(sum);
            }
        }
        let mut drawn = Vec::new();
        if triangles.len() < geometry.triangles.len() {
            drawn.resize(geometry.triangles.len(), false);
            triangles.iter().for_each(|&triangle| drawn[triangle as usize] = true);
        }
        Self { mesh: Arc::clone(mesh), transform: *transform, triangles, areas_until, drawn }
    }

    pub(super) fn area(&self) -> f64 {
        self.areas_until.last().copied().unwrap_or(0.0)
    }

    /// Whether a triangle is ever drawn.
    #[inline]
    pub(super) fn draws(&self, triangle: u32) -> bool {
        self.drawn.get(triangle as usize).copied().unwrap_or(true)
    }

    #[inline]
    pub(super) fn sample_towards(&self, point: DVec3, place: [f64; 2], choice: f64) -> Option<ShapeSample> {
        let area = self.area();
        let target = choice * area;
        let number = self.areas_until.partition_point(|&until| until <= target).min(self.triangles.len() - 1);
        let triangle = self.triangles[number];
        let geometry = self.mesh.geometry();
        let [a, b, c] = geometry.corners(triangle).map(|corner| corner.as_dvec3());
        let [weight_a, weight_b, weight_c] = barycentric(place);
        let position = self.transform.to_world.transform_point3(a * weight_a + b * weight_b + c * weight_c);
        let normal = self.transform.normal_to_world(geometry.area_vector(triangle).normalize());
        ShapeSample::by_area(point, position, normal, area, triangle)
    }
}

/// Weights of the corners of a place uniform in a triangle (Heitz, A Low-Distortion Map Between Triangle and Square,
/// 2019): the square is folded onto the triangle along its diagonal.
#[inline]
fn barycentric([x, y]: [f64; 2]) -> [f64; 3] {
    let (b, c) = if x < y { (x / 2.0, y - x / 2.0) } else { (x - y / 2.0, y / 2.0) };
    [1.0 - b - c, b, c]
}
