//! Edges and points, which the eye looks for (section 4.2 of the paper).

use super::contrast_sensitivity::PIXELS_A_DEGREE;
use crate::math::functions::exponential_f64;
use crate::metrics::Plane;
use crate::metrics::gaussian;

/// Width of the peak-to-trough features that are looked for, in degrees.
const FEATURE_WIDTH: f64 = 0.082;

/// How strong an edge and a point every pixel is.
pub struct Features {
    edges: Plane,
    points: Plane,
}

impl Features {
    /// The features of a plane of lightness in `[0, 1]`.
    pub fn of_lightness(lightness: &Plane) -> Self {
        let deviation = 0.5 * FEATURE_WIDTH * PIXELS_A_DEGREE;
        let radius = (3.0 * deviation).ceil() as usize;
        let smooth = gaussian(deviation, radius);
        let first = derivative(deviation, radius, |x, _| -x);
        let second = derivative(deviation, radius, |x, variance| x * x / variance - 1.0);
        let across = |kernel: &[f32]| {
            let horizontal = lightness.filtered(kernel, &smooth);
            let vertical = lightness.filtered(&smooth, kernel);
            horizontal.zip(&vertical, |x, y| (x * x + y * y).sqrt())
        };
        Self { edges: across(&first), points: across(&second) }
    }

    /// How different the features of two pictures are at a pixel, in `[0, 1]`.
    pub fn difference(&self, other: &Self, index: usize) -> f32 {
        let apart = |a: &Plane, b: &Plane| (a.values()[index] - b.values()[index]).abs();
        let largest = apart(&self.edges, &other.edges).max(apart(&self.points, &other.points));
        (std::f32::consts::FRAC_1_SQRT_2 * largest).min(1.0).sqrt()
    }
}

/// `factor(x, variance)` times a Gaussian, its positive taps adding up to 1 and its negative ones to -1.
fn derivative(deviation: f64, radius: usize, factor: impl Fn(f64, f64) -> f64) -> Vec<f32> {
    let variance = deviation * deviation;
    let offsets = (0..=2 * radius).map(|tap| tap as f64 - radius as f64);
    let taps: Vec<f64> = offsets.map(|x| factor(x, variance) * exponential_f64(-x * x / (2.0 * variance))).collect();
    let positive: f64 = taps.iter().filter(|&&tap| tap > 0.0).sum();
    let negative: f64 = -taps.iter().filter(|&&tap| tap < 0.0).sum::<f64>();
    taps.iter().map(|&tap| (if tap > 0.0 { tap / positive } else { tap / negative }) as f32).collect()
}
