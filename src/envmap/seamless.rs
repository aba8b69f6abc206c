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

use super::cube_map::CubeMap;
use super::lookup::FacePoint;
use crate::math::Vec3;
use crate::picture::Picture;

/// The colour at a place on the cube, from the four nearest texel centres on this face and its neighbours.
pub(super) fn sample(map: &CubeMap, point: FacePoint, picture: &Picture) -> Vec3 {
    let size = picture.width() as f32;
    // Texel centres are at half integers.
    let (x, y) = (point.u * size - 0.5, point.v * size - 0.5);
    let (left, low) = (x.floor(), y.floor());
    let (across, along) = (x - left, y - low);
    let inside = left >= 0.0 && low >= 0.0 && left + 1.0 < size && low + 1.0 < size;
    if inside {
        return map.lookup().image_point(point).bilinear(picture);
    }
    let corners = [(left, low), (left + 1.0, low), (left, low + 1.0), (left + 1.0, low + 1.0)];
    let texels = corners.map(|(i, j)| texel(map, point, size, i, j));
    let known: Vec3 = texels.iter().flatten().copied().sum();
    let count = texels.iter().flatten().count().max(1) as f32;
    let [a, b, c, d] = texels.map(|texel| texel.unwrap_or(known / count));
    (a * (1.0 - across) + b * across) * (1.0 - along) + (c * (1.0 - across) + d * across) * along
}

/// The texel in column `i` and row `j` counted along u and v; `None` beyond a corner of the cube.
fn texel(map: &CubeMap, point: FacePoint, size: f32, i: f32, j: f32) -> Option<Vec3> {
    let row = map.lookup().row(point.face);
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
    let place = map.lookup().locate(direction);
    let neighbour = map.face_picture(place.face)?;
    Some(map.lookup().image_point(place).nearest(neighbour))
}
