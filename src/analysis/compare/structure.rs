//! The orientation of a picture and its rough shift, from its content and independent of its tones.
//!
//! Both pictures are made small, their lumas freed from slow changes, and compared by normalised cross-correlation
//! under all orientations and shifts. Correlation is blind to exposure and hardly affected by gamma, so this step comes
//! first.

use super::operations::{OPERATIONS, exchanges_sides, placed};
use super::resized::resized;
use super::tone::decoded;
use super::tone_search::Pair;
use crate::colour::luminance;
use crate::envmap::ImageOperation;
use crate::math::Vec3;
use crate::metrics::{Plane, gaussian};
use crate::picture::Raster;

/// Long side of the pictures that are searched, and of those that decide.
const SEARCHED_SIDE: usize = 64;
pub(super) const DECIDING_SIDE: usize = 256;
/// Shifts searched, in pixels of the small pictures: a tenth of the picture.
const REACH: i32 = 6;
/// Detail that deviates by less, a code and a half, may be what a lossy file left.
const SMOOTH: f64 = 0.006;

/// The best match under one orientation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Match {
    /// The operation that gives mine the orientation of the expected one.
    pub operation: ImageOperation,
    /// Normalised cross-correlation, `[-1, 1]`; 0 if one of them shows nothing.
    pub correlation: f64,
    /// Mine shows at `p + shift` what the expected one shows at `p`: in pixels of the deciding size.
    pub shift: [i32; 2],
}

/// A pair of pictures of display codes, and the matches of mine under every orientation that its proportions allow.
pub(super) fn matches(mine: &Raster, expected: &Raster) -> Vec<Match> {
    let operations = plausible(mine, expected);
    let deciding = thumbnail_size(expected, DECIDING_SIDE);
    let searched = thumbnail_size(expected, SEARCHED_SIDE);
    let detail = |raster: &Raster, operation, size| detail(&thumbnail(raster, operation, size));
    let (wide, small) =
        (detail(expected, ImageOperation::None, deciding), detail(expected, ImageOperation::None, searched));
    let ratio = |axis: usize| deciding[axis] as f32 / searched[axis] as f32;
    operations
        .into_iter()
        .map(|operation| {
            let coarse = best_shift(&detail(mine, operation, searched), &small, [0, 0], REACH).1;
            let start = [0, 1].map(|axis| (coarse[axis] as f32 * ratio(axis)).round() as i32);
            let (correlation, shift) = best_shift(&detail(mine, operation, deciding), &wide, start, 3);
            Match { operation, correlation, shift }
        })
        .collect()
}

/// The match to believe: as it is, unless another orientation fits decisively better.
pub(super) fn decided(matches: &[Match]) -> Match {
    let as_it_is = matches[0];
    let mut best = as_it_is;
    for candidate in &matches[1..] {
        if candidate.correlation > best.correlation + 1e-3 {
            best = *candidate;
        }
    }
    let decisive = best.correlation > as_it_is.correlation + 0.05
        && 1.0 - as_it_is.correlation > 2.0 * (1.0 - best.correlation) + 0.01;
    if decisive { best } else { as_it_is }
}

/// True if one of the pictures has so little detail that what a lossy file leaves may rule it.
pub(super) fn is_smooth(mine: &Raster, expected: &Raster) -> bool {
    let deviation = |raster: &Raster| {
        let detail = detail(&thumbnail(raster, ImageOperation::None, thumbnail_size(raster, DECIDING_SIDE)));
        let squares = detail.values().iter().map(|&value| f64::from(value) * f64::from(value));
        (squares.sum::<f64>() / detail.values().len() as f64).sqrt()
    };
    deviation(mine).min(deviation(expected)) < SMOOTH
}

/// Pixels of both made small, their long side at most `side`; mine in the orientation of the expected one and roughly shifted back.
pub(super) fn pairs(mine_codes: &Raster, expected_codes: &Raster, matched: &Match, side: usize) -> Vec<Pair> {
    let size = thumbnail_size(expected_codes, side);
    let mine = thumbnail(mine_codes, matched.operation, size);
    let expected = thumbnail(expected_codes, ImageOperation::None, size);
    let linear = |code: Vec3| Vec3::from_array(code.to_array().map(decoded));
    let mut pairs = Vec::with_capacity(size[0] * size[1]);
    for (x, y) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))) {
        let there = [x as i32 + matched.shift[0], y as i32 + matched.shift[1]];
        if there[0] < 0 || there[1] < 0 || there[0] >= size[0] as i32 || there[1] >= size[1] as i32 {
            continue;
        }
        let mine_code = mine.pixel(there[0] as usize, there[1] as usize);
        let expected_code = expected.pixel(x, y);
        pairs.push(Pair { mine: linear(mine_code), mine_code, expected: linear(expected_code), expected_code });
    }
    pairs
}

