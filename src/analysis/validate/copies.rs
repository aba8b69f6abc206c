//! Which images show the same picture: the same texels, or the same fine detail under noise or another compression.
//!
//! Faces of a real map look in different directions, so their fine detail is not correlated, however much their brightness is.
//! A horizon or a frame is alike on many faces: so each row and column counts without its mean.
//!
//! ```text
//!     picture -> 64 x 64 means -> less the mean of 5 x 5 around -> less the means of its row and its column -> detail
//! ```

use super::borders::border::{Borders, display_of_map};
use super::borders::display::Display;
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

/// The fine detail of a picture, cell by cell, in codes.
pub struct Detail(Vec<f32>);

impl Copies {
    /// Compares the six images with each other.
    pub fn of(map: &CubeMap, borders: &Borders) -> Result<Self> {
        let details = Self::details(map, borders)?;
        let mut copies = [None; 6];
        for (image, copy) in
            Face::ALL.into_iter().zip(&mut copies).filter(|(image, _)| !borders[image.index()].is_flat())
        {
            for other in Face::ALL.into_iter().filter(|&other| other != image) {
                let alike = details[image.index()].correlation(&details[other.index()]) >= SAME_DETAIL;
                if alike || map.picture(image)?.texels() == map.picture(other)?.texels() {
                    copy.get_or_insert(other);
                }
            }
        }
        Ok(Self(copies))
    }

    /// The fine detail of the six images.
    pub fn details(map: &CubeMap, borders: &Borders) -> Result<[Detail; 6]> {
        let mut pictures = Vec::new();
        for image in Face::ALL {
            pictures.push(map.picture(image)?);
        }
        let details = parallel::map(&pictures, |picture| Detail::of(picture, display_of_map(borders)));
        Ok(details.try_into().unwrap_or_else(|_| unreachable!("there are six images")))
    }

    /// Another image that shows the same as this one; `None` if there is none, or the image is flat.
    pub fn of_image(&self, image: Face) -> Option<Face> {
        self.0[image.index()]
    }
}

impl Detail {
    fn of(picture: &Picture, display: Display) -> Self {
        let texel = |at: usize, count: usize| (2 * at + 1) * count / (2 * CELLS * SAMPLES);
        let brightness = |x: usize, y: usize| {
            let linear = picture.texel(texel(x, picture.width()), texel(y, picture.height()));
            display.encode(linear).iter().sum::<f32>() / 3.0
        };
        let cell = |column: usize, row: usize| {
            let inside = (0..SAMPLES * SAMPLES)
                .map(|at| brightness(SAMPLES * column + at % SAMPLES, SAMPLES * row + at / SAMPLES));
            inside.sum::<f32>() / (SAMPLES * SAMPLES) as f32
        };
        let cells: Vec<f32> = (0..CELLS * CELLS).map(|at| cell(at % CELLS, at / CELLS)).collect();
        // Less the mean around, then less the means of its row and its column.
        let within = |at: usize| at.saturating_sub(AROUND)..(at + AROUND + 1).min(CELLS);
        let around = |column: usize, row: usize| {
            let sum = within(row).map(|y| within(column).map(|x| cells[CELLS * y + x]).sum::<f32>()).sum::<f32>();
            sum / (within(row).len() * within(column).len()) as f32
        };
        let fine: Vec<f32> = (0..CELLS * CELLS).map(|at| cells[at] - around(at % CELLS, at / CELLS)).collect();
        let mean = |along: &dyn Fn(usize) -> usize| (0..CELLS).map(|at| fine[along(at)]).sum::<f32>() / CELLS as f32;
        let rows: Vec<f32> = (0..CELLS).map(|row| mean(&|column| CELLS * row + column)).collect();
        let columns: Vec<f32> = (0..CELLS).map(|column| mean(&|row| CELLS * row + column)).collect();
        Self((0..CELLS * CELLS).map(|at| fine[at] - rows[at / CELLS] - columns[at % CELLS]).collect())
    }

    /// The correlation of two details, in `[-1, 1]`; 0 where one of them is hardly more than rounding.
    pub fn correlation(&self, other: &Self) -> f64 {
        let (own, others) = (self.strength(), other.strength());
        let product = self.0.iter().zip(&other.0).map(|(a, b)| f64::from(a * b)).sum::<f64>() / self.0.len() as f64;
        if own.min(others) < LEAST_DETAIL { 0.0 } else { product / (own * others) }
    }

    /// The root of its mean square, in codes.
    pub fn strength(&self) -> f64 {
        let squares: f64 = self.0.iter().map(|value| f64::from(value * value)).sum();
        (squares / self.0.len() as f64).sqrt()
    }

    /// The same with noise of a standard deviation on every cell.
    #[cfg(test)]
    pub fn with_noise(&self, deviation: f32) -> Self {
        let mut state = 1_u64;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f32 / (1_u64 << 24) as f32 - 0.5
        };
        Self(self.0.iter().map(|value| value + deviation * 12.0_f32.sqrt() * uniform()).collect())
    }
}
