//! Pictures that agree in a part: what stands there stands where it should, and the rest is other.
//!
//! The luma, freed from slow changes, is correlated block by block. That blocks of pictures of other things correlate by
//! chance is measured on the same pictures, laid over each other with mine moved by eighths of its width.

use super::structure::{self, DECIDING_SIDE};
use crate::colour::luminance;
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

/// How a picture fits in part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Partial {
    /// The share of the blocks with structure that fit, `[0, 1]`.
    pub fits: f64,
    /// The same where nothing but chance lets them fit.
    pub by_chance: f64,
    /// The share of the blocks along the picture's border that differ, `[0, 1]`.
    pub border: f64,
    /// First and last column, and first and last row, between which most of what differs lies, in pixels of the
    /// expected picture.
    pub columns: [usize; 2],
    pub rows: [usize; 2],
}

impl Partial {
    /// True if what differs surrounds what fits.
    pub fn is_surrounding(&self) -> bool {
        self.border >= WIDELY
    }
}

/// The part that fits, if one does; of pictures of display codes, as they lie.
pub(super) fn found(mine_codes: &Raster, expected_codes: &Raster) -> Option<Partial> {
    let size = structure::thumbnail_size(expected_codes, DECIDING_SIDE);
    let small = |raster: &Raster| structure::thumbnail(raster, ImageOperation::None, size);
    let lumas = [small(mine_codes), small(expected_codes)].map(|raster| Plane::of_raster(&raster, luminance));
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
    let [columns, rows] = extent(&differs, size, [expected_codes.width(), expected_codes.height()]);
    Some(Partial { fits, by_chance, border: border(&differs, size), columns, rows })
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
