//! Pictures of another size.

use serde::Serialize;

use super::finding::{Finding, Kind};
use super::structure;
use crate::picture::Raster;

/// Width and height differ; mine was resampled.
#[derive(Serialize)]
struct Size {
    mine: [usize; 2],
    expected: [usize; 2],
    same_proportions: bool,
}

impl Kind for Size {
    const NAME: &'static str = "size";

    fn sentence(&self) -> String {
        let ([width, height], [expected_width, expected_height]) = (self.mine, self.expected);
        let sizes = format!("Yours is {width} x {height} pixels, expected are {expected_width} x {expected_height}");
        if self.same_proportions {
            return format!("{sizes}: it was resampled for the rest of the comparison.");
        }
        format!(
            "{sizes}, in other proportions: it was stretched for the rest of the comparison, which is therefore \
             unreliable. Render it at {expected_width} x {expected_height}."
        )
    }
}

/// The finding if the sizes differ, other than by a quarter turn.
pub(super) fn found(mine: &Raster, expected: &Raster) -> Option<Finding> {
    let size = |raster: &Raster| [raster.width(), raster.height()];
    let (mine, expected) = (size(mine), size(expected));
    let turned = [mine[1], mine[0]];
    let same_proportions = structure::same_proportions(mine, expected) || structure::same_proportions(turned, expected);
    (mine != expected && turned != expected).then(|| Size { mine, expected, same_proportions }.into())
}
