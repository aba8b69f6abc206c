//! A region that shows the expected thing flipped or turned: a texture, or one face of a cube map.

use serde::Serialize;

use super::finding::{Finding, Kind, Weight};
use super::operations::inverse;
use super::region::{self, Region};
use super::structure;
use super::subject::Left;
use crate::envmap::ImageOperation;
use crate::metrics::displayed;
use crate::picture::Raster;

/// The correlation with the expected region from which on it is the same thing.
const SAME: f64 = 0.8;
/// The part of all difference that the region holds at least.
const SHARE: f64 = 0.8;
/// Regions with fewer pixels along a side show too little.
const SMALLEST: usize = 16;

#[derive(Serialize)]
struct TurnedRegion {
    operation: String,
    #[serde(flatten)]
    region: Region,
}

impl Kind for TurnedRegion {
    const NAME: &'static str = "region_orientation";
    const WEIGHT: Weight = Weight::Fault;

    fn sentence(&self) -> String {
        let Region { x, y, width, height, .. } = self.region;
        format!(
            "Columns {x} to {}, rows {y} to {} show the expected picture with the operation {}: u or v of a texture or of \
             a face of the cube map is inverted, or the two are exchanged.",
            x + width - 1,
            y + height - 1,
            self.operation
        )
    }
}

/// The finding if the part of the picture that differs shows in another orientation what is expected there.
pub(super) fn found(left: &Left) -> Option<Finding> {
    let region = region::around_all(&left.view.flip, left.view.corner);
    if region.share < SHARE || region.width.min(region.height) < SMALLEST {
        return None;
    }
    let cut = |raster: &Raster| {
        let [x, y] = [region.x - left.aligned.corner[0], region.y - left.aligned.corner[1]];
        Raster::from_function(region.width, region.height, |column, row| raster.pixel(x + column, y + row))
    };
    let matches = structure::matches(&displayed(&cut(&left.aligned.mine)), &displayed(&cut(&left.aligned.expected)));
    let decided = structure::decided(&matches);
    let is_turned = decided.operation != ImageOperation::None && decided.correlation >= SAME;
    is_turned.then(|| TurnedRegion { operation: inverse(decided.operation).name(), region }.into())
}
