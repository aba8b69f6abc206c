//! How far a picture is from a reference, in numbers.
//!
//! Pictures are rasters of linear radiance of the same size; other sizes are a programming error and panic. Sums are in
//! `f64` and in the order of the pixels. A pixel that is not a finite number makes the error of the whole not a number.

mod flip;
mod plane;
mod signal_to_noise;
mod squared_error;
mod structural_similarity;

pub use flip::{PIXELS_A_DEGREE, flip_map};
pub use plane::Plane;
pub(crate) use plane::{display, displayed, gaussian};
pub use signal_to_noise::peak_signal_to_noise;
pub use squared_error::{RelativeError, TAIL, root_mean_square_error};
pub use structural_similarity::structural_similarity;

use crate::picture::Raster;

/// The four measures that `compare` prints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metrics {
    /// Root mean square error of the linear radiance; 0 for equal pictures.
    pub rmse: f64,
    /// Peak signal to noise ratio of the displayed pictures in decibels; infinite for equal ones.
    pub psnr: f64,
    /// Structural similarity of the displayed lumas; 1 for equal pictures.
    pub ssim: f64,
    /// Mean FLIP of the displayed pictures, `[0, 1]`; 0 for equal ones.
    pub flip: f64,
}

impl Metrics {
    /// The measures of a picture and a reference, and the FLIP of every pixel.
    pub fn with_flip_map(picture: &Raster, reference: &Raster) -> (Self, Plane) {
        let map = flip_map(picture, reference);
        let metrics = Self {
            rmse: root_mean_square_error(picture, reference),
            psnr: peak_signal_to_noise(picture, reference),
            ssim: structural_similarity(picture, reference),
            flip: map.mean(),
        };
        (metrics, map)
    }
}

/// Panics unless both are of the same size.
fn check_sizes(picture: &Raster, reference: &Raster) {
    let size = |raster: &Raster| (raster.width(), raster.height());
    assert_eq!(size(picture), size(reference), "pictures of different size");
}

#[cfg(test)]
mod tests;
