//! The cost of one border as the continuation of another: all pairs of 24 borders, in both directions.
//!
//! For every Haar coefficient the difference d of the two borders is compared with the change s from row to row that
//! both pictures show inside: the cost is `ln(1 + (d/s)^2 / 3)` summed over the colours inside the logarithm, the
//! negative logarithm of a distribution with heavy tails. A lamp on one side of a seam, or one face with another
//! exposure, then counts as one outlier and not as a thousand. `s^2` is the product of the two sides' own changes, so
//! that the sums of all arrangements are comparable: every side is used once.

use super::super::thresholds::noise::{BLOCK_ROUNDED, FINER_FILES, RESAMPLED, ROUNDED};
use super::agreement::Correlation;
use super::border::ImageBorders;
use super::display::Display;
use super::edge::{Border, Side};
use super::signal::{Colour, Signal, band_of};
use crate::envmap::Face;
use crate::math::functions::logarithm;
use crate::parallel;

/// Coarse coefficients, each a separate unit.
const COARSE: usize = 16;
/// Blocks along the border, in each of which the finer bands are taken together.
const BLOCKS: usize = 16;
/// Units of the slope.
const SLOPES: usize = 16;
/// Costs of every pair of borders, by which arrangements are compared.
pub const UNITS: usize = COARSE + BLOCKS + SLOPES;

/// The costs of one pair.
pub type Units = [f32; UNITS];

/// All pairs of borders.
#[derive(Debug, Clone)]
pub struct PairCosts {
    units: Vec<Units>,
    totals: Vec<f64>,
    /// How the patterns along every pair go together: see [`super::agreement`].
    correlations: Vec<Correlation>,
}

/// A side of one of the six images, 0 to 23.
pub fn border_index(image: Face, side: Side) -> usize {
    4 * image.index() + side.index()
}

impl PairCosts {
    pub fn new(images: &[ImageBorders; 6]) -> Self {
        let length = common_length(images);
        let texels = images.iter().map(|image| image.texels).min().unwrap_or(1);
        let signals = |reversed: bool| -> Vec<Signal> {
            let sides = images.iter().flat_map(|image| Side::ALL.map(|side| (image, side)));
            sides.map(|(image, side)| Signal::new(image, side, reversed, length)).collect()
        };
        let (forwards, backwards) = (signals(false), signals(true));
        let floors = Floors::new(length, texels, images[0].display);
        let mut units = vec![[0.0; UNITS]; 24 * 24 * 2];
        let pairs: Vec<(usize, usize)> = (0..24).flat_map(|one| (one..24).map(move |other| (one, other))).collect();
        let cost = |&(one, other): &(usize, usize)| {
            [&forwards, &backwards].map(|others| pair(&forwards[one], &others[other], &floors))
        };
        let costs: Vec<[Units; 2]> = parallel::map(&pairs, cost);
        for ((one, other), costs) in pairs.into_iter().zip(costs) {
            for (reversed, cost) in [false, true].into_iter().zip(costs) {
                units[index(one, other, reversed)] = cost;
                units[index(other, one, reversed)] = cost;
            }
        }
        let mut correlations = vec![Correlation::default(); 24 * 24 * 2];
        for (one, other) in (0..24).flat_map(|one| (0..24).map(move |other| (one, other))) {
            for reversed in [false, true] {
                correlations[index(one, other, reversed)] =
                    forwards[one].pattern.correlation(&forwards[other].pattern, reversed);
            }
        }
        let total = |units: &Units| units.iter().map(|&unit| f64::from(unit)).sum();
        Self { totals: units.iter().map(total).collect(), units, correlations }
    }

    /// The costs of the first border continuing the second.
    pub fn units(&self, images: [Face; 2], borders: [Border; 2]) -> &Units {
        &self.units[Self::index(images, borders)]
    }

    /// How the patterns along the two borders go together.
    pub fn correlation(&self, images: [Face; 2], borders: [Border; 2]) -> Correlation {
        self.correlations[Self::index(images, borders)]
    }

    pub fn total(&self, images: [Face; 2], borders: [Border; 2]) -> f64 {
        self.totals[Self::index(images, borders)]
    }

    /// The total of two borders by their numbers.
    pub fn total_of(&self, one: usize, other: usize, reversed: bool) -> f64 {
        self.totals[index(one, other, reversed)]
    }

    /// The same, but the borders of an image cost the same with all others: wherever it lies, it tells nothing.
    pub fn without(&self, image: Face) -> Self {
        let mut costs = self.clone();
        let mean = self.totals.iter().sum::<f64>() / self.totals.len() as f64;
        for (one, other) in (0..24).flat_map(|one| (0..24).map(move |other| (one, other))) {
            if [one, other].iter().any(|border| border / 4 == image.index()) {
                for index in [false, true].map(|reversed| index(one, other, reversed)) {
                    costs.totals[index] = mean;
                }
            }
        }
        costs
    }

