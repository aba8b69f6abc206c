//! One channel of a picture.

use crate::colour::{encode_srgb, luminance};
use crate::math::Vec3;
use crate::picture::Raster;
use rayon::prelude::*;

/// A rectangle of numbers, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    width: usize,
    height: usize,
    values: Vec<f32>,
}

impl Plane {
    /// A plane from its values. Panics if the count is not `width * height`.
    pub fn new(width: usize, height: usize, values: Vec<f32>) -> Self {
        assert_eq!(values.len(), width * height, "a plane needs width * height values");
        Self { width, height, values }
    }

    /// One number of every pixel.
    pub fn of_raster(raster: &Raster, value: impl Fn(Vec3) -> f32) -> Self {
        let values = raster.pixels().iter().map(|&colour| value(colour)).collect();
        Self::new(raster.width(), raster.height(), values)
    }

    /// The luma of a picture as displayed: the weights of the luminance applied to the sRGB-encoded channels, `[0, 1]`.
    pub fn luma(raster: &Raster) -> Self {
        Self::of_raster(&displayed(raster), luminance)
    }

    /// Columns of pixels.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows of pixels.
    pub fn height(&self) -> usize {
        self.height
    }

    /// All values, row by row from the top.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// The value in column `x` and row `y`, counted from the top left.
    pub fn at(&self, x: usize, y: usize) -> f32 {
        self.values[y * self.width + x]
    }

    /// Every value as a square of `factor` values.
    pub fn enlarged(&self, factor: usize) -> Self {
        let (width, height) = (self.width * factor, self.height * factor);
        let value = |index: usize| self.at(index % width / factor, index / width / factor);
        Self::new(width, height, (0..width * height).map(value).collect())
    }

    /// The mean of all values.
    pub fn mean(&self) -> f64 {
        self.values.iter().map(|&value| f64::from(value)).sum::<f64>() / self.values.len() as f64
    }

    /// The means of squares of `side` values, row by row; what is left over to the right and below is left out.
    pub fn block_means(&self, side: usize) -> Vec<f64> {
        let columns = self.width() / side;
        let mean = |index: usize| {
            let (left, top) = (index % columns * side, index / columns * side);
            let places = (top..top + side).flat_map(|y| (left..left + side).map(move |x| (x, y)));
            places.map(|(x, y)| f64::from(self.at(x, y))).sum::<f64>() / (side * side) as f64
        };
        (0..columns * (self.height() / side)).map(mean).collect()
    }

    /// A plane computed value by value from two of the same size.
    pub fn zip(&self, other: &Self, value: impl Fn(f32, f32) -> f32) -> Self {
        assert_eq!((self.width, self.height), (other.width, other.height), "planes of different size");
        let values = self.values.iter().zip(&other.values).map(|(&a, &b)| value(a, b)).collect();
        Self::new(self.width, self.height, values)
    }

    /// The plane filtered along rows with one kernel and along columns with another, both of an odd number of taps with
    /// the middle one on the pixel. Outside, the border goes on.
    pub fn filtered(&self, along_rows: &[f32], along_columns: &[f32]) -> Self {
        self.filtered_along_rows(along_rows).filtered_along_columns(along_columns)
    }

    /// The plane filtered from left to right.
    pub fn filtered_along_rows(&self, kernel: &[f32]) -> Self {
        let radius = kernel.len() / 2;
        let mut values = vec![0.0; self.values.len()];
        let mut padded = Vec::with_capacity(self.width + 2 * radius);
        for (row, filtered) in self.values.chunks_exact(self.width).zip(values.chunks_exact_mut(self.width)) {
            padded.clear();
            padded.extend(std::iter::repeat_n(row[0], radius));
            padded.extend_from_slice(row);
            padded.extend(std::iter::repeat_n(row[self.width - 1], radius));
            for (tap, &weight) in kernel.iter().enumerate() {
                add_scaled(filtered, &padded[tap..tap + self.width], weight);
            }
        }
        Self::new(self.width, self.height, values)
    }

    /// The plane filtered from top to bottom.
    pub fn filtered_along_columns(&self, kernel: &[f32]) -> Self {
        let radius = kernel.len() / 2;
        let mut values = vec![0.0; self.values.len()];
        for (y, filtered) in values.chunks_exact_mut(self.width).enumerate() {
            for (tap, &weight) in kernel.iter().enumerate() {
                let row = (y + tap).saturating_sub(radius).min(self.height - 1);
                add_scaled(filtered, &self.values[row * self.width..(row + 1) * self.width], weight);
            }
        }
        Self::new(self.width, self.height, values)
    }
}

