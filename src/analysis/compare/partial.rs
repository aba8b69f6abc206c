//! Pictures that agree in one part: its objects are in place, the rest differs.
//!
//! The luma, freed from slow changes, is correlated block by block. The chance correlation of unrelated blocks is
//! measured on the same pictures, placed over each other with mine moved by eighths of its width.

use serde::Serialize;

use super::finding::{Finding, Kind, Weight};
use super::structure::{self, DECIDING_SIDE};
use super::subject::Apart;
use crate::colour::luminance;
use crate::digits::digits;
use crate::envmap::ImageOperation;
use crate::metrics::{Plane, gaussian};
use crate::picture::Raster;

/// Side of the blocks, in pixels of the small pictures.
const BLOCK: usize = 8;
/// A block has structure if its detail deviates by more in either picture: 5 codes.
const STRUCTURE: f64 = 0.02;
/// Blocks that correlate more fit.
const FITS: f64 = 0.85;
/// The share of the blocks that must fit, and how many times more than by chance.
const DECISIVE: (f64, f64) = (0.12, 4.0);
/// Blocks without structure whose mean lumas differ by more do not agree.
const OTHER_TONE: f64 = 0.04;
/// The share of the picture's border that differs if a surrounding does.
const WIDELY: f64 = 0.6;

/// A part of mine is as expected, and the rest is something else.
#[derive(Serialize)]
struct Partial {
    /// The share of the blocks with structure that fit, `[0, 1]`.
    #[serde(serialize_with = "digits::<3, _>")]
    fits: f64,
    /// The same where nothing but chance lets them fit.
    #[serde(serialize_with = "digits::<3, _>")]
    by_chance: f64,
    /// The share of the blocks along the picture's border that differ, `[0, 1]`.
    #[serde(serialize_with = "digits::<3, _>")]
    border: f64,
    /// First and last column, and first and last row, between which most of what differs lies, in pixels of the
    /// expected picture.
    columns: [usize; 2],
    rows: [usize; 2],
    /// True if what differs surrounds what fits.
    surrounding: bool,
}

impl Kind for Partial {
    const NAME: &'static str = "partial";
    const WEIGHT: Weight = Weight::AnotherPicture;

    fn sentence(&self) -> String {
        let fits = 100.0 * self.fits;
        if self.surrounding {
            return format!(
                "The shapes are in place ({fits:.0} % of the structured area fits); the difference is mostly in the \
                 background ({:.0} % of the picture's border differs). Is the environment read by the right lookup? \
                 `skycube grade` finds out.",
                100.0 * self.border
            );
        }
        let ([left, right], [top, bottom]) = (self.columns, self.rows);
        format!(
            "{fits:.0} % of the structured area fits in place; the rest differs mostly in columns {left} to {right}, \
             rows {top} to {bottom}. Check the objects there; if all are right, check the camera."
        )
    }
}

/// The finding if a part fits in its place.
pub(super) fn found(apart: &Apart) -> Option<Finding> {
    let size = structure::thumbnail_size(apart.expected, DECIDING_SIDE);
    let small = |raster: &Raster| structure::thumbnail(raster, ImageOperation::None, size);
    let lumas = [small(apart.mine), small(apart.expected)].map(|raster| Plane::of_raster(&raster, luminance));
    let details = [detail(&lumas[0]), detail(&lumas[1])];
    let share = |blocks: &[Agreement]| {
        let count = |kind: Agreement| blocks.iter().filter(|&&block| block == kind).count();
        count(Agreement::Fits) as f64 / (count(Agreement::Fits) + count(Agreement::Differs)).max(1) as f64
    };
    let in_place = blocks(&details, 0);
    let fits = share(&in_place);
    let by_chance = (1..8).map(|eighth| share(&blocks(&details, eighth * size[0] / 8))).fold(0.0, f64::max);
    if fits < DECISIVE.0 || fits < DECISIVE.1 * by_chance {
        return None;
    }
    let differs = differing(&lumas, &in_place);
    let [columns, rows] = extent(&differs, size, [apart.expected.width(), apart.expected.height()]);
    let border = border(&differs, size);
    Some(Partial { fits, by_chance, border, columns, rows, surrounding: border >= WIDELY }.into())
}

