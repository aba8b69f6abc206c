//! Whether what is left looks like noise.

use super::undoing::Aligned;
use crate::study::Plane;

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
        let difference = Plane::luma(&aligned.mine).zip(&Plane::luma(&aligned.expected), |a, b| a - b);
        let (width, height) = (difference.width(), difference.height());
        let square = |value: f64| value * value;
        let count = (width * height) as f64;
        let variance = difference.values().iter().map(|&value| square(f64::from(value))).sum::<f64>() / count;
        let (mut blocks, mut block_variance) = (0usize, 0.0);
        for top in (0..(height / BLOCK) * BLOCK).step_by(BLOCK) {
            for left in (0..(width / BLOCK) * BLOCK).step_by(BLOCK) {
                let rows = (top..top + BLOCK).flat_map(|y| (left..left + BLOCK).map(move |x| (x, y)));
                let sum: f64 = rows.map(|(x, y)| f64::from(difference.at(x, y))).sum();
                block_variance += square(sum / (BLOCK * BLOCK) as f64);
                blocks += 1;
            }
        }
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
