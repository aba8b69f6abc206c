//! All measures of a picture at once.

use super::flip::flip_map;
use super::plane::Plane;
use super::signal_to_noise::peak_signal_to_noise;
use super::squared_error::root_mean_square_error;
use super::structural_similarity::structural_similarity;
use crate::digits::digits;
use crate::picture::Raster;

/// The four measures that `compare` prints.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Metrics {
    /// Root mean square error of the linear radiance; 0 for equal pictures.
    #[serde(serialize_with = "digits::<5, _>")]
    pub rmse: f64,
    /// Peak signal to noise ratio of the displayed pictures in decibels; infinite for equal ones.
    #[serde(serialize_with = "digits::<2, _>")]
    pub psnr: f64,
    /// Structural similarity of the displayed lumas; 1 for equal pictures.
    #[serde(serialize_with = "digits::<5, _>")]
    pub ssim: f64,
    /// Mean FLIP of the displayed pictures, `[0, 1]`; 0 for equal ones.
    #[serde(serialize_with = "digits::<5, _>")]
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
