//! Pictures that are flipped or turned.

use serde::Serialize;

use super::finding::{Evidence, Kind, Weight};
use super::operations::inverse;
use super::undoing::{Part, Undoing};
use crate::envmap::ImageOperation;

/// Mine is the expected picture after this operation.
#[derive(Serialize)]
struct Placed {
    #[serde(rename = "operation")]
    name: String,
    #[serde(skip)]
    operation: ImageOperation,
    #[serde(flatten)]
    evidence: Evidence,
}

impl Kind for Placed {
    const NAME: &'static str = "orientation";
    const WEIGHT: Weight = Weight::Fault;

    fn sentence(&self) -> String {
        let cause = match self.operation {
            ImageOperation::None => "placed as expected",
            ImageOperation::FlipLeftRight => {
                "flipped left-right: x of the pixel has the wrong sign, or right was negated after top = right x \
                 forward was computed"
            }
            ImageOperation::FlipTopBottom => {
                "flipped top-bottom: rows are counted from the bottom where the file counts from the top, or top = \
                 forward x right"
            }
            ImageOperation::Turn180 => {
                "turned by 180°: right = up x forward in place of forward x up (top = right x forward then changes \
                 its sign, too), or x and y of the pixel both have the wrong sign"
            }
            ImageOperation::TurnClockwise => {
                "turned by 90° clockwise: rows and columns are exchanged, and one of them is counted backwards"
            }
            ImageOperation::TurnCounterclockwise => {
                "turned by 90° counterclockwise: rows and columns are exchanged, and one of them is counted backwards"
            }
            ImageOperation::Transpose => {
                "mirrored about the diagonal from the top left: rows and columns are exchanged"
            }
            ImageOperation::Transverse => {
                "mirrored about the diagonal from the top right: right and top are exchanged, or rows and columns \
                 are, both counted backwards"
            }
        };
        format!("Your picture is {cause} ({}).", self.evidence)
    }
}

pub(super) const PART: Part = Part {
    without: |undoing| Undoing { operation: ImageOperation::None, ..undoing },
    finding: |undoing, evidence| {
        let operation = inverse(undoing.operation);
        Placed { name: operation.name(), operation, evidence }.into()
    },
    is_judged_blurred: |_| false,
};
