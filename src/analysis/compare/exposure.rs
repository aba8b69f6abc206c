//! Pictures that are brighter or darker.

use serde::Serialize;

use super::finding::{Evidence, Kind};
use super::tone::Tone;
use super::undoing::{Part, Undoing};
use crate::digits::digits;
use crate::math::functions::binary_logarithm;

/// Mine is `factor` times as bright.
#[derive(Serialize)]
struct Exposure {
    #[serde(serialize_with = "digits::<3, _>")]
    factor: f64,
    #[serde(serialize_with = "digits::<2, _>")]
    stops: f64,
    #[serde(flatten)]
    evidence: Evidence,
}

impl Kind for Exposure {
    const NAME: &'static str = "exposure";

    fn sentence(&self) -> String {
        let Self { factor, stops, evidence } = self;
        format!("Yours is {factor:.2} times as bright: {stops:+.2} stops ({evidence}).")
    }
}

pub(super) const PART: Part = Part {
    without: |undoing| Undoing { tone: Tone { exposure: 1.0, ..undoing.tone }, ..undoing },
    finding: |undoing, evidence| {
        let factor = f64::from(undoing.tone.exposure);
        Exposure { factor, stops: binary_logarithm(factor), evidence }.into()
    },
    is_judged_blurred: |_| false,
};
