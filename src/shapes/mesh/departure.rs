//! A ray that starts on the mesh must not hit the place it starts from.

use super::geometry::MeshGeometry;
use super::triangle::TriangleHit;
use crate::math::{DVec3, Side};

/// Rounding errors allowed for in a position that was computed, carried to the world and back: 32 roundoffs.
const POSITION_ERROR: f64 = 1.0 / (1u64 << 48) as f64;

/// The triangle a ray leaves.
///
/// That triangle itself is passed over by its number. Of the others only those are in doubt whose plane the origin
/// lies in, up to rounding: neighbours, of which the origin is on the common edge. For them the sign of `t` is noise,
/// and geometry decides instead. A ray from a point of triangle T can only hit triangle N if
///
/// 1. some corner of N lies on the side of T that the ray leaves to, and
/// 2. some corner of T lies on the side of N that the ray comes from.
///
/// ```text
///       ray             1. Convex edge: N lies below T, the ray above;
///        ^                 the hit on N at the edge is none.
///   T   /
///  ----o.           ray
///        ` N         ^   N
///                    |  /       Concave edge: N rises above T,
///             -------o-'        2. but this ray moves away from N.
///                T
/// ```
#[derive(Debug, Clone, Copy)]
pub(super) struct MeshDeparture {
    triangle: u32,
    corners: [DVec3; 3],
    /// Normal of the triangle, unit length, to the side that the ray leaves to.
    outward: DVec3,
    origin: DVec3,
    direction: DVec3,
    /// How far the origin may be from where it should be.
    error: f64,
}

impl MeshDeparture {
    pub(super) fn new(geometry: &MeshGeometry, origin: DVec3, direction: DVec3, leaving: (u32, Side)) -> Self {
        let (triangle, side) = leaving;
        let corners = geometry.corners(triangle).map(|corner| corner.as_dvec3());
        let normal = geometry.area_vector(triangle).normalize_or_zero();
        let magnitude = corners.iter().fold(origin.abs(), |largest, corner| largest.max(corner.abs())).max_element();
        // What the origin is off its plane shows how inexact it is, beyond the rounding of its own coordinates.
        let height = normal.dot(origin - corners[0]).abs();
        let outward = if side == Side::Front { normal } else { -normal };
        Self { triangle, corners, outward, origin, direction, error: POSITION_ERROR * magnitude + 8.0 * height }
    }

    /// The hit on another triangle as it should count: `None` if the ray does not hit it.
    pub(super) fn judge(&self, hit: TriangleHit, triangle: u32, corners: [[f64; 3]; 3]) -> Option<TriangleHit> {
        if triangle == self.triangle {
            return None;
        }
        let corners = corners.map(DVec3::from);
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
        if normal.dot(corners[0] - self.origin).abs() > self.error {
            return (hit.t > 0.0).then_some(hit);
        }
        let toward = if normal.dot(self.direction) < 0.0 { normal } else { -normal };
        let reachable = is_above(&corners, self.corners[0], self.outward);
        let approached = is_above(&self.corners, corners[0], toward);
        // Behind the origin, but not by more than the error makes of it at a grazing angle.
        let start = hit.t * self.direction.length() > -self.error * (1u64 << 20) as f64;
        (reachable && approached && start).then_some(TriangleHit { t: hit.t.max(0.0), ..hit })
    }
}

/// Whether any of the corners lies on the side of the plane that the normal points to, beyond doubt.
fn is_above(corners: &[DVec3; 3], on_plane: DVec3, normal: DVec3) -> bool {
    corners.iter().any(|&corner| {
        let offset = corner - on_plane;
        normal.dot(offset) > POSITION_ERROR * offset.abs().max_element()
    })
}
