//! The distance of colours, and its place in `[0, 1]` (section 4.1.2 and 4.1.3 of the paper).

use std::sync::LazyLock;

use super::colour_space::{hunt_adjusted, lab_of_linear};
use crate::math::Vec3;
use crate::math::functions::power;

/// Compresses large distances.
const COMPRESSION: f32 = 0.7;
/// Distances below this share of the largest one fill `[0, FILLED]`: what is above is different, never mind how much.
const SMALL_SHARE: f32 = 0.4;
const FILLED: f32 = 0.95;

/// The largest compressed distance of two displayed colours: green and blue.
static LARGEST: LazyLock<f32> = LazyLock::new(|| {
    let adjusted = |linear: Vec3| hunt_adjusted(lab_of_linear(linear));
    distance(adjusted(Vec3::Y), adjusted(Vec3::Z))
});

/// The compressed HyAB distance of two Hunt-adjusted Lab colours: city block in lightness, Euclidean in colourfulness.
pub fn distance(a: Vec3, b: Vec3) -> f32 {
    let difference = a - b;
    let chroma = (difference.y * difference.y + difference.z * difference.z).sqrt();
    power(difference.x.abs() + chroma, COMPRESSION)
}

/// A compressed distance brought into `[0, 1]`.
pub fn redistributed(distance: f32) -> f32 {
    let largest = *LARGEST;
    let small = SMALL_SHARE * largest;
    if distance < small {
        return distance * FILLED / small;
    }
    (FILLED + (distance - small) / (largest - small) * (1.0 - FILLED)).min(1.0)
}
