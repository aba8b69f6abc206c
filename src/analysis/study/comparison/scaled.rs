//! Pictures of another field of view.
//!
//! Of a camera that stands and looks the same, another field of view scales the picture about its centre:
//!
//! ```text
//!   factor = tan(half the expected angle) / tan(half mine)      mine shows at c + factor (p - c)
//!                                                               what the expected one shows at p
//! ```

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

/// A factor, and the correlation under it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    pub factor: f64,
    pub correlation: f64,
}

/// The factor by which mine shows the same things larger, if that explains the difference.
pub(super) fn found(mine_codes: &Raster, expected_codes: &Raster, as_it_is: &Match) -> Option<Scale> {
    let size = structure::thumbnail_size(expected_codes, DECIDING_SIDE);
    let small = |raster: &Raster| structure::thumbnail(raster, ImageOperation::None, size);
    let (mine, expected) = (small(mine_codes), small(expected_codes));
    let size = structure::thumbnail_size(expected_codes, SIDE);
    let tried = |factor: f64| Scale { factor, correlation: correlation(&mine, &expected, factor, size) };
    let mut best = Scale { factor: 1.0, correlation: f64::NEG_INFINITY };
    let mut factor = 1.0 / LARGEST;
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
    let moved = !(1.0 / 1.03..1.03).contains(&best.factor);
    let decisive = best.correlation >= DECISIVE.0 && best.correlation >= as_it_is.correlation + DECISIVE.1;
    (moved && decisive).then_some(best)
}

fn better(best: Scale, other: Scale) -> Scale {
    if other.correlation > best.correlation { other } else { best }
}

/// The correlation of the detail where both pictures show the same angle.
fn correlation(mine: &Raster, expected: &Raster, factor: f64, size: [usize; 2]) -> f64 {
    let (mine_share, expected_share) = if factor < 1.0 { (factor, 1.0) } else { (1.0, 1.0 / factor) };
    let detail = |raster: &Raster, share: f64| structure::detail(&middle(raster, share, size));
    structure::correlation(&detail(mine, mine_share), &detail(expected, expected_share), [0, 0])
}

/// The middle of a picture, this share of its sides, in a size: interpolated.
fn middle(raster: &Raster, share: f64, [width, height]: [usize; 2]) -> Raster {
    let place = |index: usize, count: usize, length: usize| {
        let centred = ((index as f64 + 0.5) / count as f64 - 0.5) * share + 0.5;
        let place = (centred * length as f64 - 0.5).clamp(0.0, (length - 1) as f64);
        let first = (place as usize).min(length.saturating_sub(2));
        (first, (first + 1).min(length - 1), (place - first as f64) as f32)
    };
    Raster::from_function(width, height, |x, y| {
        let (left, right, h) = place(x, width, raster.width());
        let (top, bottom, v) = place(y, height, raster.height());
        let line = |row: usize| -> Vec3 { raster.pixel(left, row) * (1.0 - h) + raster.pixel(right, row) * h };
        line(top) * (1.0 - v) + line(bottom) * v
    })
}