/// What a block comes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Agreement {
    Empty,
    Fits,
    Differs,
}

/// The luma without what changes slowly.
pub(super) fn detail(luma: &Plane) -> Plane {
    let kernel = gaussian(3.0, 7);
    luma.zip(&luma.filtered(&kernel, &kernel), |value, slow| value - slow)
}

/// Every block, row by row, with mine moved `across` to the left, and round.
fn blocks([mine, expected]: &[Plane; 2], across: usize) -> Vec<Agreement> {
    let width = expected.width();
    let (columns, rows) = (width / BLOCK, expected.height() / BLOCK);
    let block = |index: usize| {
        let (left, top) = (index % columns * BLOCK, index / columns * BLOCK);
        let mut sums = [0.0f64; 3];
        for (x, y) in (top..top + BLOCK).flat_map(|y| (left..left + BLOCK).map(move |x| (x, y))) {
            let (a, b) = (f64::from(mine.at((x + across) % width, y)), f64::from(expected.at(x, y)));
            for (sum, term) in sums.iter_mut().zip([a * a, b * b, a * b]) {
                *sum += term;
            }
        }
        let [own, other, product] = sums.map(|sum| sum / (BLOCK * BLOCK) as f64);
        if own.max(other) <= STRUCTURE * STRUCTURE {
            Agreement::Empty
        } else if product > FITS * ((own + 1e-6) * (other + 1e-6)).sqrt() {
            Agreement::Fits
        } else {
            Agreement::Differs
        }
    };
    (0..columns * rows).map(block).collect()
}

/// Which blocks differ: in their structure, or without any, in their tone.
fn differing(lumas: &[Plane; 2], blocks: &[Agreement]) -> Vec<bool> {
    let [mine, expected] = [&lumas[0], &lumas[1]].map(|luma| luma.block_means(BLOCK));
    let differs = |(index, block): (usize, &Agreement)| match block {
        Agreement::Fits => false,
        Agreement::Differs => true,
        Agreement::Empty => (mine[index] - expected[index]).abs() > OTHER_TONE,
    };
    blocks.iter().enumerate().map(differs).collect()
}

/// The share of the outermost blocks that differ.
fn border(differs: &[bool], [width, height]: [usize; 2]) -> f64 {
    let (columns, rows) = (width / BLOCK, height / BLOCK);
    let outermost = |index: &usize| {
        let (column, row) = (index % columns, index / columns);
        column == 0 || row == 0 || column + 1 == columns || row + 1 == rows
    };
    let border: Vec<usize> = (0..differs.len()).filter(outermost).collect();
    border.iter().filter(|&&index| differs[index]).count() as f64 / border.len().max(1) as f64
}

/// The columns and rows of the picture between which all but a tenth at either end of the differing blocks lie.
fn extent(differs: &[bool], [width, height]: [usize; 2], full: [usize; 2]) -> [[usize; 2]; 2] {
    let columns = width / BLOCK;
    let places = |place: fn(usize, usize) -> usize| {
        let mut places: Vec<usize> =
            (0..differs.len()).filter(|&index| differs[index]).map(|index| place(index, columns)).collect();
        places.sort_unstable();
        places
    };
    let range = |places: Vec<usize>, small: usize, full: usize| {
        let tenth = places.len() / 10;
        let (first, last) = (places.get(tenth), places.get(places.len().saturating_sub(tenth + 1)));
        let pixel = |block: usize| (block * BLOCK * full / small).min(full);
        [pixel(first.copied().unwrap_or(0)), pixel(last.copied().unwrap_or(0) + 1).max(1) - 1]
    };
    [
        range(places(|index, columns| index % columns), width, full[0]),
        range(places(|index, columns| index / columns), height, full[1]),
    ]
}
