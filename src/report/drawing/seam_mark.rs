//! The mark of a seam in a drawing.

use tiny_skia::Color;

use crate::envmap::Face;
use crate::validate::{Seam, Verdict};

/// A seam to be drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamMark {
    /// The two faces, in either order.
    pub edge: [Face; 2],
    pub verdict: Verdict,
    /// How many times larger the step across the seam is than the steps beside it; about 1 where all is well.
    pub score: f64,
}

impl From<&Seam> for SeamMark {
    fn from(seam: &Seam) -> Self {
        Self { edge: [seam.edge.first, seam.edge.second], verdict: seam.verdict, score: seam.score }
    }
}

impl SeamMark {
    /// Width and colour of the line: the wider, the worse; from 2 units up to 14 at ten times the detail and more.
    pub(super) fn stroke(&self) -> (f32, Color) {
        let excess = (self.score - 1.0).clamp(0.0, 9.0) as f32;
        (2.0 + 12.0 * excess / 9.0, verdict_colour(self.verdict))
    }
}

/// Green, red, amber.
pub(super) fn verdict_colour(verdict: Verdict) -> Color {
    match verdict {
        Verdict::Fits => Color::from_rgba8(60, 200, 90, 255),
        Verdict::Broken => Color::from_rgba8(240, 50, 40, 255),
        Verdict::Undecidable => Color::from_rgba8(250, 190, 30, 255),
    }
}
