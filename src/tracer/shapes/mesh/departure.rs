//! Departure from a mesh: a ray must not hit the point it starts from.

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
    /// Where the ray starts: see [`MeshDeparture::new`].
    pub(super) origin: DVec3,
    direction: DVec3,
    /// How far the origin may be from where it should be.
    error: f64,
}

impl MeshDeparture {
    /// Puts the origin where it would be without rounding: into the triangle, then off it by the bound of the
    /// rounding error to the side the ray leaves to, and by four times that away from the triangle's edges.
    ///
    /// A ray into a closed mesh then starts inside beyond doubt, and one out of a convex mesh outside.
    /// (The bound in place of an epsilon: Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed., 6.8.)
    pub(super) fn new(geometry: &MeshGeometry, origin: DVec3, direction: DVec3, leaving: (u32, Side)) -> Self {
        let (triangle, side) = leaving;
        let corners = geometry.corners(triangle).map(|corner| corner.as_dvec3());
        let area_vector = geometry.area_vector(triangle);
        let normal = area_vector.normalize_or_zero();
        let magnitude = corners[0].abs().max(corners[1].abs()).max(corners[2].abs()).max_element();
        let error = POSITION_ERROR * magnitude;
        let outward = if side == Side::Front { normal } else { -normal };
        let point = into_triangle(origin, &corners, area_vector);
        let inset = ((corners[0] + corners[1] + corners[2]) / 3.0 - point).clamp_length_max(4.0 * error);
        let height = normal.dot(point - corners[0]);
        let origin = point + inset + (outward * error - normal * height);
        Self { triangle, corners, outward, origin, direction, error: 8.0 * error }
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

/// The point, if its foot on the triangle's plane lies in the triangle; otherwise a point of an edge beside it.
///
/// A point that was in the triangle may have come off by its way through the world, by more the farther the mesh is
/// from the world's origin.
fn into_triangle(point: DVec3, corners: &[DVec3; 3], area_vector: DVec3) -> DVec3 {
    let weight = |from: DVec3, to: DVec3| area_vector.dot((to - from).cross(point - from));
    let [a, b, c] = *corners;
    let weights = [weight(b, c), weight(c, a), weight(a, b)];
    if weights.iter().all(|&weight| weight >= 0.0) {
        return point;
    }
    let weights = weights.map(|weight| weight.max(0.0));
    (a * weights[0] + b * weights[1] + c * weights[2]) / (weights[0] + weights[1] + weights[2])
}

/// Whether any of the corners lies on the side of the plane that the normal points to, beyond doubt.
fn is_above(corners: &[DVec3; 3], on_plane: DVec3, normal: DVec3) -> bool {
    corners.iter().any(|&corner| {
        let offset = corner - on_plane;
        normal.dot(offset) > POSITION_ERROR * offset.abs().max_element()
    })
}
