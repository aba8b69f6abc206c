//! What a drawing says of a seam.

use tiny_skia::Color;

use crate::envmap::Face;

/// What is known of a seam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeamVerdict {
    /// The faces continue each other.
    Fits,
    /// Another laying fits decisively better.
    Broken,
    /// The pixels cannot tell.
    Undecidable,
    /// The step was measured, but nothing compared with other layings.
    Measured,
}

/// A seam to be drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamMark {
    /// The two faces, in either order.
    pub edge: [Face; 2],
    pub verdict: SeamVerdict,
    /// How many times larger the step across the seam is than the steps beside it; about 1 where all is well.
    pub score: f64,
}

impl SeamVerdict {
    /// The word of the legend.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fits => "fits",
            Self::Broken => "broken",
            Self::Undecidable => "undecidable",
            Self::Measured => "measured, not judged",
        }
    }

    pub(super) fn colour(self) -> Color {
        match self {
            Self::Fits => Color::from_rgba8(60, 200, 90, 255),
            Self::Broken => Color::from_rgba8(240, 50, 40, 255),
            Self::Undecidable => Color::from_rgba8(250, 190, 30, 255),
            Self::Measured => Color::from_rgba8(120, 145, 235, 255),
        }
    }
}

impl SeamMark {
    /// Width and colour of the line: the wider, the worse; from 2 units up to 14 at ten times the detail and more.
    pub(super) fn stroke(&self) -> (f32, Color) {
        let excess = (self.score - 1.0).clamp(0.0, 9.0) as f32;
        (2.0 + 12.0 * excess / 9.0, self.verdict.colour())
    }
}