    fn index(images: [Face; 2], borders: [Border; 2]) -> usize {
        let [one, other] = [0, 1].map(|end| border_index(images[end], borders[end].side));
        index(one, other, borders[0].reversed != borders[1].reversed)
    }
}

fn index(one: usize, other: usize, reversed: bool) -> usize {
    (one * 24 + other) * 2 + usize::from(reversed)
}

/// Samples along a border: a power of two that no image falls short of, and not more than is useful.
fn common_length(images: &[ImageBorders; 6]) -> usize {
    let texels = images.iter().map(|image| image.texels).min().unwrap_or(1).max(2);
    1 << texels.ilog2().min(8)
}

/// The least change, squared, that a band is credited with: rounding to whole codes, the blocks of JPEG files
/// (whose means are rounded block by block), and what resampling does at all scales. Files of more than 8 bits round a
/// tenth as much or less.
struct Floors(Vec<f32>);

impl Floors {
    fn new(length: usize, texels: usize, display: Display) -> Self {
        let factor = if display == Display::EightBit { 1.0 } else { FINER_FILES };
        let bands = band_of(length - 1) + 1;
        let floor = |band: usize| {
            let covered = texels as f32 / (1 << band.saturating_sub(1)) as f32;
            factor * (RESAMPLED + ROUNDED / covered + BLOCK_ROUNDED / (covered / 8.0).max(1.0))
        };
        Self((0..bands).map(floor).collect())
    }
}

/// The costs of the second border, walked as it is, continuing the first.
fn pair(one: &Signal, other: &Signal, floors: &Floors) -> Units {
    let scale = |one: &[Colour], other: &[Colour], factor: f32| -> Vec<Colour> {
        let bands = one.iter().zip(other).zip(&floors.0);
        let root = |((one, other), floor): ((&Colour, &Colour), &f32)| {
            std::array::from_fn(|channel| {
                let floor = factor * floor;
                1.0 / ((one[channel] + floor) * (other[channel] + floor)).sqrt()
            })
        };
        bands.map(root).collect()
    };
    let (change, bend) = (scale(&one.change, &other.change, 1.0), scale(&one.bend, &other.bend, 2.0));
    let length = one.border.len();
    let mut units = [0.0; UNITS];
    for coefficient in 0..length {
        let scale = &change[band_of(coefficient)];
        let (a, b) = (&one.border[coefficient], &other.border[coefficient]);
        let surprise: f32 = (0..3).map(|channel| (a[channel] - b[channel]).powi(2) * scale[channel]).sum();
        let cost = logarithm(1.0 + surprise / 3.0);
        if coefficient < COARSE {
            units[coefficient] = cost;
        } else {
            // The mean of a band in a block: a finer band counts no more than a coarser one.
            let band = 1 << coefficient.ilog2();
            let block = (coefficient - band) * BLOCKS / band;
            units[COARSE + block] += cost * BLOCKS as f32 / band as f32;
        }
    }
    for coefficient in 0..length.min(SLOPES) {
        let scale = &bend[band_of(coefficient)];
        let (a, b) = (&one.slope[coefficient], &other.slope[coefficient]);
        let surprise: f32 = (0..3).map(|channel| (a[channel] + b[channel]).powi(2) * scale[channel]).sum();
        units[COARSE + BLOCKS + coefficient] = logarithm(1.0 + surprise / 3.0);
    }
    units
}
impl PairCosts {
    /// The mean cost of a border with the borders of all other images, in both directions.
    pub fn mean_with_others(&self, image: Face, side: Side) -> f64 {
        let one = border_index(image, side);
        let others = (0..24).filter(|other| other / 4 != image.index());
        let costs = others.flat_map(|other| [false, true].map(|reversed| self.totals[index(one, other, reversed)]));
        costs.sum::<f64>() / 40.0
    }
}

#[cfg(test)]
impl PairCosts {
    /// Costs made up by a function of two border numbers and whether they run against each other.
    pub fn made_up(cost: impl Fn(usize, usize, bool) -> f64) -> Self {
        let mut totals = vec![0.0; 24 * 24 * 2];
        for (one, other) in (0..24).flat_map(|one| (one..24).map(move |other| (one, other))) {
            for reversed in [false, true] {
                let cost = cost(one, other, reversed);
                totals[index(one, other, reversed)] = cost;
                totals[index(other, one, reversed)] = cost;
            }
        }
        let units = totals.iter().map(|&total| [(total / UNITS as f64) as f32; UNITS]).collect();
        Self { units, totals, correlations: vec![Correlation::default(); 24 * 24 * 2] }
    }
}
