//! The orientation of a picture without detail: a gradient, a furnace, directions as colours. Correlation of detail
//! would only see compression artefacts, so the colours themselves are compared, under every orientation with the tone
//! that explains it best.

use super::structure::{self, Match};
use super::tone::Tone;
use super::tone_search::{self, Pair};
use crate::envmap::ImageOperation;
use crate::metrics::display;
use crate::picture::Raster;

/// Long side of the pictures that are compared.
const SIDE: usize = 64;
/// Pictures that differ less, in codes of `[0, 1]`, are near: 36 dB. JPEG of quality 80 and more leaves less.
const NEAR: f64 = 0.016;
/// With the tone undone, this much may be left: in codes, and as a share of the variance of the colours.
const LEFT: (f64, f64) = (0.04, 0.04);
/// What an orientation costs against the one as it is: the residual must be smaller by this factor.
const PRICE: f64 = 1.4;

/// The orientation whose colours fit, if any does; the shift is none.
pub(super) fn matched(mine_codes: &Raster, expected_codes: &Raster) -> Option<Match> {
    let as_it_is = Match { operation: ImageOperation::None, correlation: 1.0, shift: [0, 0] };
    if residual(&pairs(mine_codes, expected_codes, &as_it_is), &Tone::AS_EXPECTED)?.0 <= NEAR {
        return Some(as_it_is);
    }
    let mut best: Option<(f64, Match)> = None;
    for operation in structure::plausible(mine_codes, expected_codes) {
        let candidate = Match { operation, ..as_it_is };
        let pairs = pairs(mine_codes, expected_codes, &candidate);
        let (tone, cost) = tone_search::explanation(&pairs);
        let cost = if operation == ImageOperation::None { cost } else { cost * PRICE };
        let Some((deviation, spread)) = residual(&pairs, &tone) else { continue };
        let unexplained = if spread > 0.0 { (deviation / spread) * (deviation / spread) } else { 1.0 };
        let fits = deviation <= LEFT.0 && unexplained <= LEFT.1;
        if fits && best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, Match { correlation: (1.0 - unexplained).sqrt(), ..candidate }));
        }
    }
    best.map(|(_, matched)| matched)
}

fn pairs(mine_codes: &Raster, expected_codes: &Raster, matched: &Match) -> Vec<Pair> {
    structure::pairs(mine_codes, expected_codes, matched, SIDE)
}

/// The root mean square of what a tone leaves, and the standard deviation of the expected colours, where mine is not
/// clipped. None if too little of it is not.
fn residual(pairs: &[Pair], tone: &Tone) -> Option<(f64, f64)> {
    let (mut squares, mut sums, mut own, mut counts) = (0.0, [0.0; 3], [0.0; 3], [0usize; 3]);
    for pair in pairs {
        let undone = display(tone.undone(pair.mine));
        for channel in 0..3 {
            let source = if tone.red_blue_swapped { 2 - channel } else { channel };
            if pair.mine_code[source] >= 0.99 {
                continue;
            }
            let (expected, error) = (f64::from(pair.expected_code[channel]), undone[channel]);
            let error = f64::from(error) - expected;
            squares += error * error;
            sums[channel] += expected;
            own[channel] += expected * expected;
            counts[channel] += 1;
        }
    }
    let count: usize = counts.iter().sum();
    if count * 5 < pairs.len() * 3 {
        return None;
    }
    let variance: f64 =
        (0..3).map(|channel| own[channel] - sums[channel] * sums[channel] / counts[channel].max(1) as f64).sum();
    Some(((squares / count as f64).sqrt(), (variance.max(0.0) / count as f64).sqrt()))
}
