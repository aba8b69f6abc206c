//! Pictures with the same outlines in other tones: normals turned inside out, lights and darks exchanged, other
//! materials.
//!
//! Outlines are the lengths of the gradients of all three channels, which no exchange of light and dark changes, with
//! large ones bounded: `g / (g + k)`. The chance agreement of unrelated outlines is measured on the same pictures,
//! placed over each other with mine moved by eighths of its width.

use serde::Serialize;

use super::finding::{Finding, Kind, Weight};
use super::partial;
use super::structure::{self, DECIDING_SIDE};
use super::subject::Apart;
use crate::colour::luminance;
use crate::digits::digits;
use crate::envmap::ImageOperation;
use crate::metrics::{Plane, gaussian};
use crate::picture::Raster;

/// The gradient that is half an outline, in codes of `[0, 1]` a pixel of the small pictures.
const HALF: f32 = 0.08;
/// Outlines that correlate this much stand in the same places, if they do by so much more than by chance.
const DECISIVE: (f64, f64) = (0.7, 0.1);
/// Side of the blocks in which light and dark may be exchanged.
const BLOCK: usize = 8;
/// A block has structure if its detail deviates by more in both pictures: 5 codes.
const STRUCTURE: f64 = 0.02;
/// Blocks that correlate less are inverted.
const INVERTED: f64 = -0.5;

/// Everything stands in its place, but in other tones.
#[derive(Serialize)]
struct Recoloured {
    /// The correlation of the outlines, `[-1, 1]`.
    #[serde(serialize_with = "digits::<3, _>")]
    outlines: f64,
    /// The share of the blocks with structure in both pictures in which light and dark are exchanged, `[0, 1]`.
    #[serde(serialize_with = "digits::<3, _>")]
    inverted: f64,
}

impl Kind for Recoloured {
    const NAME: &'static str = "recoloured";
    const WEIGHT: Weight = Weight::AnotherPicture;

    fn sentence(&self) -> String {
        let Self { outlines, inverted } = self;
        let tones = if *inverted >= 0.1 {
            format!("light and dark are exchanged in {:.0} % of the structured area", 100.0 * inverted)
        } else {
            "differently from place to place".to_owned()
        };
        format!(
            "All outlines are in place (they correlate by {outlines:.2}), but the colours differ: {tones}. The camera \
             is right. Check the normals (one that points the other way turns (n + 1) / 2 into the complementary \
             colour, and a lit surface black), then materials and lights."
        )
    }
}

/// The finding if the outlines stand in the same places.
pub(super) fn found(apart: &Apart) -> Option<Finding> {
    let size = structure::thumbnail_size(apart.expected, DECIDING_SIDE);
    let [mine, expected] =
        [apart.mine, apart.expected].map(|raster| structure::thumbnail(raster, ImageOperation::None, size));
    let (own, other) = (outlines(&mine), outlines(&expected));
    let correlation = structure::correlation(&own, &other, [0, 0]);
    let moved = |eighth: usize| structure::correlation(&turned(&own, eighth * size[0] / 8), &other, [0, 0]);
    let by_chance = (1..8).map(moved).fold(0.0, f64::max);
    let agree = correlation >= DECISIVE.0 && correlation >= by_chance + DECISIVE.1;
    agree.then(|| Recoloured { outlines: correlation, inverted: inverted(&mine, &expected) }.into())
}

/// The bounded lengths of the gradients, less their mean.
fn outlines(codes: &Raster) -> Plane {
    let kernel = gaussian(1.0, 3);
    let channels = [0, 1, 2].map(|channel| {
        let plane = Plane::of_raster(codes, |colour| colour[channel]);
        plane.filtered(&kernel, &kernel)
    });
    let (width, height) = (codes.width(), codes.height());
    let slope = |plane: &Plane, x: usize, y: usize| {
        let across = plane.at((x + 1).min(width - 1), y) - plane.at(x.saturating_sub(1), y);
        let down = plane.at(x, (y + 1).min(height - 1)) - plane.at(x, y.saturating_sub(1));
        (across * across + down * down) / 4.0
    };
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let lengths = places.map(|(x, y)| channels.iter().map(|plane| slope(plane, x, y)).sum::<f32>().sqrt());
    let bounded: Vec<f32> = lengths.map(|length| length / (length + HALF)).collect();
    let mean = bounded.iter().sum::<f32>() / bounded.len() as f32;
    Plane::new(width, height, bounded.into_iter().map(|value| value - mean).collect())
}

/// The plane moved to the left, and round.
fn turned(plane: &Plane, across: usize) -> Plane {
    let (width, height) = (plane.width(), plane.height());
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Plane::new(width, height, places.map(|(x, y)| plane.at((x + across) % width, y)).collect())
}

/// The share of the blocks in which light and dark are exchanged.
fn inverted(mine: &Raster, expected: &Raster) -> f64 {
    let [own, other] = [mine, expected].map(|raster| partial::detail(&Plane::of_raster(raster, luminance)));
    let (columns, rows) = (other.width() / BLOCK, other.height() / BLOCK);
    let (mut inverted, mut structured) = (0usize, 0usize);
    for (left, top) in (0..rows).flat_map(|row| (0..columns).map(move |column| (column * BLOCK, row * BLOCK))) {
        let mut sums = [0.0f64; 3];
        for (x, y) in (top..top + BLOCK).flat_map(|y| (left..left + BLOCK).map(move |x| (x, y))) {
            let (a, b) = (f64::from(own.at(x, y)), f64::from(other.at(x, y)));
            sums = [sums[0] + a * a, sums[1] + b * b, sums[2] + a * b];
        }
        let [a, b, product] = sums.map(|sum| sum / (BLOCK * BLOCK) as f64);
        if a.min(b) > STRUCTURE * STRUCTURE {
            structured += 1;
            inverted += usize::from(product < INVERTED * (a * b).sqrt());
        }
    }
    inverted as f64 / structured.max(1) as f64
}
