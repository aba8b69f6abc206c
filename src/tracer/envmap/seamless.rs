//! Bilinear filtering that reads across the border of a face.
//!
//! Beyond the border of a face lies the neighbour's outermost row of texels, folded around the edge:
//!
//! ```text
//!      this face      | neighbour, unfolded        direction of a texel at distance e beyond the edge:
//!     . . . . . o o o | o . . .                    the edge's axis takes the value 1 (it leads now), and the
//!                  u = 1                            face's own axis 1 - e, the coordinate along the edge stays
//! ```
//!
//! At a corner of the cube three faces meet, and the fourth texel does not exist: it is the mean of the other three
//! (as in the OpenGL extension ARB_seamless_cube_map).

use super::lookup::{FacePoint, ImagePoint, Lookup};
use crate::math::Vec3;

/// The four texels around a place near the border of a face, on the face itself and its neighbours.
pub(super) struct Corners {
    /// The texel centres at (low u, low v), (high u, low v), (low u, high v), (high u, high v); `None` beyond a corner of
    /// the cube.
    pub places: [Option<ImagePoint>; 4],
    /// Share of the high u.
    across: f32,
    /// Share of the high v.
    along: f32,
}

impl Corners {
    /// The texels around a place on a face of `size` texels. `None` if they all lie inside the face.
    pub fn new(lookup: &Lookup, point: FacePoint, size: usize) -> Option<Self> {
        let size = size as f32;
        // Texel centres are at half integers.
        let (x, y) = (point.u * size - 0.5, point.v * size - 0.5);
        let (left, low) = (x.floor(), y.floor());
        let inside = left >= 0.0 && low >= 0.0 && left + 1.0 < size && low + 1.0 < size;
        if inside {
            return None;
        }
        let corners = [(left, low), (left + 1.0, low), (left, low + 1.0), (left + 1.0, low + 1.0)];
        let places = corners.map(|(i, j)| texel(lookup, point, size, i, j));
        Some(Self { places, across: x - left, along: y - low })
    }

    /// The colours of the four texels, read by `colour_at`; one that does not exist is the mean of the others.
    #[inline]
    pub fn colours(&self, colour_at: impl Fn(ImagePoint) -> Option<Vec3>) -> [Vec3; 4] {
        let texels = self.places.map(|place| colour_at(place?));
        let known: Vec3 = texels.iter().flatten().copied().sum();
        let count = texels.iter().flatten().count().max(1) as f32;
        texels.map(|texel| texel.unwrap_or(known / count))
    }

    /// The mean of the four colours by their distances.
    pub fn blend(&self, [a, b, c, d]: [Vec3; 4]) -> Vec3 {
        let (across, along) = (self.across, self.along);
        (a * (1.0 - across) + b * across) * (1.0 - along) + (c * (1.0 - across) + d * across) * along
    }

    /// What each of the four counts in [`Corners::blend`].
    pub fn weights(&self) -> [f32; 4] {
        let (across, along) = (self.across, self.along);
        [(1.0 - across) * (1.0 - along), across * (1.0 - along), (1.0 - across) * along, across * along]
    }
}

/// The texel in column `i` and row `j` counted along u and v; `None` beyond a corner of the cube.
fn texel(lookup: &Lookup, point: FacePoint, size: f32, i: f32, j: f32) -> Option<ImagePoint> {
    let row = lookup.row(point.face);
    // Coordinates of the texel centre on the face's plane, the face being [-1, 1].
    let (a, b) = ((2.0 * i + 1.0) / size - 1.0, (2.0 * j + 1.0) / size - 1.0);
    let (beyond_a, beyond_b) = ((a.abs() - 1.0).max(0.0), (b.abs() - 1.0).max(0.0));
    if beyond_a > 0.0 && beyond_b > 0.0 {
        return None;
    }
    // Fold around the edge: the coordinate that left the face becomes the leading one.
    let direction = point.face.normal() * (1.0 - beyond_a - beyond_b)
        + row.u.direction() * a.clamp(-1.0, 1.0)
        + row.v.direction() * b.clamp(-1.0, 1.0);
    Some(lookup.image_point(lookup.locate(direction)))
}
