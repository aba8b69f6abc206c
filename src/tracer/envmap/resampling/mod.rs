//! Maps resampled: a cube as an equirectangular picture and back, in any size.
//!
//! A texel of the result is the mean of the map over the square that the texel covers, by samples on a regular grid:
//!
//! ```text
//!    +---------+     n samples across and down: as many as texels of the map lie side by side in the square, at least 2.
//!    | .  .  . |     Each looks along its direction, and reads the map between its texels by cubic convolution
//!    | .  .  . |     (Keys, Cubic Convolution Interpolation for Digital Image Processing, 1981).
//!    | .  .  . |
//!    +---------+     Light is averaged, not codes.
//! ```
//!
//! Bilinear samples would blur: where map and result have texels of about one size, as when a panorama becomes faces of a
//! quarter of its width, their error is three times as large.

mod padded;
mod sky;

use std::f64::consts::PI;

use super::axis::SignedAxis;
use super::background::Longitudes;
use super::face::Face;
use super::lookup::Lookup;
use crate::math::functions::cos;
use crate::math::{DVec3, Vec3};
use crate::parallel;
use crate::picture::Raster;
pub use sky::Sky;

/// The least and the most samples across a texel. So many texels of the map lie side by side in one only around the poles of
/// an equirectangular picture.
const SAMPLES_ACROSS: [f64; 2] = [2.0, 64.0];

/// The image that a lookup reads for a face, `side` texels wide and high.
pub fn face_image(sky: &Sky, lookup: &Lookup, face: Face, side: usize) -> Raster {
    let texel_angle = 2.0 / side as f64;
    resampled(sky, [side, side], texel_angle, |right, down| lookup.image_direction(face, right, down))
}

/// The map as an equirectangular picture, twice as wide as high; `up` and `turns` as in
/// [`Equirectangular`](super::Equirectangular).
pub fn equirectangular_image(sky: &Sky, up: SignedAxis, turns: f64, height: usize) -> Raster {
    let longitudes = Longitudes::new(up, turns);
    let texel_angle = PI / height as f64;
    resampled(sky, [2 * height, height], texel_angle, |right, down| longitudes.direction(right, cos(PI * down)))
}

/// The picture that looks along `direction(right, down)`, both from 0 to 1. Its texels span at most `texel_angle`.
fn resampled(
    sky: &Sky,
    [width, height]: [usize; 2],
    texel_angle: f64,
    direction: impl Fn(f64, f64) -> DVec3 + Sync,
) -> Raster {
    // The direction through a place of a texel, from its left and top border.
    let through = |x: usize, y: usize, right: f64, down: f64| {
        direction((x as f64 + right) / width as f64, (y as f64 + down) / height as f64)
    };
    let row = |y: usize| {
        let texel = |x: usize| {
            let beside = texel_angle / sky.texel_angle(through(x, y, 0.5, 0.5));
            let across = beside.ceil().clamp(SAMPLES_ACROSS[0], SAMPLES_ACROSS[1]) as usize;
            let place = |index: usize| (index as f64 + 0.5) / across as f64;
            let samples = (0..across * across).map(|index| (place(index % across), place(index / across)));
            let sum: Vec3 = samples.map(|(right, down)| sky.colour(through(x, y, right, down))).sum();
            sum / (across * across) as f32
        };
        (0..width).map(texel).collect::<Vec<_>>()
    };
    Raster::from_pixels(width, height, parallel::map(0..height, row).concat())
}
