//! The input data of a mesh.

use crate::error::{Error, Result};
use crate::math::{DVec3, Vec2, Vec3};

/// Largest coordinate of a vertex: products of three of them must stay finite in `f32`.
const LARGEST_COORDINATE: f32 = 1e12;

/// Triangles over shared vertices, in the mesh's own space.
///
/// A triangle's front is where its vertices run counter-clockwise.
#[derive(Debug, Clone, Default)]
pub struct MeshGeometry {
    /// Position of each vertex.
    pub positions: Vec<Vec3>,
    /// Shading normal of each vertex (any length; zero where it has none), or empty: then the faces are flat.
    pub normals: Vec<Vec3>,
    /// Texture coordinates of each vertex, or empty: then they are (0, 0).
    pub texture_coordinates: Vec<Vec2>,
    /// Linear RGB of each vertex, or empty: then it is black.
    pub colours: Vec<Vec3>,
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

    /// What there is to say of the inside and the outside of the triangles of some groups.
    pub fn outside_of(&self, is_meant: impl Fn(u32) -> bool) -> Outside {
        // Vertices at one place are one, whatever else they carry.
        let mut order: Vec<u32> = (0..self.positions.len() as u32).collect();
        let key =
            |vertex: &u32| self.positions[*vertex as usize].to_array().map(|coordinate| (coordinate + 0.0).to_bits());
        order.sort_unstable_by_key(key);
        let mut places = vec![0; order.len()];
        for (number, group) in order.chunk_by(|a, b| key(a) == key(b)).enumerate() {
            group.iter().for_each(|&vertex| places[vertex as usize] = number as u32);
        }
        let group = |triangle: usize| self.materials.get(triangle).copied().unwrap_or(0);
        let (mut edges, mut volume) = (Vec::new(), 0.0);
        for (number, triangle) in self.triangles.iter().enumerate().filter(|(number, _)| is_meant(group(*number))) {
            let [a, b, c] = triangle.map(|vertex| places[vertex as usize]);
            // An edge in its own direction, and whether that is from the lower number to the higher.
            edges.extend([(a, b), (b, c), (c, a)].map(|(from, to)| (from.min(to), from.max(to), from < to)));
            let [a, b, c] = self.corners(number as u32).map(|corner| corner.as_dvec3());
            volume += a.dot(b.cross(c)) / 6.0;
        }
        edges.retain(|(low, high, _)| low != high);
        edges.sort_unstable();
        let open =
            |edge: &&[(u32, u32, bool)]| edge.iter().map(|(_, _, up)| if *up { 1 } else { -1 }).sum::<i64>() != 0;
        let open_edges = edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter(open).count();
        Outside { open_edges, volume }
    }

    /// Refuses what cannot be traced: no triangles, indices of missing vertices, coordinates that are not finite.
    pub(super) fn check(&self) -> Result<()> {
        if self.triangles.is_empty() {
            return Err(Error::new("the mesh has no triangles").expected("at least one triangle"));
        }
        let vertices = self.positions.len();
        check_length("normals", self.normals.len(), vertices)?;
        check_length("texture coordinates", self.texture_coordinates.len(), vertices)?;
        check_length("colours", self.colours.len(), vertices)?;
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

/// Whether triangles enclose a space, and from which side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outside {
    /// Edges along which as many triangles do not run one way as the other.
    pub open_edges: usize,
    /// The enclosed volume; negative if the fronts face inwards.
    pub volume: f64,
}

impl Outside {
    /// Why glass has no inside here; `None` if it has one.
    pub fn problem(&self) -> Option<String> {
        match self {
            Self { open_edges: 0, volume } if *volume >= 0.0 => None,
            Self { open_edges: 0, .. } => {
                Some("whose front sides face inwards: inside and outside are exchanged (reverse its faces)".to_owned())
            }
            Self { open_edges: 1, .. } => Some("with an open edge: it has no inside".to_owned()),
            Self { open_edges: count, .. } => Some(format!("with {count} open edges: it has no inside")),
        }
    }
}

/// An attribute is given for all or for none.
fn check_length(what: &str, found: usize, wanted: usize) -> Result<()> {
    if found == 0 || found == wanted {
        return Ok(());
    }
    Err(Error::new(format!("the mesh has {found} {what}")).expected(format!("{wanted}, or none")))
}
