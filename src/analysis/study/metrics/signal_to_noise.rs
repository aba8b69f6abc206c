//! Peak signal to noise ratio.

use super::check_sizes;
use crate::math::functions::decimal_logarithm;
use crate::picture::Raster;
use crate::study::plane::display;

/// The peak signal to noise ratio in decibels: `10 log10(1 / mean squared difference)` of the sRGB-encoded channels,
/// cut off at 1. Infinite if the pictures are displayed alike.
pub fn peak_signal_to_noise(picture: &Raster, reference: &Raster) -> f64 {
    check_sizes(picture, reference);
    let squares = picture.pixels().iter().zip(reference.pixels()).map(|(&a, &b)| {
        // NaN is displayed black, and must not pass for it.
        let unknown = if a.is_nan() || b.is_nan() { f64::NAN } else { 0.0 };
        (display(a) - display(b)).as_dvec3().length_squared() + unknown
    });
    let mean = squares.sum::<f64>() / (3 * picture.pixels().len()) as f64;
    if mean == 0.0 { f64::INFINITY } else { -10.0 * decimal_logarithm(mean) }
}
