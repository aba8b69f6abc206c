//! Bias: the part of the error that more samples do not remove.

use crate::math::DVec3;
use crate::picture::Raster;

/// The mean squared difference between the expectation of a rendering and the truth.
///
/// With two renderings x, y and two references a, b, all independent, of a pixel whose expectations are X and A,
///
/// ```text
///   E[(x - a) (y - b)] = (X - A)^2
/// ```
///
/// because the noise of the four is independent and has mean 0. The mean of the product over all pixels therefore estimates
/// the mean squared bias at any noise level; its spread over the pixels gives the standard error. It may be negative.
///
/// Rare light paths that no rendering found look like bias, as in every estimate from samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bias {
    /// Squared bias, in the mean over pixels and channels; an estimate, which may be negative.
    pub squared: f64,
    /// Standard error of `squared`.
    pub squared_error: f64,
}

impl Bias {
    /// How many standard errors from 0 count as bias.
    pub const SIGNIFICANCE: f64 = 3.0;

    /// The bias of renderings that differ in the seed alone, at least two, against the two halves of a reference. Mean over
    /// all pairs, both ways round.
    pub fn estimate(pictures: &[Raster], halves: &[Raster; 2]) -> Self {
        assert!(pictures.len() >= 2, "a bias needs two renderings");
        let pairs = (pictures.len() * (pictures.len() - 1)) as f64;
        let (mut sum, mut squares) = (0.0, 0.0);
        let pixels = halves[0].pixels().len();
        for pixel in 0..pixels {
            let [a, b] = [0, 1].map(|half: usize| halves[half].pixels()[pixel].as_dvec3());
            // Sum over i != j of (x_i - a) (x_j - b): the product of the sums without the terms i = j.
            let (mut from_a, mut from_b, mut same) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO);
            for picture in pictures {
                let x = picture.pixels()[pixel].as_dvec3();
                from_a += x - a;
                from_b += x - b;
                same += (x - a) * (x - b);
            }
            let product = (from_a * from_b - same).element_sum() / (3.0 * pairs);
            sum += product;
            squares += product * product;
        }
        let count = pixels as f64;
        let mean = sum / count;
        Self { squared: mean, squared_error: ((squares / count - mean * mean).max(0.0) / count).sqrt() }
    }

    /// True if there is a bias beyond doubt.
    pub fn is_significant(&self) -> bool {
        self.squared > Self::SIGNIFICANCE * self.squared_error
    }

    /// Root mean square of the bias in units of radiance; 0 if the estimate is negative.
    pub fn root(&self) -> f64 {
        self.squared.max(0.0).sqrt()
    }

    /// The root mean square that the bias does not exceed, as far as can be told.
    pub fn limit(&self) -> f64 {
        (self.squared.max(0.0) + Self::SIGNIFICANCE * self.squared_error).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::sampling::PixelSampler;

    /// Pictures of uniform noise of the given width around a mean.
    fn noise(mean: f32, width: f32, number: u32) -> Raster {
        Raster::from_function(64, 64, |x, y| {
            let [r, g, b, _] = PixelSampler::new(x, y, number).four();
            Vec3::splat(mean) + (Vec3::new(r, g, b) - 0.5) * width
        })
    }

    #[test]
    fn bias_is_found_under_noise_many_times_as_large() {
        // Samples of one pixel are spread evenly, not independently: numbers far apart, of other blocks, are.
        let number = |index: u32| index << 16;
        let halves = [noise(1.0, 0.3, number(1)), noise(1.0, 0.3, number(2))];
        let pictures = |mean| [3, 4, 5].map(|index| noise(mean, 2.0, number(index)));
        let biased = Bias::estimate(&pictures(1.2), &halves);
        assert!((biased.squared - 0.04).abs() < 3.0 * biased.squared_error, "{biased:?}");
        assert!(biased.is_significant() && biased.squared_error < 0.01, "{biased:?}");
        let fair = Bias::estimate(&pictures(1.0), &halves);
        assert!(fair.squared.abs() < 3.0 * fair.squared_error && !fair.is_significant(), "{fair:?}");
        assert!(fair.limit() < 0.2 && fair.limit() > fair.root());
    }
}
