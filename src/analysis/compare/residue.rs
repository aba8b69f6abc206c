//! Whether the remaining difference looks like noise.

use super::region::Region;
use super::undoing::Aligned;
use crate::math::Vec3;
use crate::metrics::{Plane, display};
use crate::picture::Raster;

/// The difference of two pictures that else agree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Residue {
    /// Standard deviation of the difference of the lumas, in codes of 255.
    pub deviation: f64,
    /// Variance of the means of blocks against what independent pixels would give: near 1 for noise, large for shapes.
    pub structure: f64,
}

/// Side of the blocks.
const BLOCK: usize = 8;
/// Above this the difference has shape. Rough edges of few samples give 1 to 4.
const LARGEST_OF_NOISE: f64 = 6.0;
/// Less noise than this, in codes of 255, is not worth a word.
const SMALLEST_NAMED: f64 = 4.0;

impl Residue {
    pub fn of(aligned: &Aligned) -> Self {
        Self::of_differences(&[Plane::luma(&aligned.mine).zip(&Plane::luma(&aligned.expected), |a, b| a - b)])
    }

    /// Of all three channels in a region, which is given in pixels of the expected picture; `corner` is where the
    /// pictures begin in that.
    pub fn within(mine: &Raster, expected: &Raster, corner: [usize; 2], region: Region) -> Self {
        let [left, top] = [region.x - corner[0], region.y - corner[1]];
        let places = (top..top + region.height).flat_map(|y| (left..left + region.width).map(move |x| (x, y)));
        let difference = |(x, y)| display(mine.pixel(x, y)) - display(expected.pixel(x, y));
        let differences: Vec<Vec3> = places.map(difference).collect();
        let plane = |channel: usize| {
            Plane::new(region.width, region.height, differences.iter().map(|colour| colour[channel]).collect())
        };
        Self::of_differences(&[plane(0), plane(1), plane(2)])
    }

    /// Of planes of one size; their variances add up.
    fn of_differences(differences: &[Plane]) -> Self {
        let (width, height) = (differences[0].width(), differences[0].height());
        let square = |value: f64| value * value;
        let count = (width * height) as f64;
        let squares = |plane: &Plane| plane.values().iter().map(|&value| square(f64::from(value))).sum::<f64>();
        let variance = differences.iter().map(squares).sum::<f64>() / count;
        let means: Vec<Vec<f64>> = differences.iter().map(|plane| plane.block_means(BLOCK)).collect();
        let blocks = means[0].len();
        let of_block = |block: usize| means.iter().map(|means| square(means[block])).sum::<f64>();
        let block_variance = (0..blocks).map(of_block).sum::<f64>();
        let expected = variance / (BLOCK * BLOCK) as f64;
        let structure =
            if blocks == 0 || expected == 0.0 { f64::INFINITY } else { block_variance / blocks as f64 / expected };
        Self { deviation: 255.0 * variance.sqrt(), structure }
    }

    /// True if the difference has no shape.
    pub fn is_noise(&self) -> bool {
        self.structure <= LARGEST_OF_NOISE
    }

    /// True if it is noise, and much of it.
    pub fn is_notable_noise(&self) -> bool {
        self.is_noise() && self.deviation >= SMALLEST_NAMED
    }
}
