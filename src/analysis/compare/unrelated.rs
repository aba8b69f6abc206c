//! Pictures of something else.

use serde::Serialize;

use super::finding::{Finding, Kind, Weight};
use super::subject::Apart;
use crate::digits::digits;

/// Nothing in mine stands where the expected picture has it, in any orientation.
#[derive(Serialize)]
struct Unrelated {
    #[serde(serialize_with = "digits::<3, _>")]
    correlation: f64,
}

impl Kind for Unrelated {
    const NAME: &'static str = "unrelated";
    const WEIGHT: Weight = Weight::AnotherPicture;

    fn sentence(&self) -> String {
        "Your picture shows something else: nothing in it matches the expected picture, even flipped, turned or \
         shifted by up to a tenth. Check the scene, and the camera's position, direction and field of view."
            .to_owned()
    }
}

pub(super) fn found(apart: &Apart) -> Option<Finding> {
    Some(Unrelated { correlation: apart.correlation }.into())
}
