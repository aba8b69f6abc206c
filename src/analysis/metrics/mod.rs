//! Error metrics between a picture and a reference.
//!
//! Pictures are rasters of linear radiance of the same size; other sizes are a programming error and panic. Sums are in
//! `f64` and in the order of the pixels. A pixel that is not a finite number makes the error of the whole not a number.

mod flip;
mod measures;
mod plane;
mod signal_to_noise;
mod squared_error;
mod structural_similarity;

pub use flip::{PIXELS_A_DEGREE, flip_map};
pub use measures::Metrics;
pub use plane::Plane;
pub(crate) use plane::{display, displayed, gaussian};
pub use signal_to_noise::peak_signal_to_noise;
pub use squared_error::{RelativeError, TAIL, root_mean_square_error};
pub use structural_similarity::structural_similarity;

#[cfg(test)]
mod tests;
