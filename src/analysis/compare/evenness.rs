//! Uniform pictures: one tone, or one tone and noise.

use serde::Serialize;

use super::finding::{Finding, Kind, Weight};
use crate::colour::luminance;
use crate::digits::digits;
use crate::metrics::Plane;
use crate::picture::Raster;

/// Below this standard deviation of the luma a picture shows nothing.
const FLAT: f64 = 0.002;
/// Side of the blocks whose means are compared.
const BLOCK: usize = 8;
/// Block means that differ by less, a code and a half, show nothing: a lossy file leaves that.
const STEADY: f64 = 0.006;
/// Variance of the block means against that of independent pixels.
const LARGEST_OF_NOISE: f64 = 3.0;
/// More than this is not noise around one tone.
const LOUDEST: f64 = 0.15;

/// How far the luma of a picture scatters, in codes of `[0, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Evenness {
    /// Mean luma.
    pub luma: f64,
    /// Standard deviation of the pixels.
    pub deviation: f64,
    /// Standard deviation of the means of blocks.
    block_deviation: f64,
}

impl Evenness {
    /// Of a picture of display codes.
    pub fn of(codes: &Raster) -> Self {
        let luma = Plane::of_raster(codes, luminance);
        let mean = luma.mean();
        let square = |value: f64| (value - mean) * (value - mean);
        let variance = luma.values().iter().map(|&value| square(f64::from(value))).sum::<f64>();
        let blocks = block_means(&luma);
        let block_variance = blocks.iter().map(|&value| square(value)).sum::<f64>();
        Self {
            luma: mean,
            deviation: (variance / luma.values().len() as f64).sqrt(),
            block_deviation: (block_variance / blocks.len().max(1) as f64).sqrt(),
        }
    }

    /// True if every pixel is of one tone.
    pub fn is_flat(&self) -> bool {
        self.deviation < FLAT
    }

    /// True if there is one tone, and around it nothing but noise.
    pub fn is_even(&self) -> bool {
        let independent = self.deviation / BLOCK as f64;
        let quiet = self.block_deviation < STEADY || self.block_deviation < LARGEST_OF_NOISE.sqrt() * independent;
        self.is_flat() || (quiet && self.deviation < LOUDEST)
    }
}

/// Mine is of one tone, and the expected picture is not.
#[derive(Serialize)]
struct Flat {
    /// `[0, 1]`.
    #[serde(serialize_with = "digits::<3, _>")]
    luma: f64,
    alpha: bool,
    /// The standard deviation of the noise around the tone, in codes of 255.
    #[serde(serialize_with = "digits::<1, _>")]
    deviation: f64,
}

/// The expected picture is of one tone but for noise, and mine is not: standard deviations in codes of 255.
#[derive(Serialize)]
struct ExpectedEven {
    #[serde(serialize_with = "digits::<1, _>")]
    mine: f64,
    #[serde(serialize_with = "digits::<1, _>")]
    expected: f64,
}

impl Kind for Flat {
    const NAME: &'static str = "flat";
    const WEIGHT: Weight = Weight::AnotherPicture;

    fn sentence(&self) -> String {
        let Self { luma, alpha, deviation } = *self;
        let tone = match luma {
            _ if deviation >= 0.6 => format!(
                "Your picture is uniform apart from noise (standard deviation {deviation:.1} of 255); the expected \
                 one has content."
            ),
            ..0.01 => {
                "Your picture is black: nothing was rendered, or light, camera or material numbers are zero.".to_owned()
            }
            ..=0.99 => "Your picture is of one tone: every ray gets the same colour.".to_owned(),
            _ => "Your picture is white everywhere: the values are far too large, or the file was written in other \
                 units."
                .to_owned(),
        };
        let alpha =
            if alpha { " The file has an alpha channel, which is ignored: write a file without one." } else { "" };
        format!("{tone}{alpha}")
    }
}

impl Kind for ExpectedEven {
    const NAME: &'static str = "expected_even";
    const WEIGHT: Weight = Weight::AnotherPicture;

    fn sentence(&self) -> String {
        let Self { mine, expected } = self;
        format!(
            "The expected picture is uniform; yours has content: its tones deviate by {mine:.1} of 255, the expected \
             ones by {expected:.1}."
        )
    }
}

/// The finding if only one of the pictures shows nothing but a tone.
pub(super) fn found([mine, expected]: [Evenness; 2], alpha: bool) -> Option<Finding> {
    let deviation = |evenness: Evenness| 255.0 * evenness.deviation;
    match [mine.is_even(), expected.is_even()] {
        [true, false] => Some(Flat { luma: mine.luma, alpha, deviation: deviation(mine) }.into()),
        [false, true] => Some(ExpectedEven { mine: deviation(mine), expected: deviation(expected) }.into()),
        _ => None,
    }
}

/// The means of the whole blocks; of all pixels if there is no whole block.
fn block_means(luma: &Plane) -> Vec<f64> {
    let means = luma.block_means(BLOCK);
    if means.is_empty() { luma.block_means(1) } else { means }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    #[test]
    fn noise_is_even_and_a_gradient_or_a_patch_is_not() {
        let mut state = 1u32;
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32 - 0.5
        };
        let noisy = Raster::from_function(160, 120, |_, _| Vec3::splat(0.5 + 0.2 * noise()));
        assert!(Evenness::of(&noisy).is_even() && !Evenness::of(&noisy).is_flat());
        let gradient = Raster::from_function(160, 120, |x, _| Vec3::splat(0.5 + 0.0005 * x as f32));
        let mut shaped = |x: usize, y: usize| {
            let patch = if (40..72).contains(&x) && (40..72).contains(&y) { 0.1 } else { 0.0 };
            Vec3::splat(0.5 + patch + 0.1 * noise())
        };
        let shaped = Raster::from_function(160, 120, &mut shaped);
        for picture in [gradient, shaped] {
            assert!(!Evenness::of(&picture).is_even(), "{:?}", Evenness::of(&picture));
        }
    }
}
