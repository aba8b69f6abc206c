//! Two pictures side by side.

use serde::Serialize;

use super::region::{self, Region};
use super::undoing::Undoing;
use crate::metrics::{Metrics, Plane};
use crate::picture::Raster;

/// Mine and the expected picture in one size, and how they differ.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct View {
    /// The student's picture, in linear RGB.
    #[serde(skip)]
    pub mine: Raster,
    /// The expected picture, in linear RGB.
    #[serde(skip)]
    pub expected: Raster,
    /// Where its top left corner lies in the expected picture.
    #[serde(skip)]
    pub corner: [usize; 2],
    /// The errors of `mine` against `expected`.
    #[serde(flatten)]
    pub metrics: Metrics,
    /// FLIP of every pixel.
    #[serde(skip)]
    pub flip: Plane,
}

/// The pictures before and after undoing what was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Views {
    /// As they are; mine resampled if the sizes differ.
    pub before: View,
    /// None if nothing can be undone.
    pub after: Option<View>,
}

impl Views {
    /// The view that shows what is left: after undoing what was found.
    pub fn last(&self) -> &View {
        self.after.as_ref().unwrap_or(&self.before)
    }
}

impl View {
    pub(super) fn of(undoing: &Undoing, mine: &Raster, expected: &Raster) -> Self {
        let aligned = undoing.applied(mine, expected);
        let (metrics, flip) = Metrics::with_flip_map(&aligned.mine, &aligned.expected);
        Self { mine: aligned.mine, expected: aligned.expected, corner: aligned.corner, metrics, flip }
    }

    /// The worst region, in pixels of the expected picture.
    pub(super) fn worst_region(&self) -> Region {
        let region = region::worst(&self.flip);
        Region { x: region.x + self.corner[0], y: region.y + self.corner[1], ..region }
    }
}