/// The orientations that give mine the proportions of the expected picture; without quarter turns if none does.
pub(super) fn plausible(mine: &Raster, expected: &Raster) -> Vec<ImageOperation> {
    let fits = |operation: &ImageOperation| {
        let (width, height) =
            if exchanges_sides(*operation) { (mine.height(), mine.width()) } else { (mine.width(), mine.height()) };
        same_proportions([width, height], [expected.width(), expected.height()])
    };
    let fitting: Vec<ImageOperation> = OPERATIONS.into_iter().filter(fits).collect();
    let straight = OPERATIONS.into_iter().filter(|&operation| !exchanges_sides(operation)).collect();
    match fitting.first() {
        None => straight,
        Some(ImageOperation::None) => fitting,
        // Only turned it has the proportions: the straight ones stay as what a turn must beat.
        Some(_) => [ImageOperation::None].into_iter().chain(fitting).collect(),
    }
}

/// True if width to height agree within 2 %.
pub(super) fn same_proportions([width, height]: [usize; 2], [other_width, other_height]: [usize; 2]) -> bool {
    let (a, b) = ((width * other_height) as f64, (other_width * height) as f64);
    (a - b).abs() <= 0.02 * a.max(b)
}

/// Width and height of a picture made small, its long side at most `side`.
pub(super) fn thumbnail_size(raster: &Raster, side: usize) -> [usize; 2] {
    let long = raster.width().max(raster.height());
    let scaled = |length: usize| if long <= side { length } else { (length * side / long).max(1) };
    [scaled(raster.width()), scaled(raster.height())]
}

/// A picture after an operation and made small.
pub(super) fn thumbnail(raster: &Raster, operation: ImageOperation, [width, height]: [usize; 2]) -> Raster {
    if exchanges_sides(operation) {
        return placed(&resized(raster, height, width), operation);
    }
    placed(&resized(raster, width, height), operation)
}

/// The luma without slow changes and without the finest noise.
pub(super) fn detail(codes: &Raster) -> Plane {
    let luma = Plane::of_raster(codes, luminance);
    let (fine, wide) = (gaussian(0.7, 2), gaussian(luma.width().max(luma.height()) as f64 / 16.0, SEARCHED_SIDE / 8));
    let smooth = luma.filtered(&fine, &fine);
    let background = smooth.filtered(&wide, &wide);
    smooth.zip(&background, |value, slow| value - slow)
}

/// The shift within `reach` of `start` under which the planes correlate best; along the short side of a strip within a third
/// of it, so that the planes always overlap.
fn best_shift(mine: &Plane, expected: &Plane, start: [i32; 2], reach: i32) -> (f64, [i32; 2]) {
    let offsets = |length: usize| -reach.min(length as i32 / 3)..=reach.min(length as i32 / 3);
    let (columns, rows) = (offsets(expected.width()), offsets(expected.height()));
    let mut best = (correlation(mine, expected, start), start);
    for (y, x) in rows.flat_map(|y| columns.clone().map(move |x| (y, x))) {
        let shift = [start[0] + x, start[1] + y];
        let found = correlation(mine, expected, shift);
        if found > best.0 + 1e-6 {
            best = (found, shift);
        }
    }
    best
}

/// Normalised cross-correlation of `mine(p + shift)` and `expected(p)` where both are; 0 if one is nothing there.
pub(super) fn correlation(mine: &Plane, expected: &Plane, [x, y]: [i32; 2]) -> f64 {
    let range = |shift: i32, length: usize| {
        let length = length as i32;
        (-shift).clamp(0, length) as usize..(length - shift).clamp(0, length) as usize
    };
    let (columns, rows) = (range(x, expected.width()), range(y, expected.height()));
    if columns.is_empty() || rows.is_empty() {
        return 0.0;
    }
    let width = expected.width();
    let mut sums = [0.0f64; 3];
    for row in rows {
        let there = ((row as i32 + y) as usize * width) as i32 + x;
        let a = &mine.values()[(there + columns.start as i32) as usize..(there + columns.end as i32) as usize];
        let b = &expected.values()[row * width + columns.start..row * width + columns.end];
        // One row in single precision is exact enough; rows add up in double.
        let mut line = [0.0f32; 3];
        for (&a, &b) in a.iter().zip(b) {
            line[0] += a * b;
            line[1] += a * a;
            line[2] += b * b;
        }
        for (sum, part) in sums.iter_mut().zip(line) {
            *sum += f64::from(part);
        }
    }
    let energy = (sums[1] * sums[2]).sqrt();
    if energy > 1e-9 { sums[0] / energy } else { 0.0 }
}
