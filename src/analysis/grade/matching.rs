//! Which images, in which orientation, a shot may show: each of 6 x 8 candidates fitted by a tone curve, and the best
//! compared with the rest.
//!
//! For the best prediction p of the shot s and another one q, with d = p - q and the noise n of the best fit around
//! each cell, the likelihood ratio is `D = sum((s - q)^2 - (s - p)^2)`. If p is right, D is `sum(d^2)` with the
//! deviation `2 sqrt(sum(n^2 d^2))`; if q is, `-sum(d^2)`. The pixels decide if D is many deviations above 0 and close
//! to its predicted value.

use super::placement::{Placement, source_cells};
use super::thresholds::decisive::{DEVIATIONS, NEARNESS, SURE_NOISE};
use super::tone::Levels;
use crate::envmap::{Face, Orientation, VOrigin};

/// An image in cells.
pub(super) struct ImageLevels(pub [Levels; 6]);

/// One explanation of a shot.
pub(super) struct Candidate {
    pub placement: Placement,
    /// What the shot would be, three values a cell.
    pub fitted: Vec<f32>,
    /// Mean square of what is left.
    pub error: f64,
}

/// How a face of the lookup stands on the screen.
#[derive(Clone, Copy)]
pub(super) struct Screen {
    pub orientation: Orientation,
    pub v_origin: VOrigin,
}

/// All explanations of a shot of `side` x `side` cells, the expected image first, orientations in the order of
/// [`Orientation::ALL`].
pub(super) fn candidates(
    images: &ImageLevels,
    expected: Face,
    shot: &[f32],
    screen: Screen,
    side: usize,
) -> Vec<Candidate> {
    let mut order = Face::ALL.to_vec();
    order.sort_by_key(|&image| image != expected);
    let mut candidates = Vec::with_capacity(48);
    let sources =
        Orientation::ALL.map(|orientation| source_cells(orientation.after(screen.orientation), screen.v_origin, side));
    for image in order {
        for (orientation, source) in Orientation::ALL.into_iter().zip(&sources) {
            let fitted = images.0[image.index()].fitted(source, shot);
            let error = mean_square(&fitted, shot);
            candidates.push(Candidate { placement: Placement { image, orientation }, fitted, error });
        }
    }
    candidates
}

/// Mean of the squared differences.
pub(super) fn mean_square(one: &[f32], other: &[f32]) -> f64 {
    let sum: f64 = one.iter().zip(other).map(|(a, b)| f64::from((a - b) * (a - b))).sum();
    sum / one.len() as f64
}

/// Mean square around the mean of all values.
pub(super) fn variance(values: &[f32]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().map(|&value| f64::from(value)).sum::<f64>() / count;
    values.iter().map(|&value| (f64::from(value) - mean) * (f64::from(value) - mean)).sum::<f64>() / count
}

/// Mean square of each channel around its own mean: 0 for any plain colour. Three values a cell.
pub(super) fn relief(values: &[f32]) -> f64 {
    let channel = |channel: usize| variance(&values.iter().skip(channel).step_by(3).copied().collect::<Vec<f32>>());
    (0..3).map(channel).sum::<f64>() / 3.0
}

/// The first of the best.
pub(super) fn best(candidates: &[Candidate]) -> &Candidate {
    candidates.iter().min_by(|a, b| a.error.total_cmp(&b.error)).expect("there are candidates")
}

/// The best explanation and those that the pixels cannot distinguish from it, in the order of the candidates.
pub(super) fn possible(candidates: &[Candidate], shot: &[f32], side: usize) -> Vec<Placement> {
    let best = best(candidates);
    let noise = noise_around(&best.fitted, shot, side);
    let ties = candidates
        .iter()
        .filter(|other| other.placement == best.placement || !excluded(&best.fitted, &other.fitted, shot, &noise));
    ties.map(|candidate| candidate.placement).collect()
}

/// True if the shot is decisively more like `best` than like `other`.
fn excluded(best: &[f32], other: &[f32], shot: &[f32], noise: &[f64]) -> bool {
    lead(best, other, shot, noise).is_some_and(|(nearness, deviations)| nearness > NEARNESS && deviations > DEVIATIONS)
}

/// Where the shot lies between `other` (0) and `best` (1), and the deviations by which it is more like `best`. `None` if the
/// two are the same.
pub(super) fn lead(best: &[f32], other: &[f32], shot: &[f32], noise: &[f64]) -> Option<(f64, f64)> {
    let (mut gain, mut predicted, mut variance) = (0.0, 0.0, 0.0);
    for index in 0..shot.len() {
        let (p, q, s) = (f64::from(best[index]), f64::from(other[index]), f64::from(shot[index]));
        let squared = (p - q) * (p - q);
        gain += (s - q) * (s - q) - (s - p) * (s - p);
        predicted += squared;
        variance += noise[index] * squared;
    }
    (predicted > 0.0).then(|| ((gain / predicted + 1.0) / 2.0, gain / (2.0 * variance.sqrt())))
}

/// The mean square of the misfit in the 3 x 3 cells around each, by channel.
pub(super) fn noise_around(fitted: &[f32], shot: &[f32], side: usize) -> Vec<f64> {
    let squared: Vec<f64> = fitted.iter().zip(shot).map(|(a, b)| f64::from((a - b) * (a - b))).collect();
    let range = |index: usize| index.saturating_sub(1)..(index + 2).min(side);
    let mut noise = Vec::with_capacity(squared.len());
    for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
        for channel in 0..3 {
            let places = range(row).flat_map(|y| range(column).map(move |x| 3 * (y * side + x) + channel));
            let (mut sum, mut count) = (SURE_NOISE * SURE_NOISE, 0.0);
            for place in places {
                sum += squared[place];
                count += 1.0;
            }
            noise.push(sum / f64::max(count, 1.0) + SURE_NOISE * SURE_NOISE);
        }
    }
    noise
}
