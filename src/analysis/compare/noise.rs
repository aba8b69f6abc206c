//! Differences that are noise.

use serde::Serialize;

use super::finding::{Finding, Kind};
use super::subject::Left;
use crate::digits::digits;

/// What is left is noise of this standard deviation, in codes of 255.
#[derive(Serialize)]
struct Noise {
    #[serde(serialize_with = "digits::<1, _>")]
    deviation: f64,
    #[serde(skip)]
    subject: &'static str,
}

impl Kind for Noise {
    const NAME: &'static str = "noise";

    fn sentence(&self) -> String {
        format!(
            "{} has no structure: it is noise (standard deviation {:.1} of 255). More samples per pixel reduce it, \
             unless it is the expected picture's noise.",
            self.subject, self.deviation
        )
    }
}

pub(super) fn found(left: &Left) -> Option<Finding> {
    let residue = left.residue;
    residue.is_noise().then(|| Noise { deviation: residue.deviation, subject: left.subject() }.into())
}
