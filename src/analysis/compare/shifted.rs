//! Pictures that are shifted.

use serde::Serialize;

use super::finding::{Evidence, Kind};
use super::undoing::{Part, Undoing};
use crate::digits::{digits, rounded};

/// Mine lies this many pixels to the right and down.
#[derive(Serialize)]
struct Shifted {
    #[serde(serialize_with = "digits::<2, _>")]
    x: f64,
    #[serde(serialize_with = "digits::<2, _>")]
    y: f64,
    #[serde(flatten)]
    evidence: Evidence,
}

impl Kind for Shifted {
    const NAME: &'static str = "shifted";

    fn sentence(&self) -> String {
        let Self { x, y, evidence } = self;
        let way = |shift: f64, positive: &str, negative: &str| {
            let count = shift.abs();
            let pixels = if (count - 0.5).abs() < 1e-6 {
                "half a pixel".to_owned()
            } else if (count - 1.0).abs() < 1e-6 {
                "1 pixel".to_owned()
            } else {
                format!("{} pixels", rounded(count, 1))
            };
            (count > 1e-6).then(|| format!("{pixels} {}", if shift > 0.0 { positive } else { negative }))
        };
        let ways: Vec<String> =
            [way(*x, "to the right", "to the left"), way(*y, "down", "up")].into_iter().flatten().collect();
        let half = [x, y].iter().any(|shift| (shift.abs() - 0.5).abs() < 1e-6);
        let hint = if half { ": send rays through the pixels' centres, at x + 0.5 and y + 0.5" } else { "" };
        let blurred = if x.fract() == 0.0 && y.fract() == 0.0 { "" } else { " of the slightly blurred pictures" };
        let Evidence { before, after } = evidence;
        format!(
            "Your picture is shifted by {}{hint} (its correction reduces the mean difference{blurred} from \
             {before:.1} to {after:.1} of 255).",
            ways.join(" and ")
        )
    }
}

pub(super) const PART: Part = Part {
    without: |undoing| Undoing { shift: None, ..undoing },
    finding: |undoing, evidence| {
        let [x, y] = undoing.shift.expect("the shift is among the parts");
        Shifted { x, y, evidence }.into()
    },
    // Between pixels mine is interpolated, which blurs it.
    is_judged_blurred: Undoing::interpolates,
};
