//! The agreement of the patterns along two borders, and its evidence.
//!
//! The measure is the rank correlation r (Spearman, "The Proof and Measurement of Association between Two Things",
//! 1904) of the brightness along the two: neither the exposure nor a single lamp changes it. Neighbouring texels are
//! correlated, so n of them count as fewer independent ones, by Bartlett's formula ("Some Aspects of the
//! Time-Correlation Problem", 1935), n / (1 + 2 sum of r_a(k) r_b(k)) with the correlations of either row with itself k
//! texels on. The evidence is the logarithm of the likelihood that the correlation gains over none,
//! `-(n - 3) / 2 ln(1 - r^2)`: a smooth sky, which only grows brighter along its borders, gets nearly none.
//!
//! Two orientations of a border are compared by Fisher's test of two correlations ("On the Probable Error of a
//! Coefficient of Correlation Deduced from a Small Sample", 1921): the common part of two orientations is evidence for
//! neither, for instance in a border that is bright at both ends and dark in the middle.

use super::super::thresholds::agreement::{HIGHEST, LEAST_SPREAD, MOST, TREND};
use crate::math::functions::logarithm;

/// The ranks of the brightness along a border.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// Of mean 0 and of mean square 1; all 0 if the border is flat.
    ranks: Vec<f32>,
    /// The correlation of the row with itself, one texel further, two texels further, ...
    own: Vec<f32>,
}

impl Pattern {
    pub fn new(brightness: &[f32]) -> Self {
        let ranks = ranks(brightness);
        let count = ranks.len();
        let own = (1..=count / 2).map(|lag| product(&ranks[lag..], &ranks[..count - lag]) / count as f32).collect();
        Self { ranks, own }
    }

    /// How the other one, walked as it is or against its direction, goes with this one.
    pub fn correlation(&self, other: &Self, reversed: bool) -> Correlation {
        let count = self.ranks.len() as f32;
        let sum: f32 = if reversed {
            self.ranks.iter().zip(other.ranks.iter().rev()).map(|(a, b)| a * b).sum()
        } else {
            product(&self.ranks, &other.ranks)
        };
        let alike: f32 =
            self.own.iter().zip(&other.own).map_while(|(a, b)| (*a > 0.0 && *b > 0.0).then_some(a * b)).sum();
        Correlation { value: sum / count, independent: (count / (1.0 + 2.0 * alike) - TREND).max(0.0) }
    }
}

/// The rank correlation of two borders.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Correlation {
    /// From -1 to 1.
    value: f32,
    /// Independent texels, less what the mean, the scale and a trend take off.
    independent: f32,
}

impl Correlation {
    /// The evidence that the borders continue each other at all; negative if they run against each other.
    pub fn evidence(self) -> f32 {
        let value = self.value.clamp(-0.99, 0.99);
        let evidence = -0.5 * self.independent * logarithm(1.0 - value * value);
        evidence.min(MOST).copysign(value)
    }

    /// The evidence that these borders go together rather than the others; negative for the others.
    pub fn evidence_against(self, other: Self) -> f32 {
        if self.independent == 0.0 || other.independent == 0.0 {
            return 0.0;
        }
        let difference = self.fisher() - other.fisher();
        let variance = 1.0 / self.independent + 1.0 / other.independent;
        (0.5 * difference * difference / variance).min(MOST).copysign(difference)
    }

    /// Fisher's z, of variance 1 / `independent` at any correlation.
    fn fisher(self) -> f32 {
        let value = self.value.clamp(-HIGHEST, HIGHEST);
        0.5 * logarithm((1.0 + value) / (1.0 - value))
    }
}

fn product(one: &[f32], other: &[f32]) -> f32 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

/// Ranks, equal values sharing their mean rank, scaled to mean 0 and mean square 1.
fn ranks(values: &[f32]) -> Vec<f32> {
    let count = values.len();
    let mean = values.iter().sum::<f32>() / count as f32;
    let spread = (values.iter().map(|value| (value - mean) * (value - mean)).sum::<f32>() / count as f32).sqrt();
    if spread < LEAST_SPREAD {
        return vec![0.0; count];
    }
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
    let mut ranks = vec![0.0; count];
    for equal in order.chunk_by(|&a, &b| values[a] == values[b]) {
        let below = order.partition_point(|&index| values[index] < values[equal[0]]);
        let rank = below as f32 + (equal.len() as f32 - count as f32) / 2.0;
        for &index in equal {
            ranks[index] = rank;
        }
    }
    let scale = (product(&ranks, &ranks) / count as f32).sqrt();
    ranks.iter().map(|rank| rank / scale).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers that look random, each the mean of `width` of them.
    fn noise(seed: u64, width: usize) -> Vec<f32> {
        let value = |index: usize| {
            let state = (seed * 100_003 + index as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let state = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            ((state ^ (state >> 27)) % 1000) as f32 / 4.0
        };
        (0..64).map(|index| (index..index + width).map(value).sum::<f32>() / width as f32).collect()
    }

    #[test]
    fn the_same_pattern_tells_most_whatever_the_exposure() {
        let pattern = noise(1, 1);
        let darker: Vec<f32> = pattern.iter().map(|value| 0.7 * value + 3.0).collect();
        let mirrored: Vec<f32> = pattern.iter().rev().copied().collect();
        let pattern = Pattern::new(&pattern);
        assert_eq!(pattern.correlation(&Pattern::new(&darker), false).evidence(), MOST);
        assert_eq!(pattern.correlation(&Pattern::new(&mirrored), true).evidence(), MOST);
    }

    #[test]
    fn unlike_patterns_flat_and_smooth_ones_tell_nothing() {
        // Of unlike patterns the evidence is half a chi-square variable of one degree: 0.5 on average.
        for width in [1, 4] {
            let evidence = |seed: u64| {
                let [one, other] = [0, 1].map(|half| Pattern::new(&noise(2 * seed + half, width)));
                one.correlation(&other, false).evidence().abs()
            };
            let mean = (0..200).map(evidence).sum::<f32>() / 200.0;
            assert!((0.3..0.8).contains(&mean), "blurred by {width}: {mean}");
        }
        let smooth: Vec<f32> = (0..64).map(|index| index as f32).collect();
        assert!(Pattern::new(&smooth).correlation(&Pattern::new(&smooth), false).evidence() < 3.0);
        let flat = Pattern::new(&[7.0; 64]);
        assert_eq!(flat.correlation(&flat, false).evidence(), 0.0);
    }

    #[test]
    fn what_a_pattern_has_in_common_with_its_mirror_image_tells_nothing() {
        // Bright at both ends, and noise of its own in either picture.
        let bowl = |seed: u64| -> Vec<f32> {
            let noise = noise(seed, 1);
            (0..64).map(|index| (index as f32 - 31.5).powi(2) / 8.0 + 0.3 * noise[index]).collect()
        };
        let evidence = |seed: u64| {
            let [one, other] = [0, 1].map(|half| Pattern::new(&bowl(2 * seed + half)));
            one.correlation(&other, false).evidence_against(one.correlation(&other, true))
        };
        let most = (0..100).map(evidence).fold(0.0, |most: f32, evidence| most.max(evidence.abs()));
        assert!(most < 4.0, "{most}");
        let pattern = Pattern::new(&noise(1, 1));
        let (right, turned) = (pattern.correlation(&pattern, false), pattern.correlation(&pattern, true));
        assert_eq!((right.evidence_against(turned), turned.evidence_against(right)), (MOST, -MOST));
    }
}
