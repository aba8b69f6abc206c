//! All findings, corrected together or in part.

use super::finding::{Evidence, Finding};
use super::operations::placed;
use super::resized::resized;
use super::shift;
use super::tone::Tone;
use crate::envmap::ImageOperation;
use crate::metrics::{Plane, display, gaussian};
use crate::picture::Raster;
use rayon::prelude::*;

/// What is done to mine to make it the expected picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Undoing {
    pub operation: ImageOperation,
    pub tone: Tone,
    pub shift: Option<[f64; 2]>,
}

/// One of the mistakes that can be undone.
#[derive(Clone, Copy)]
pub(super) struct Part {
    /// The undoing but for this mistake.
    pub without: fn(Undoing) -> Undoing,
    pub finding: fn(&Undoing, Evidence) -> Finding,
    /// True if blurred pictures are compared to judge what it explains.
    pub is_judged_blurred: fn(&Undoing) -> bool,
}

/// Mine and the expected picture after an undoing, cut to what they share.
pub(super) struct Aligned {
    pub mine: Raster,
    pub expected: Raster,
    /// Where the cut begins in the expected picture, column and row.
    pub corner: [usize; 2],
}

impl Undoing {
    pub const NOTHING: Self = Self { operation: ImageOperation::None, tone: Tone::AS_EXPECTED, shift: None };

    /// True if the part is among what is undone.
    pub fn has(&self, part: &Part) -> bool {
        *self != (part.without)(*self)
    }

    /// True if it shifts by a part of a pixel, so that mine is interpolated.
    pub fn interpolates(&self) -> bool {
        self.shift.is_some_and(|shift| shift.iter().any(|along| along.fract() != 0.0))
    }

    /// Mine in the orientation and the size of the expected picture and with its tone undone, but not shifted.
    pub fn unshifted(&self, mine: &Raster, expected: &Raster) -> Raster {
        let turned = if self.operation == ImageOperation::None { mine.clone() } else { placed(mine, self.operation) };
        let mut sized = resized(&turned, expected.width(), expected.height());
        if self.tone != Tone::AS_EXPECTED {
            sized.pixels_mut().par_iter_mut().for_each(|pixel| *pixel = self.tone.undone(*pixel));
        }
        sized
    }

    /// Mine with all of it undone.
    pub fn applied(&self, mine: &Raster, expected: &Raster) -> Aligned {
        let unshifted = self.unshifted(mine, expected);
        let Some(shift) = self.shift else {
            return Aligned { mine: unshifted, expected: expected.clone(), corner: [0, 0] };
        };
        let (mine, expected, corner) = shift::undone(&unshifted, expected, shift);
        Aligned { mine, expected, corner }
    }
}

impl Aligned {
    /// The mean difference of the displayed lumas, both blurred by a pixel, in codes of 255: interpolating between
    /// pixels cannot restore rough edges, so this shows whether it brought them together.
    pub fn blurred_difference(&self) -> f64 {
        let kernel = gaussian(1.0, 3);
        let blurred = |raster: &Raster| Plane::luma(raster).filtered(&kernel, &kernel);
        let difference = blurred(&self.mine).zip(&blurred(&self.expected), |a, b| (a - b).abs());
        255.0 * difference.mean()
    }

    /// The mean difference on display, in codes of 255; of large pictures, that of every few pixels.
    pub fn difference(&self) -> f64 {
        // An odd stride that no usual width is a multiple of.
        let stride = if self.mine.pixels().len() > 200_000 { 7 } else { 1 };
        let pixels = self.mine.pixels().iter().zip(self.expected.pixels()).step_by(stride);
        let (mut sum, mut count) = (0.0, 0usize);
        for (&a, &b) in pixels {
            sum += f64::from((display(a) - display(b)).abs().element_sum());
            count += 3;
        }
        255.0 * sum / count.max(1) as f64
    }
}
