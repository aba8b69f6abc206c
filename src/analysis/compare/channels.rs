//! Pictures with red and blue exchanged.

use serde::Serialize;

use super::finding::{Evidence, Kind, Weight};
use super::tone::Tone;
use super::undoing::{Part, Undoing};

/// Red and blue have changed places.
#[derive(Serialize)]
struct RedBlueSwapped {
    #[serde(flatten)]
    evidence: Evidence,
}

impl Kind for RedBlueSwapped {
    const NAME: &'static str = "red_blue_swapped";
    const WEIGHT: Weight = Weight::Fault;

    fn sentence(&self) -> String {
        let explained = &self.evidence;
        format!("Red and blue are exchanged: you write BGR where RGB is expected ({explained}).")
    }
}

pub(super) const PART: Part = Part {
    without: |undoing| Undoing { tone: Tone { red_blue_swapped: false, ..undoing.tone }, ..undoing },
    finding: |_, evidence| RedBlueSwapped { evidence }.into(),
    is_judged_blurred: |_| false,
};
