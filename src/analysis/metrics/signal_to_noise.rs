//! Peak signal to noise ratio.

use super::plane::check_sizes;
use crate::math::functions::decimal_logarithm;
use crate::metrics::displayed;
use crate::picture::Raster;

/// The peak signal to noise ratio in decibels: `10 log10(1 / mean squared difference)` of the sRGB-encoded channels,
/// cut off at 1. Infinite if the pictures are displayed alike.
pub fn peak_signal_to_noise(picture: &Raster, reference: &Raster) -> f64 {
    check_sizes(picture, reference);
    let (shown, expected) = (displayed(picture), displayed(reference));
    let linear = picture.pixels().iter().zip(reference.pixels());
    let squares = shown.pixels().iter().zip(expected.pixels()).zip(linear).map(|((&a, &b), (mine, other))| {
        // NaN is displayed black, and must not pass for it.
        let unknown = if mine.is_nan() || other.is_nan() { f64::NAN } else { 0.0 };
        (a - b).as_dvec3().length_squared() + unknown
    });
    let mean = squares.sum::<f64>() / (3 * picture.pixels().len()) as f64;
    if mean == 0.0 { f64::INFINITY } else { -10.0 * decimal_logarithm(mean) }
}
