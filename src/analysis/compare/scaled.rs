//! Pictures of another field of view.
//!
//! Of a camera that stands and looks the same, another field of view scales the picture about its centre:
//!
//! ```text
//!   factor = tan(half the expected angle) / tan(half mine)      mine shows at c + factor (p - c)
//!                                                               what the expected one shows at p
//! ```
//!
//! A wrong factor width/height scales across or down only, about the same centre.

use super::Finding;
use super::structure::{self, DECIDING_SIDE, Match};
use crate::envmap::ImageOperation;
use crate::math::Vec3;
use crate::picture::Raster;

/// Long side of the pictures that are searched.
const SIDE: usize = 128;
/// The largest factor; its inverse is the smallest.
const LARGEST: f64 = 2.6;
/// Steps of the search, coarse and fine.
const STEPS: [f64; 2] = [1.02, 1.004];
/// The correlation that a scaled picture must have, and by how much more than as it is.
const DECISIVE: (f64, f64) = (0.7, 0.15);
/// By how much more width or height alone must correlate than both together.
const DECISIVE_EXTENT: f64 = 0.03;

/// What is scaled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Extent {
    Both,
    Width,
    Height,
}

/// A factor, and the correlation under it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    pub extent: Extent,
    pub factor: f64,
    pub correlation: f64,
}

impl Scale {
    /// The finding in pictures of this width to height.
    pub fn finding(self, aspect: f64) -> Finding {
        let Self { extent, factor, correlation } = self;
        match extent {
            Extent::Both => Finding::Scaled { factor, correlation },
            _ => Finding::Stretched { horizontally: extent == Extent::Width, factor, aspect, correlation },
        }
    }
}

/// The factor by which mine shows the same things larger, if that explains the difference. Width or height alone are
/// tried of pictures of the same proportions.
pub(super) fn found(mine_codes: &Raster, expected_codes: &Raster, as_it_is: &Match) -> Option<Scale> {
    let size = structure::thumbnail_size(expected_codes, DECIDING_SIDE);
    let small = |raster: &Raster| structure::thumbnail(raster, ImageOperation::None, size);
    let (mine, expected) = (small(mine_codes), small(expected_codes));
    let size = structure::thumbnail_size(expected_codes, SIDE);
    let tried = |extent: Extent, factor: f64| Scale {
        extent,
        factor,
        correlation: correlation(&mine, &expected, factors(extent, factor), size),
    };
    let sides = |raster: &Raster| [raster.width(), raster.height()];
    let alike = structure::same_proportions(sides(mine_codes), sides(expected_codes));
    let extents = if alike { &[Extent::Both, Extent::Width, Extent::Height][..] } else { &[Extent::Both] };
    let best = extents
        .iter()
        .map(|&extent| best_factor(|factor| tried(extent, factor)))
        .reduce(|best, other| if other.correlation > best.correlation + DECISIVE_EXTENT { other } else { best })?;
    let moved = !(1.0 / 1.03..1.03).contains(&best.factor);
    let decisive = best.correlation >= DECISIVE.0 && best.correlation >= as_it_is.correlation + DECISIVE.1;
    (moved && decisive).then_some(best)
}

/// The factor under which the pictures correlate best: coarsely, and then finely around it.
fn best_factor(tried: impl Fn(f64) -> Scale) -> Scale {
    let mut factor = 1.0 / LARGEST;
    let mut best = tried(factor);
    while factor <= LARGEST {
        best = better(best, tried(factor));
        factor *= STEPS[0];
    }
    for step in [1.0 / STEPS[1], STEPS[1]] {
        let mut factor = best.factor;
        for _ in 0..4 {
            factor *= step;
            best = better(best, tried(factor));
        }
    }
    best
}

fn better(best: Scale, other: Scale) -> Scale {
    if other.correlation > best.correlation { other } else { best }
}

/// Across and down.
fn factors(extent: Extent, factor: f64) -> [f64; 2] {
    match extent {
        Extent::Both => [factor, factor],
        Extent::Width => [factor, 1.0],
        Extent::Height => [1.0, factor],
    }
}

/// The correlation of the detail where both pictures show the same angle.
fn correlation(mine: &Raster, expected: &Raster, factors: [f64; 2], size: [usize; 2]) -> f64 {
    let detail = |raster: &Raster, shares: [f64; 2]| structure::detail(&middle(raster, shares, size));
    let (mine_shares, expected_shares) =
        (factors.map(|factor| factor.min(1.0)), factors.map(|factor| (1.0 / factor).min(1.0)));
    structure::correlation(&detail(mine, mine_shares), &detail(expected, expected_shares), [0, 0])
}

/// The middle of a picture, these shares of its sides, in a size: interpolated.
fn middle(raster: &Raster, shares: [f64; 2], [width, height]: [usize; 2]) -> Raster {
    let place = |share: f64, index: usize, count: usize, length: usize| {
        let centred = ((index as f64 + 0.5) / count as f64 - 0.5) * share + 0.5;
        let place = (centred * length as f64 - 0.5).clamp(0.0, (length - 1) as f64);
        let first = (place as usize).min(length.saturating_sub(2));
        (first, (first + 1).min(length - 1), (place - first as f64) as f32)
    };
    Raster::from_function(width, height, |x, y| {
        let (left, right, h) = place(shares[0], x, width, raster.width());
        let (top, bottom, v) = place(shares[1], y, height, raster.height());
        let line = |row: usize| -> Vec3 { raster.pixel(left, row) * (1.0 - h) + raster.pixel(right, row) * h };
        line(top) * (1.0 - v) + line(bottom) * v
    })
}
