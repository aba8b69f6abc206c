//! What can be said of a picture.

use super::partial::Partial;
use super::region::Region;
use super::tone::Curve;
use crate::envmap::ImageOperation;

/// How much a finding explains: the mean difference on display, in codes of 255, with everything else undone, and with
/// this undone too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evidence {
    pub before: f64,
    pub after: f64,
}

/// Something that mine does differently. "Mine" is the student's picture.
#[derive(Debug, Clone, PartialEq)]
pub enum Finding {
    /// Pixels that are not finite numbers; the first one from the top. They count as black.
    NotFinite { pixels: usize, first: [usize; 2] },
    /// Width and height differ; mine was resampled.
    Size { mine: [usize; 2], expected: [usize; 2], same_proportions: bool },
    /// Mine is of one tone, and the expected picture is not: its luma, `[0, 1]`, and the standard deviation of the noise
    /// around it, in codes of 255.
    Flat { luma: f64, alpha: bool, deviation: f64 },
    /// The expected picture is of one tone but for noise, and mine is not: standard deviations in codes of 255.
    ExpectedEven { mine: f64, expected: f64 },
    /// Mine shows the same things `factor` times as large: the camera has another field of view.
    Scaled { factor: f64, correlation: f64 },
    /// Mine shows the same things `factor` times as wide (`horizontally`) or as high: the factor width/height is wrong.
    /// `aspect` is that of the expected picture.
    Stretched { horizontally: bool, factor: f64, aspect: f64, correlation: f64 },
    /// Everything stands in its place, but in other tones: the correlation of the outlines, and the share of what has
    /// structure in which light and dark are exchanged, `[0, 1]`.
    Recoloured { outlines: f64, inverted: f64 },
    /// A part of mine is as expected, and the rest is something else.
    Partial { part: Partial },
    /// Nothing in mine stands where the expected picture has it, whichever way it is laid.
    Unrelated { correlation: f64 },
    /// Mine is the expected picture after this operation.
    Laid { operation: ImageOperation, evidence: Evidence },
    /// Red and blue have changed places.
    RedBlueSwapped { evidence: Evidence },
    /// The encoding of mine is another.
    Encoding { curve: Curve, evidence: Evidence },
    /// Mine is `factor` times as bright.
    Exposure { factor: f64, stops: f64, evidence: Evidence },
    /// Mine lies this many pixels to the right and down.
    Shifted { x: f64, y: f64, evidence: Evidence },
    /// This share of the pixels is cut off at white where the expected picture goes on.
    ClippedHighlights { share: f64 },
    /// What is left is noise of this standard deviation, in codes of 255.
    Noise { deviation: f64 },
    /// What is left is mostly in one place.
    Region { region: Region },
    /// What is left lies along edges: this share of the squared difference on this share of the pixels, `[0, 1]`. Its
    /// standard deviation all over, in codes of 255.
    Edges { share: f64, area: f64, deviation: f64 },
    /// What is left is all over the picture, and nothing above explains it.
    Everywhere,
}

impl Finding {
    /// True for what makes it another picture, however small the difference in numbers: a missing ball is a small part
    /// of the mean.
    pub fn is_fault(&self) -> bool {
        self.is_another_picture()
            || matches!(self, Finding::NotFinite { .. } | Finding::Laid { .. } | Finding::RedBlueSwapped { .. })
    }

    /// True if mine shows something else, so that nothing finer can be said.
    pub fn is_another_picture(&self) -> bool {
        matches!(
            self,
            Finding::Flat { .. }
                | Finding::ExpectedEven { .. }
                | Finding::Unrelated { .. }
                | Finding::Scaled { .. }
                | Finding::Stretched { .. }
                | Finding::Recoloured { .. }
                | Finding::Partial { .. }
        )
    }
}
