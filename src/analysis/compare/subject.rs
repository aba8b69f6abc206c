//! What detectors look at.

use super::residue::Residue;
use super::undoing::Aligned;
use super::view::View;
use crate::picture::Raster;

/// Two pictures of display codes that do not correlate.
pub(super) struct Apart<'a> {
    pub mine: &'a Raster,
    pub expected: &'a Raster,
    /// The correlation as they are, and in the orientation that was decided for.
    pub as_it_is: f64,
    pub correlation: f64,
}

/// Two pictures after all that could be undone.
pub(super) struct Left<'a> {
    pub view: &'a View,
    pub aligned: &'a Aligned,
    pub residue: Residue,
    /// True if anything was undone.
    pub undone: bool,
}

impl Left<'_> {
    /// How a sentence on the difference begins.
    pub fn subject(&self) -> &'static str {
        if self.undone { "What is left" } else { "The difference" }
    }
}
