//! Triangle meshes: any number of triangles, hit by rays from both sides.
//!
//! A mesh is traced in object space; the caller transforms the ray into it and the hit back, so one mesh serves any
//! number of instances.

mod departure;
mod geometry;
mod packet;
mod surface;
mod triangle;
mod wavefront;

pub use geometry::MeshGeometry;
pub use surface::MeshPoint;
pub use triangle::{ShearedRay, TriangleHit};
pub use wavefront::{ObjFile, ObjMap, ObjMaterial, ObjMaterials};

use crate::bvh::{FloatBox, Hierarchy, HierarchyRay, Visit};
use crate::error::{Error, Result};
use crate::math::{Bounds, DVec3, Side};
use crate::memory::{claim_memory, on_large_pages, prefetch};
use departure::MeshDeparture;
use packet::{Packet, PacketRay};

/// What building the hierarchy takes beside the geometry at most, by measurement.
const BYTES_A_TRIANGLE: u64 = 320;

/// A mesh with its hierarchy.
#[derive(Debug, Clone)]
pub struct Mesh {
    geometry: MeshGeometry,
    hierarchy: Hierarchy,
    /// The triangles of each leaf.
    packets: Vec<Packet>,
    degenerate: usize,
}

/// Where a ray hits a mesh first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshHit {
    /// Ray parameter, not negative, in units of the direction's length. 0 only for a ray that leaves the mesh right
    /// at an edge and crosses the neighbour there.
    pub t: f64,
    /// Number of the triangle, as given.
    pub triangle: u32,
    /// Weights of its three vertices: none negative, sum 1 up to rounding.
    pub barycentric: [f64; 3],
}

impl Mesh {
    /// Checks the geometry and builds the hierarchy over it.
    ///
    /// Triangles without area cannot be hit: they keep their numbers but are kept out of the hierarchy. An error is a
    /// mesh without triangles (of any area), an index of a missing vertex, or a coordinate that is not finite.
    pub fn new(geometry: MeshGeometry) -> Result<Self> {
        geometry.check()?;
        let count = geometry.triangles.len();
        let _claim = claim_memory(count as u64 * BYTES_A_TRIANGLE, format_args!("the hierarchy of {count} triangles"))?;
        let all = 0..geometry.triangles.len() as u32;
        let solid: Vec<u32> = all.filter(|&triangle| geometry.area_vector(triangle) != DVec3::ZERO).collect();
        if solid.is_empty() {
            return Err(Error::new("all triangles of the mesh have zero area").expected("one triangle with an area"));
        }
        let boxes: Vec<FloatBox> = solid.iter().map(|&triangle| FloatBox::around(geometry.corners(triangle))).collect();
        let hierarchy = Hierarchy::build(&boxes);
        let packet = |leaf: u32| {
            let numbers = hierarchy.leaf(leaf).iter().map(|&number| solid[number as usize]);
            Packet::new(&numbers.map(|triangle| (triangle, geometry.corners(triangle))).collect::<Vec<_>>())
        };
        let mut packets = on_large_pages(hierarchy.leaf_count());
        packets.extend((0..hierarchy.leaf_count() as u32).map(packet));
        let degenerate = geometry.triangles.len() - solid.len();
        Ok(Self { geometry, hierarchy, packets, degenerate })
    }

    /// The vertices and triangles as given.
    pub fn geometry(&self) -> &MeshGeometry {
        &self.geometry
    }

    /// How many triangles have no area and are never hit.
    pub fn degenerate_triangles(&self) -> usize {
        self.degenerate
    }

    /// The box around all triangles that can be hit.
    pub fn bounds(&self) -> Bounds {
        self.hierarchy.bounds().to_bounds()
    }

    /// The first hit at a ray parameter above 0 and below `t_max`.
    ///
    /// `direction` need not have unit length. `leaving` is the triangle of this mesh that the ray starts on and the
    /// side it leaves to; without it the origin is taken to lie in free space.
    pub fn intersect(
        &self,
        origin: DVec3,
        direction: DVec3,
        t_max: f64,
        leaving: Option<(u32, Side)>,
    ) -> Option<MeshHit> {
        let query = Query::new(self, origin, direction, leaving)?;
        let announce = |leaf: u32| prefetch(&self.packets[leaf as usize]);
        let mut closest: Option<MeshHit> = None;
        self.hierarchy.traverse(&query.ray, t_max, announce, |leaf| {
            let limit = closest.map_or(t_max, |hit| hit.t);
            query.hits(&self.packets[leaf as usize], |hit| {
                // Of two hits at the same place the lower number counts, in whatever order they are found.
                let closer = closest.map_or(hit.t < t_max, |best| (hit.t, hit.triangle) < (best.t, best.triangle));
                if closer {
                    closest = Some(hit);
                }
                false
            });
            closest.filter(|hit| hit.t < limit).map_or(Visit::Continue, |hit| Visit::Closer(hit.t))
        });
        closest
    }

    /// Whether anything is hit at a ray parameter above 0 and below `t_max`: see [`Mesh::intersect`].
    pub fn occluded(&self, origin: DVec3, direction: DVec3, t_max: f64, leaving: Option<(u32, Side)>) -> bool {
        let Some(query) = Query::new(self, origin, direction, leaving) else { return false };
        let announce = |leaf: u32| prefetch(&self.packets[leaf as usize]);
        let mut found = false;
        self.hierarchy.traverse(&query.ray, t_max, announce, |leaf| {
            found = query.hits(&self.packets[leaf as usize], |hit| hit.t < t_max);
            if found { Visit::Stop } else { Visit::Continue }
        });
        found
    }
}

/// A ray, ready for everything it meets in a mesh.
struct Query {
    ray: HierarchyRay,
    sheared: ShearedRay,
    packet: PacketRay,
    departure: Option<MeshDeparture>,
}

impl Query {
    #[inline]
    fn new(mesh: &Mesh, origin: DVec3, direction: DVec3, leaving: Option<(u32, Side)>) -> Option<Self> {
        let departure = leaving.map(|leaving| MeshDeparture::new(&mesh.geometry, origin, direction, leaving));
        let origin = departure.map_or(origin, |departure| departure.origin);
        let ray = mesh.hierarchy.ray(origin, direction)?;
        let sheared = ShearedRay::new(origin, direction);
        let packet = PacketRay::new(&ray, &sheared);
        Some(Self { ray, sheared, packet, departure })
    }

    /// Calls `found` for the hits in a packet until it returns true; returns whether it did.
    #[inline]
    fn hits(&self, packet: &Packet, mut found: impl FnMut(MeshHit) -> bool) -> bool {
        let mut candidates = self.packet.candidates(packet);
        while candidates != 0 {
            let place = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            if self.hit(packet, place).is_some_and(&mut found) {
                return true;
            }
        }
        false
    }

    #[inline]
    fn hit(&self, packet: &Packet, place: usize) -> Option<MeshHit> {
        let triangle = packet.triangles[place];
        if triangle == Packet::NONE {
            return None;
        }
        let corners = packet.triangle(place);
        let hit = self.sheared.intersect(corners)?;
        let hit = match &self.departure {
            None => (hit.t > 0.0).then_some(hit),
            Some(departure) => departure.judge(hit, triangle, corners),
        }?;
        Some(MeshHit { t: hit.t, triangle, barycentric: hit.barycentric })
    }
}
