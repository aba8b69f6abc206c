//! Pictures with another encoding of light.

use serde::Serialize;

use super::finding::{Evidence, Kind};
use super::tone::{Curve, Tone};
use super::undoing::{Part, Undoing};
use crate::digits::rounded;

/// The encoding of mine is another.
#[derive(Serialize)]
struct Encoding {
    #[serde(rename = "curve")]
    name: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    power: Option<f64>,
    #[serde(skip)]
    curve: Curve,
    #[serde(flatten)]
    evidence: Evidence,
}

impl Kind for Encoding {
    const NAME: &'static str = "encoding";

    fn sentence(&self) -> String {
        let cause = match self.curve {
            Curve::AsExpected => "The encoding is as expected".to_owned(),
            Curve::NotEncoded => {
                "Your picture looks like the expected one without gamma: the linear values are in the file, encode \
                 them as sRGB before writing"
                    .to_owned()
            }
            Curve::EncodedTwice => {
                "Your picture is gamma-encoded twice: encode it only once, when the file is written".to_owned()
            }
            Curve::PlainGamma => {
                "Your picture is encoded with the power 1/2.2 where the sRGB curve is expected: dark tones differ a little"
                    .to_owned()
            }
            Curve::Power(power) => {
                format!("Your contrast differs: your light is the expected light to the power {power:.2}")
            }
        };
        format!("{cause} ({}).", self.evidence)
    }
}

pub(super) const PART: Part = Part {
    without: |undoing| Undoing { tone: Tone { curve: Curve::AsExpected, ..undoing.tone }, ..undoing },
    finding: |undoing, evidence| {
        let curve = undoing.tone.curve;
        let (name, power) = match curve {
            Curve::AsExpected => ("as_expected", None),
            Curve::NotEncoded => ("not_encoded", None),
            Curve::EncodedTwice => ("encoded_twice", None),
            Curve::PlainGamma => ("power_1_2.2", None),
            Curve::Power(power) => ("power", Some(rounded(f64::from(power), 2))),
        };
        Encoding { name, power, curve, evidence }.into()
    },
    is_judged_blurred: |_| false,
};
