//! Structural similarity (Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment, 2004).

use super::plane::check_sizes;
use crate::metrics::{Plane, gaussian};
use crate::picture::Raster;

/// The window: a Gaussian of standard deviation 1.5 over 11 x 11 pixels.
const RADIUS: usize = 5;
const DEVIATION: f64 = 1.5;

/// `(K1 L)^2` and `(K2 L)^2` for a range L of 1.
const STABILISERS: [f64; 2] = [0.01 * 0.01, 0.03 * 0.03];

/// The mean structural similarity of the displayed lumas, in `[-1, 1]`; 1 for equal pictures.
///
/// Averaged over the pixels whose window lies inside the picture, as the authors do; over all pixels, with the border
/// going on outside, if the picture is smaller than a window.
pub fn structural_similarity(picture: &Raster, reference: &Raster) -> f64 {
    check_sizes(picture, reference);
    let (a, b) = (Plane::luma(picture), Plane::luma(reference));
    let kernel = gaussian(DEVIATION, RADIUS);
    let smooth = |plane: &Plane| plane.filtered(&kernel, &kernel);
    let (mean_a, mean_b) = (smooth(&a), smooth(&b));
    let (square_a, square_b) = (smooth(&a.zip(&a, |x, y| x * y)), smooth(&b.zip(&b, |x, y| x * y)));
    let product = smooth(&a.zip(&b, |x, y| x * y));
    let (columns, rows) = inside(a.width(), a.height());
    let mut sum = 0.0;
    for y in rows.clone() {
        for x in columns.clone() {
            let at = |plane: &Plane| f64::from(plane.at(x, y));
            sum += similarity([at(&mean_a), at(&mean_b)], [at(&square_a), at(&square_b)], at(&product));
        }
    }
    // Luma is in range for any colour; what is not a number must show.
    let unknown = picture.pixels().iter().chain(reference.pixels()).any(|colour| colour.is_nan());
    if unknown { f64::NAN } else { sum / (columns.len() * rows.len()) as f64 }
}

/// The columns and rows of the pixels that count.
fn inside(width: usize, height: usize) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
    if width.min(height) > 2 * RADIUS {
        return (RADIUS..width - RADIUS, RADIUS..height - RADIUS);
    }
    (0..width, 0..height)
}

/// The similarity in one window, from the local means, mean squares and mean product (equation 13).
fn similarity([a, b]: [f64; 2], [square_a, square_b]: [f64; 2], product: f64) -> f64 {
    let (variance_a, variance_b) = (square_a - a * a, square_b - b * b);
    let covariance = product - a * b;
    let [c1, c2] = STABILISERS;
    (2.0 * a * b + c1) * (2.0 * covariance + c2) / ((a * a + b * b + c1) * (variance_a + variance_b + c2))
}
