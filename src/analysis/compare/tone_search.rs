//! Which tone explains the difference: a small search over hypotheses, the exposure solved for each.

use super::tone::{Curve, Tone};
use crate::math::Vec3;
use crate::math::functions::{binary_logarithm, logarithm_f64};
use crate::metrics::display;

/// Codes of display that neither rounding nor clipping spoils.
const TRUSTED: std::ops::Range<f32> = 0.04..0.97;
/// A residual that rounding and lossy files leave, in codes of `[0, 1]`.
const FLOOR: f64 = 0.0015;
/// What a further finding must gain: it must make the residual smaller by this factor.
const PRICE: f64 = 1.4;
/// The smallest exposure difference that is named, in stops.
const SMALLEST_STOPS: f64 = 0.04;
/// Pixels that are looked at.
const SAMPLES: usize = 12_000;

/// A pixel of mine, linear as read, and the expected one, linear and as displayed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    pub mine: Vec3,
    pub mine_code: Vec3,
    pub expected: Vec3,
    pub expected_code: Vec3,
}

/// The tone that explains the pairs best for its number of findings.
pub(super) fn explained(pairs: &[Pair]) -> Tone {
    explanation(pairs).0
}

/// That tone, and what it costs: the mean difference that it leaves, times the price of its findings.
pub(super) fn explanation(pairs: &[Pair]) -> (Tone, f64) {
    let stride = pairs.len().div_ceil(SAMPLES).max(1);
    let pairs: Vec<Pair> = pairs.iter().step_by(stride).copied().collect();
    let mut best = (Tone::AS_EXPECTED, residual(&pairs, &Tone::AS_EXPECTED) + FLOOR);
    for (tone, findings) in hypotheses(&pairs) {
        let cost = (residual(&pairs, &tone) + FLOOR) * PRICE.powi(findings);
        if cost < best.1 {
            best = (tone, cost);
        }
    }
    best
}

/// All hypotheses, and how many findings each is.
fn hypotheses(pairs: &[Pair]) -> Vec<(Tone, i32)> {
    let mut all = Vec::new();
    for red_blue_swapped in [false, true] {
        let curves = [
            (Curve::AsExpected, 0),
            (Curve::NotEncoded, 1),
            (Curve::EncodedTwice, 1),
            (Curve::PlainGamma, 1),
            // Its exponent is fitted: it must explain more than the named ones.
            (fitted_power(pairs, red_blue_swapped), 2),
        ];
        for (curve, findings) in curves {
            let findings = findings + i32::from(red_blue_swapped);
            let plain = Tone { curve, exposure: 1.0, red_blue_swapped };
            all.push((plain, findings));
            let exposure = median_ratio(pairs, &plain);
            if binary_logarithm(f64::from(exposure)).abs() >= SMALLEST_STOPS {
                all.push((Tone { exposure, ..plain }, findings + 1));
            }
        }
    }
    all
}

/// The mean difference on display once the tone is undone, where mine is not clipped.
fn residual(pairs: &[Pair], tone: &Tone) -> f64 {
    let (mut sum, mut count) = (0.0, 0usize);
    for pair in pairs {
        let undone = display(tone.undone(pair.mine));
        for channel in 0..3 {
            if channel_of(pair, tone, channel) < 0.99 {
                sum += f64::from((undone[channel] - pair.expected_code[channel]).abs());
                count += 1;
            }
        }
    }
    sum / count.max(1) as f64
}

/// The code of mine that stands for a channel of the expected picture.
fn channel_of(pair: &Pair, tone: &Tone, channel: usize) -> f32 {
    pair.mine_code[if tone.red_blue_swapped { 2 - channel } else { channel }]
}

/// The channels that are trusted in both pictures: the light of mine with the tone undone, and that expected.
fn trusted(pairs: &[Pair], tone: &Tone) -> Vec<(f32, f32)> {
    let mut lights = Vec::new();
    for pair in pairs {
        let undone = tone.undone(pair.mine);
        for channel in 0..3 {
            let codes = [channel_of(pair, tone, channel), pair.expected_code[channel]];
            if codes.iter().all(|code| TRUSTED.contains(code)) {
                lights.push((undone[channel], pair.expected[channel]));
            }
        }
    }
    lights
}

/// The exposure in closed form: the median ratio of the lights; 1 if there is nothing to go by.
fn median_ratio(pairs: &[Pair], tone: &Tone) -> f32 {
    let mut ratios: Vec<f32> =
        trusted(pairs, tone).into_iter().filter(|lights| lights.1 > 0.0).map(|(mine, light)| mine / light).collect();
    if ratios.len() * 50 < pairs.len() {
        return 1.0;
    }
    let ratio = median(&mut ratios);
    if ratio > 0.0 && ratio.is_finite() { ratio } else { 1.0 }
}

fn median(values: &mut [f32]) -> f32 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f32::total_cmp).1
}

/// The power that takes the expected light to mine: the slope of a line through the logarithms, fitted again without
/// the half that lies farthest from it.
fn fitted_power(pairs: &[Pair], red_blue_swapped: bool) -> Curve {
    let tone = Tone { red_blue_swapped, ..Tone::AS_EXPECTED };
    let lights = trusted(pairs, &tone).into_iter().filter(|lights| lights.0 > 0.0 && lights.1 > 0.0);
    let logarithm = |light: f32| logarithm_f64(f64::from(light));
    let mut points: Vec<(f64, f64)> = lights.map(|(mine, light)| (logarithm(light), logarithm(mine))).collect();
    for _ in 0..4 {
        let Some((slope, offset)) = line(&points) else { return Curve::AsExpected };
        let distance = |point: &(f64, f64)| (point.1 - slope * point.0 - offset).abs();
        let mut distances: Vec<f32> = points.iter().map(|point| distance(point) as f32).collect();
        let near = f64::from(median(&mut distances)) * 3.0 + 1e-6;
        points.retain(|point| distance(point) <= near);
    }
    match line(&points) {
        Some((slope, _)) if (0.2..5.0).contains(&slope) => {
            // Rounded to what can be told apart, so that it reads well.
            Curve::Power((slope * 100.0).round() as f32 / 100.0)
        }
        _ => Curve::AsExpected,
    }
}

/// Slope and offset of the line of least squares; none if there are too few points, or they lie in one place.
fn line(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let count = points.len() as f64;
    if points.len() < 50 {
        return None;
    }
    let mean = |value: fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let spread: f64 = points.iter().map(|point| (point.0 - x) * (point.0 - x)).sum();
    let product: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    (spread > 0.05 * count).then(|| (product / spread, y - product / spread * x))
}
