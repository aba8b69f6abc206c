//! Pictures of another field of view.
//!
//! With the same position and direction of the camera, another field of view scales the picture about its centre:
//!
//! ```text
//!   factor = tan(half the expected angle) / tan(half mine)      mine shows at c + factor (p - c)
//!                                                               what the expected one shows at p
//! ```
//!
//! A wrong factor width/height scales across or down only, about the same centre.

use serde::Serialize;

use super::finding::{Finding, Kind, Weight};
use super::structure::{self, DECIDING_SIDE};
use super::subject::Apart;
use crate::digits::digits;
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

/// Mine shows the same things `factor` times as large: the camera has another field of view.
#[derive(Serialize)]
struct Scaled {
    #[serde(serialize_with = "digits::<3, _>")]
    factor: f64,
    #[serde(serialize_with = "digits::<3, _>")]
    correlation: f64,
}

/// Mine shows the same things `factor` times as wide (`horizontally`) or as high: the factor width/height is wrong.
#[derive(Serialize)]
struct Stretched {
    horizontally: bool,
    #[serde(serialize_with = "digits::<3, _>")]
    factor: f64,
    /// Width over height of the expected picture.
    #[serde(serialize_with = "digits::<3, _>")]
    aspect: f64,
    #[serde(serialize_with = "digits::<3, _>")]
    correlation: f64,
}

impl Kind for Scaled {
    const NAME: &'static str = "scaled";
    const WEIGHT: Weight = Weight::AnotherPicture;

    fn sentence(&self) -> String {
        let Self { factor, correlation } = self;
        let view = if *factor > 1.0 { "narrower" } else { "wider" };
        format!(
            "Your picture shows the same things {factor:.2} times as large: your field of view is {view} (scaled back \
             about the centre, it correlates with the expected one by {correlation:.2}). Multiply the tangent of half \
             your angle by {factor:.2}, and check whether the angle is meant across the width or the height, in \
             degrees or radians."
        )
    }
}

impl Kind for Stretched {
    const NAME: &'static str = "stretched";
    const WEIGHT: Weight = Weight::AnotherPicture;

    fn sentence(&self) -> String {
        let Self { horizontally, factor, aspect, correlation } = *self;
        let is = |other: f64| (factor / other - 1.0).abs() < 0.03;
        let way = if horizontally { "horizontally" } else { "vertically" };
        let how = if factor > 1.0 { format!("stretched {way} by") } else { format!("squeezed {way}, by") };
        let (ratio, cause) = match horizontally {
            true if is(aspect) => (" = width/height", "the factor width/height of the half width is forgotten"),
            true if is(1.0 / aspect) => {
                (" = height/width", "the factor width/height of the half width is applied twice")
            }
            true if is(aspect * aspect) => {
                (" = (width/height)²", "the half width has the factor height/width in place of width/height")
            }
            false if is(aspect) => (" = width/height", "the half height is wrongly divided by width/height"),
            false if is(1.0 / aspect) => {
                (" = height/width", "the half height has the factor width/height, which belongs only to the half width")
            }
            _ => ("", "check the factor width/height, and which of the two halves it belongs to"),
        };
        format!(
            "Your picture shows the same things {how} {factor:.2}{ratio}: {cause} (scaled back about the centre, it \
             correlates with the expected one by {correlation:.2}). half_height = tan(angle / 2), half_width = \
             half_height * width / height."
        )
    }
}

/// What is scaled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extent {
    Both,
    Width,
    Height,
}

/// A factor, and the correlation under it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scale {
    extent: Extent,
    factor: f64,
    correlation: f64,
}

/// The finding if a factor explains the difference. Width or height alone are tried of pictures of the same proportions.
pub(super) fn found(apart: &Apart) -> Option<Finding> {
    let Scale { extent, factor, correlation } = best_scale(apart)?;
    let moved = !(1.0 / 1.03..1.03).contains(&factor);
    let decisive = correlation >= DECISIVE.0 && correlation >= apart.as_it_is + DECISIVE.1;
    let aspect = apart.expected.width() as f64 / apart.expected.height() as f64;
    (moved && decisive).then(|| match extent {
        Extent::Both => Scaled { factor, correlation }.into(),
        _ => Stretched { horizontally: extent == Extent::Width, factor, aspect, correlation }.into(),
    })
}

/// The factor by which mine shows the same things larger.
fn best_scale(apart: &Apart) -> Option<Scale> {
    let size = structure::thumbnail_size(apart.expected, DECIDING_SIDE);
    let small = |raster: &Raster| structure::thumbnail(raster, ImageOperation::None, size);
    let (mine, expected) = (small(apart.mine), small(apart.expected));
    let size = structure::thumbnail_size(apart.expected, SIDE);
    let tried = |extent: Extent, factor: f64| Scale {
        extent,
        factor,
        correlation: correlation(&mine, &expected, factors(extent, factor), size),
    };
    let sides = |raster: &Raster| [raster.width(), raster.height()];
    let alike = structure::same_proportions(sides(apart.mine), sides(apart.expected));
    let extents = if alike { &[Extent::Both, Extent::Width, Extent::Height][..] } else { &[Extent::Both] };
    extents
        .iter()
        .map(|&extent| best_factor(|factor| tried(extent, factor)))
        .reduce(|best, other| if other.correlation > best.correlation + DECISIVE_EXTENT { other } else { best })
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
