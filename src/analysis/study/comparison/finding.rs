//! What can be said of a picture.

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
    /// Mine is of one tone, and the expected picture is not: its luma, `[0, 1]`.
    Flat { luma: f64, alpha: bool },
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
    /// What is left is all over the picture, and nothing above explains it.
    Everywhere,
}

/// Mean FLIP in a region that is plainly other.
const PLAIN: f64 = 0.3;

impl Finding {
    /// True for what makes it another picture, however small the difference in numbers: a missing ball is a small part
    /// of the mean.
    pub fn is_fault(&self) -> bool {
        if let Finding::Region { region } = self {
            return region.flip >= PLAIN;
        }
        matches!(
            self,
            Finding::NotFinite { .. }
                | Finding::Flat { .. }
                | Finding::Unrelated { .. }
                | Finding::Laid { .. }
                | Finding::RedBlueSwapped { .. }
        )
    }
}
