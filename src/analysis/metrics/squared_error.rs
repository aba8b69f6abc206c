//! Errors of radiance.

use super::plane::check_sizes;
use crate::math::Vec3;
use crate::picture::Raster;

/// The root of the mean squared difference of all channels of all pixels, in units of radiance.
pub fn root_mean_square_error(picture: &Raster, reference: &Raster) -> f64 {
    check_sizes(picture, reference);
    let squares = picture.pixels().iter().zip(reference.pixels()).map(|(&a, &b)| {
        let difference = (a - b).as_dvec3();
        difference.length_squared()
    });
    (squares.sum::<f64>() / (3 * picture.pixels().len()) as f64).sqrt()
}

/// The share of the pixels that count as the tail: the worst 0.1 %.
pub const TAIL: f64 = 0.001;

/// Keeps black pixels of the reference from dominating (Rousselle et al., Adaptive Sampling and Reconstruction using
/// Greedy Error Minimization, 2011, section 6).
const EPSILON: f64 = 0.01;

/// The squared error of a pixel relative to its reference, `(a - b)^2 / (b^2 + 0.01)`, averaged over the channels.
///
/// A few fireflies dominate the mean: the struct also has the mean without the worst 0.1 % of the pixels, and that of the worst
/// 0.1 % alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeError {
    /// Mean over all pixels.
    pub mean: f64,
    /// Mean over all pixels but the tail.
    pub trimmed: f64,
    /// Mean over the tail; 0 for pictures of less than 1000 pixels, which have none.
    pub tail: f64,
}

impl RelativeError {
    /// The relative error of a picture against its reference. Not symmetric.
    pub fn between(picture: &Raster, reference: &Raster) -> Self {
        check_sizes(picture, reference);
        let pixels = picture.pixels().iter().zip(reference.pixels());
        let mut errors: Vec<f64> = pixels.map(|(&a, &b)| relative_error(a, b)).collect();
        // In ascending order, not a number last: the sums do not depend on where the pixels lie.
        errors.sort_by(f64::total_cmp);
        let tail_count = (errors.len() as f64 * TAIL) as usize;
        let (body, tail) = errors.split_at(errors.len() - tail_count);
        Self { mean: mean(&errors), trimmed: mean(body), tail: mean(tail) }
    }
}

fn relative_error(colour: Vec3, reference: Vec3) -> f64 {
    let (colour, reference) = (colour.as_dvec3(), reference.as_dvec3());
    let difference = colour - reference;
    (difference * difference / (reference * reference + EPSILON)).element_sum() / 3.0
}

fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
}
