//! The errors of renderings against the reference.

use serde::Serialize;

use crate::metrics::{RelativeError, flip_map, root_mean_square_error};
use crate::picture::Raster;

/// Errors of renderings that differ in the seed alone: means over them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Errors {
    /// Root of the mean square error, in units of radiance.
    pub rmse: f64,
    /// Mean of the squared error over the squared reference, see [`RelativeError`].
    pub relative_mse: f64,
    /// The same without the worst 0.1 % of the pixels.
    pub trimmed_relative_mse: f64,
    /// Mean FLIP of the displayed pictures.
    pub flip: f64,
}

impl Errors {
    /// The errors of one picture.
    pub fn between(picture: &Raster, reference: &Raster) -> Self {
        let relative = RelativeError::between(picture, reference);
        Self {
            rmse: root_mean_square_error(picture, reference),
            relative_mse: relative.mean,
            trimmed_relative_mse: relative.trimmed,
            flip: flip_map(picture, reference).mean(),
        }
    }

    /// The mean of the errors of several pictures; of the root mean square error the mean is taken of the squares.
    pub fn mean_between(pictures: &[Raster], reference: &Raster) -> Self {
        let errors: Vec<Self> = pictures.iter().map(|picture| Self::between(picture, reference)).collect();
        let mean = |value: fn(&Self) -> f64| errors.iter().map(value).sum::<f64>() / errors.len() as f64;
        Self {
            rmse: mean(|errors| errors.rmse * errors.rmse).sqrt(),
            relative_mse: mean(|errors| errors.relative_mse),
            trimmed_relative_mse: mean(|errors| errors.trimmed_relative_mse),
            flip: mean(|errors| errors.flip),
        }
    }
}

/// Mean over all pixels and channels.
pub(super) fn mean_radiance(picture: &Raster) -> f64 {
    let sum: f64 = picture.pixels().iter().map(|colour| colour.as_dvec3().element_sum()).sum();
    sum / (3 * picture.pixels().len()) as f64
}
