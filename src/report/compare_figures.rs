//! The figures of a comparison's findings, for JSON.

use serde_json::{Value, json};

use super::rounded::rounded;
use crate::compare::{Curve, Evidence, Finding, Partial, Region};

/// The figures of a finding.
pub(super) fn figures(finding: &Finding) -> Value {
    let with = |mut figures: Value, evidence: &Evidence| {
        figures["difference_before"] = json!(rounded(evidence.before, 2));
        figures["difference_after"] = json!(rounded(evidence.after, 2));
        figures
    };
    match finding {
        Finding::NotFinite { pixels, first: [x, y] } => json!({ "pixels": pixels, "x": x, "y": y }),
        Finding::Size { mine, expected, same_proportions } => {
            json!({ "mine": mine, "expected": expected, "same_proportions": same_proportions })
        }
        Finding::Flat { luma, alpha, deviation } => {
            json!({ "luma": rounded(*luma, 3), "alpha": alpha, "deviation": rounded(*deviation, 1) })
        }
        Finding::ExpectedEven { mine, expected } => {
            json!({ "mine": rounded(*mine, 1), "expected": rounded(*expected, 1) })
        }
        Finding::Scaled { factor, correlation } => {
            json!({ "factor": rounded(*factor, 3), "correlation": rounded(*correlation, 3) })
        }
        Finding::Stretched { .. } => stretched(finding),
        Finding::Recoloured { outlines, inverted } => recoloured(*outlines, *inverted),
        Finding::Partial { part } => partial(part),
        Finding::Unrelated { correlation } => json!({ "correlation": rounded(*correlation, 3) }),
        Finding::Laid { operation, evidence } => with(json!({ "operation": operation.name() }), evidence),
        Finding::RedBlueSwapped { evidence } => with(json!({}), evidence),
        Finding::Encoding { curve, evidence } => with(curve_figures(*curve), evidence),
        Finding::Exposure { factor, stops, evidence } => {
            with(json!({ "factor": rounded(*factor, 3), "stops": rounded(*stops, 2) }), evidence)
        }
        Finding::Shifted { x, y, evidence } => with(json!({ "x": rounded(*x, 2), "y": rounded(*y, 2) }), evidence),
        Finding::ClippedHighlights { share } => json!({ "share": rounded(*share, 4) }),
        Finding::Noise { deviation } => json!({ "deviation": rounded(*deviation, 1) }),
        Finding::Region { region } => one_place(region),
        Finding::Edges { share, area, deviation } => along_edges(*share, *area, *deviation),
        Finding::Everywhere => json!({}),
    }
}

fn stretched(finding: &Finding) -> Value {
    let Finding::Stretched { horizontally, factor, aspect, correlation } = finding else { return json!({}) };
    let [factor, aspect, correlation] = [factor, aspect, correlation].map(|value| rounded(*value, 3));
    json!({ "horizontally": horizontally, "factor": factor, "aspect": aspect, "correlation": correlation })
}

fn recoloured(outlines: f64, inverted: f64) -> Value {
    json!({ "outlines": rounded(outlines, 3), "inverted": rounded(inverted, 3) })
}

fn along_edges(share: f64, area: f64, deviation: f64) -> Value {
    json!({ "share": rounded(share, 3), "area": rounded(area, 3), "deviation": rounded(deviation, 1) })
}

fn partial(part: &Partial) -> Value {
    json!({
        "fits": rounded(part.fits, 3), "by_chance": rounded(part.by_chance, 3), "border": rounded(part.border, 3),
        "columns": part.columns, "rows": part.rows, "surrounding": part.is_surrounding()
    })
}

fn one_place(region: &Region) -> Value {
    json!({
        "x": region.x, "y": region.y, "width": region.width, "height": region.height,
        "flip": rounded(region.flip, 4), "flip_outside": rounded(region.flip_outside, 4),
        "share": rounded(region.share, 4)
    })
}

fn curve_figures(curve: Curve) -> Value {
    match curve {
        Curve::AsExpected => json!({ "curve": "as_expected" }),
        Curve::NotEncoded => json!({ "curve": "not_encoded" }),
        Curve::EncodedTwice => json!({ "curve": "encoded_twice" }),
        Curve::PlainGamma => json!({ "curve": "power_1_2.2" }),
        Curve::Power(power) => json!({ "curve": "power", "power": rounded(f64::from(power), 2) }),
    }
}
