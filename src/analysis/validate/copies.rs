//! Which images show the same picture: the same texels, or the same fine detail under noise or another compression.
//!
//! Faces of a real map look in different directions, so their fine detail is not correlated, however much their brightness is.
//! A horizon or a frame is alike on many faces: so each row and column counts without its mean.
//!
//! ```text
//!     picture -> 64 x 64 means -> less the mean of 5 x 5 around -> less the means of its row and its column -> detail
//! ```

use super::borders::border::{Borders, display_of_map};
use super::thresholds::copies::{LEAST_DETAIL, SAME_DETAIL};
use crate::envmap::{CubeMap, Face};
use crate::error::Result;
use crate::parallel;
use crate::picture::Picture;

/// Cells along a side of the reduced picture.
const CELLS: usize = 64;
/// Samples along a side of a cell.
const SAMPLES: usize = 4;
/// Cells on either side that a local mean covers.
const AROUND: usize = 2;

/// By image another that shows the same picture.
#[derive(Debug, Clone, Copy)]
pub struct Copies([Option<Face>; 6]);

impl Copies {
    /// Compares the six images with each other.
    pub fn of(map: &CubeMap, borders: &Borders) -> Result<Self> {
        let mut pictures = Vec::new();
        for image in Face::ALL {
            pictures.push(map.picture(image)?);
        }
        let display = display_of_map(borders);
        let brightness =
            |picture: &Picture, x: usize, y: usize| display.encode(picture.texel(x, y)).iter().sum::<f32>() / 3.0;
        let details = parallel::map(&pictures, |picture| detail(picture, &brightness));
        let same = |one: Face, other: Face| {
            let (one, other) = (one.index(), other.index());
            pictures[one].texels() == pictures[other].texels()
                || correlation(&details[one], &details[other]) >= SAME_DETAIL
        };
        let copy = |image: Face| {
            let others = || Face::ALL.into_iter().filter(|&other| other != image);
            (!borders[image.index()].is_flat()).then(|| others().find(|&other| same(image, other))).flatten()
        };
        Ok(Self(Face::ALL.map(copy)))
    }

    /// Another image that shows the same as this one; `None` if there is none, or the image is flat.
    pub fn of_image(&self, image: Face) -> Option<Face> {
        self.0[image.index()]
    }
}

/// The brightness of the cells less that around them, in codes.
fn detail(picture: &Picture, brightness: &impl Fn(&Picture, usize, usize) -> f32) -> Vec<f32> {
    let texel = |at: usize, count: usize| (2 * at + 1) * count / (2 * CELLS * SAMPLES);
    let cell = |column: usize, row: usize| {
        let inside = (0..SAMPLES * SAMPLES).map(|at| (SAMPLES * column + at % SAMPLES, SAMPLES * row + at / SAMPLES));
        let codes = inside.map(|(x, y)| brightness(picture, texel(x, picture.width()), texel(y, picture.height())));
        codes.sum::<f32>() / (SAMPLES * SAMPLES) as f32
    };
    let cells: Vec<f32> = (0..CELLS * CELLS).map(|at| cell(at % CELLS, at / CELLS)).collect();
    let within = |at: usize| at.saturating_sub(AROUND)..=(at + AROUND).min(CELLS - 1);
    let around = |column: usize, row: usize| {
        let cells: Vec<f32> =
            within(row).flat_map(|y| within(column).map(move |x| (x, y))).map(|(x, y)| cells[CELLS * y + x]).collect();
        cells.iter().sum::<f32>() / cells.len() as f32
    };
    let fine: Vec<f32> = (0..CELLS * CELLS).map(|at| cells[at] - around(at % CELLS, at / CELLS)).collect();
    let mean = |along: &dyn Fn(usize) -> usize| (0..CELLS).map(|at| fine[along(at)]).sum::<f32>() / CELLS as f32;
    let rows: Vec<f32> = (0..CELLS).map(|row| mean(&|column| CELLS * row + column)).collect();
    let columns: Vec<f32> = (0..CELLS).map(|column| mean(&|row| CELLS * row + column)).collect();
    (0..CELLS * CELLS).map(|at| fine[at] - rows[at / CELLS] - columns[at % CELLS]).collect()
}

/// The correlation of two details, in `[-1, 1]`; 0 where one of them is hardly more than rounding.
fn correlation(one: &[f32], other: &[f32]) -> f64 {
    let product = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| f64::from(a * b)).sum::<f64>();
    let (own, others) = (product(one, one), product(other, other));
    let least = (CELLS * CELLS) as f64 * LEAST_DETAIL * LEAST_DETAIL;
    if own.min(others) < least { 0.0 } else { product(one, other) / (own * others).sqrt() }
}