fn add_scaled(sums: &mut [f32], values: &[f32], weight: f32) {
    for (sum, &value) in sums.iter_mut().zip(values) {
        *sum += weight * value;
    }
}

/// The sRGB-encoded colour in `[0, 1]` that a display shows of a linear one, cut off at 1.
pub(crate) fn display(colour: Vec3) -> Vec3 {
    Vec3::new(encode_srgb(colour.x), encode_srgb(colour.y), encode_srgb(colour.z))
}

/// The picture that a display shows of a linear one: [`display`] of every pixel.
pub(crate) fn displayed(raster: &Raster) -> Raster {
    let mut shown = raster.clone();
    shown.pixels_mut().par_chunks_mut(PARALLEL_PIXELS).for_each(|pixels| {
        let mut codes = Codes::new();
        for pixel in pixels {
            *pixel = Vec3::new(codes.of(pixel.x), codes.of(pixel.y), codes.of(pixel.z));
        }
    });
    shown
}

/// Pixels that one thread works on at a time.
const PARALLEL_PIXELS: usize = 1 << 16;

/// Codes by their linear values, the latest of those that share a place: pictures of 8 bits hold 256 values, and the
/// power in the encoding is slow.
struct Codes {
    places: Vec<(u32, f32)>,
}

impl Codes {
    /// Binary logarithm of the number of places.
    const BITS: u32 = 12;

    fn new() -> Self {
        // Positive zero in every place, whose code is 0.
        Self { places: vec![(0, 0.0); 1 << Self::BITS] }
    }

    fn of(&mut self, linear: f32) -> f32 {
        let bits = linear.to_bits();
        let place = &mut self.places[(bits.wrapping_mul(0x9E37_79B1) >> (32 - Self::BITS)) as usize];
        if place.0 != bits {
            *place = (bits, encode_srgb(linear));
        }
        place.1
    }
}

/// A sampled Gaussian of the given standard deviation, from `-radius` to `radius`, its sum 1.
pub(crate) fn gaussian(deviation: f64, radius: usize) -> Vec<f32> {
    let offsets = (0..=2 * radius).map(|tap| tap as f64 - radius as f64);
    let weights: Vec<f64> =
        offsets.map(|x| crate::math::functions::exponential_f64(-x * x / (2.0 * deviation * deviation))).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|weight| (weight / sum) as f32).collect()
}

/// Panics unless both are of the same size.
pub(crate) fn check_sizes(picture: &Raster, reference: &Raster) {
    let size = |raster: &Raster| (raster.width(), raster.height());
    assert_eq!(size(picture), size(reference), "pictures of different size");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filtering_is_the_double_sum_with_the_border_going_on() {
        let (width, height) = (7, 5);
        let values = (0..width * height).map(|index| ((index * 29) % 17) as f32).collect();
        let plane = Plane::new(width, height, values);
        let (rows, columns) = ([0.5, -1.0, 0.25, 2.0, 0.125], [1.0, 0.5, -0.25]);
        let filtered = plane.filtered(&rows, &columns);
        for (x, y) in (0..width).flat_map(|x| (0..height).map(move |y| (x, y))) {
            let mut sum = 0.0;
            for (i, a) in rows.iter().enumerate() {
                for (j, b) in columns.iter().enumerate() {
                    let column = (x + i).saturating_sub(2).min(width - 1);
                    let row = (y + j).saturating_sub(1).min(height - 1);
                    sum += a * b * plane.at(column, row);
                }
            }
            assert!((filtered.at(x, y) - sum).abs() < 1e-4, "{x} {y}");
        }
    }

    #[test]
    fn a_picture_is_displayed_as_its_pixels_are() {
        let value = |index: usize| (index % 701) as f32 / 500.0 - 0.2;
        let raster = Raster::from_function(300, 250, |x, y| Vec3::new(value(x * 7 + y), value(x + y * 31), f32::NAN));
        let expected: Vec<Vec3> = raster.pixels().iter().map(|&colour| display(colour)).collect();
        assert_eq!(displayed(&raster).pixels(), expected);
    }

    #[test]
    fn a_gaussian_is_symmetric_and_sums_to_one() {
        let kernel = gaussian(1.5, 5);
        assert_eq!(kernel.len(), 11);
        assert!((kernel.iter().sum::<f32>() - 1.0).abs() < 1e-6);
        assert_eq!(kernel[2], kernel[8]);
    }
}
