//! What a mesh is made of, as given.

use crate::error::{Error, Result};
use crate::math::{DVec3, Vec2, Vec3};

/// Largest coordinate of a vertex: products of three of them must stay finite in `f32`.
const LARGEST_COORDINATE: f32 = 1e12;

/// Triangles over shared vertices, in the mesh's own space.
///
/// A triangle's front is where its vertices run counter-clockwise.
#[derive(Debug, Clone, Default)]
pub struct MeshGeometry {
    pub positions: Vec<Vec3>,
    /// Shading normal of each vertex (any length; zero where it has none), or empty: then the faces are flat.
    pub normals: Vec<Vec3>,
    /// Texture coordinates of each vertex, or empty: then they are (0, 0).
    pub texture_coordinates: Vec<Vec2>,
    /// Three vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Material group of each triangle, or empty: then all are of group 0.
    pub materials: Vec<u32>,
}

impl MeshGeometry {
    /// The corners of a triangle.
    #[inline]
    pub fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.triangles[triangle as usize].map(|vertex| self.positions[vertex as usize])
    }

    /// Twice the area times the normal of the front, in `f64`; zero for a triangle without area.
    #[inline]
    pub fn area_vector(&self, triangle: u32) -> DVec3 {
        let [a, b, c] = self.corners(triangle).map(|corner| corner.as_dvec3());
        (b - a).cross(c - a)
    }

    /// Refuses what cannot be traced: no triangles, indices of missing vertices, coordinates that are not finite.
    pub(super) fn check(&self) -> Result<()> {
        if self.triangles.is_empty() {
            return Err(Error::new("the mesh has no triangles").expected("at least one triangle"));
        }
        let vertices = self.positions.len();
        check_length("normals", self.normals.len(), vertices)?;
        check_length("texture coordinates", self.texture_coordinates.len(), vertices)?;
        check_length("material groups", self.materials.len(), self.triangles.len())?;
        self.check_vertices()?;
        let outside = |triangle: &[u32; 3]| triangle.iter().any(|&vertex| vertex as usize >= vertices);
        match self.triangles.iter().position(outside) {
            None => Ok(()),
            Some(triangle) => Err(Error::new(format!(
                "triangle {triangle} has the vertices {:?}, but there are only {vertices}",
                self.triangles[triangle]
            ))
            .expected(format!("numbers from 0 to {}", vertices.saturating_sub(1)))),
        }
    }

    fn check_vertices(&self) -> Result<()> {
        let too_large = |position: &Vec3| position.is_nan() || position.abs().max_element() > LARGEST_COORDINATE;
        if let Some(vertex) = self.positions.iter().position(too_large) {
            return Err(Error::new(format!("vertex {vertex} is at {}", self.positions[vertex]))
                .expected(format!("finite coordinates of at most {LARGEST_COORDINATE:e}")));
        }
        if let Some(vertex) = self.normals.iter().position(|normal| !normal.is_finite()) {
            return Err(Error::new(format!("the normal of vertex {vertex} is {}", self.normals[vertex]))
                .expected("finite numbers"));
        }
        if let Some(vertex) = self.texture_coordinates.iter().position(|uv| !uv.is_finite()) {
            let found = self.texture_coordinates[vertex];
            return Err(Error::new(format!("the texture coordinates of vertex {vertex} are {found}"))
                .expected("finite numbers"));
        }
        Ok(())
    }
}

/// An attribute is given for all or for none.
fn check_length(what: &str, found: usize, wanted: usize) -> Result<()> {
    if found == 0 || found == wanted {
        return Ok(());
    }
    Err(Error::new(format!("the mesh has {found} {what}")).expected(format!("{wanted}, or none")))
}
