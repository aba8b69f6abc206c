//! The findings of a comparison in plain sentences, and their figures for JSON.

use serde_json::{Value, json};

use super::compare_report::rounded;
use crate::envmap::ImageOperation;
use crate::study::comparison::{Curve, Evidence, Finding, Region};

/// The kind of a finding, for machines.
pub(super) fn kind(finding: &Finding) -> &'static str {
    match finding {
        Finding::NotFinite { .. } => "not_finite",
        Finding::Size { .. } => "size",
        Finding::Flat { .. } => "flat",
        Finding::Unrelated { .. } => "unrelated",
        Finding::Laid { .. } => "laid",
        Finding::RedBlueSwapped { .. } => "red_blue_swapped",
        Finding::Encoding { .. } => "encoding",
        Finding::Exposure { .. } => "exposure",
        Finding::Shifted { .. } => "shifted",
        Finding::ClippedHighlights { .. } => "clipped_highlights",
        Finding::Noise { .. } => "noise",
        Finding::Region { .. } => "region",
        Finding::Everywhere => "everywhere",
    }
}

/// What a student reads.
pub(super) fn sentence(finding: &Finding) -> String {
    match finding {
        Finding::NotFinite { pixels, first: [x, y] } => format!(
            "{pixels} of your pixels are not finite numbers (the first from the top is column {x}, row {y}): somewhere you \
             divide by zero or take the root of a negative number. They are compared as black."
        ),
        Finding::Size { mine, expected, same_proportions } => size(*mine, *expected, *same_proportions),
        Finding::Flat { luma, alpha } => flat(*luma, *alpha),
        Finding::Unrelated { .. } => "Your picture shows something else: nothing in it stands where the expected picture has \
             it, however it is flipped, turned or shifted by up to a tenth. Check the scene, and the camera's position, \
             direction and field of view."
            .to_owned(),
        Finding::Laid { operation, evidence } => format!("{} ({}).", laid(*operation), explained(evidence)),
        Finding::RedBlueSwapped { evidence } => {
            format!("Red and blue have changed places: you write BGR where RGB is expected ({}).", explained(evidence))
        }
        Finding::Encoding { curve, evidence } => format!("{} ({}).", encoding(*curve), explained(evidence)),
        Finding::Exposure { factor, stops, evidence } => {
            format!("Yours is {factor:.2} times as bright: {stops:+.2} stops ({}).", explained(evidence))
        }
        Finding::Shifted { x, y, evidence } => format!("{} ({}).", shifted(*x, *y), explained(evidence)),
        Finding::ClippedHighlights { share } => format!(
            "Highlights are cut off: {:.1} % of your pixels are white at the limit of the file where the expected picture \
             goes on. What is cut off cannot be compared.",
            100.0 * share
        ),
        Finding::Noise { deviation } => format!(
            "What is left has no structure, it is noise (standard deviation {deviation:.1} of 255): more samples a pixel \
             make it smaller."
        ),
        Finding::Region { region } => one_place(region),
        Finding::Everywhere => "The same things are to be seen, but they differ in many places, and no flip, shift, gamma or \
             exposure explains it."
            .to_owned(),
    }
}

fn one_place(region: &Region) -> String {
    format!(
        "It differs in one place: columns {} to {}, rows {} to {} hold {:.0} % of the difference.",
        region.x,
        region.x + region.width - 1,
        region.y,
        region.y + region.height - 1,
        100.0 * region.share
    )
}

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
        Finding::Flat { luma, alpha } => json!({ "luma": rounded(*luma, 3), "alpha": alpha }),
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
        Finding::Region { region } => json!({
            "x": region.x, "y": region.y, "width": region.width, "height": region.height,
            "share": rounded(region.share, 4)
        }),
        Finding::Everywhere => json!({}),
    }
}

fn explained(evidence: &Evidence) -> String {
    let Evidence { before, after } = evidence;
    format!("undoing it takes the mean difference from {before:.1} to {after:.1} of 255")
}

fn size([width, height]: [usize; 2], [expected_width, expected_height]: [usize; 2], same_proportions: bool) -> String {
    let sizes = format!("Yours is {width} x {height} pixels, expected are {expected_width} x {expected_height}");
    if same_proportions {
        return format!("{sizes}: it was resampled for all that follows.");
    }
    format!(
        "{sizes}, which are other proportions: it was stretched for all that follows, so trust little of it. Render it at \
         {expected_width} x {expected_height}."
    )
}

fn flat(luma: f64, alpha: bool) -> String {
    let tone = if luma < 0.01 {
        "Your picture is black: nothing was rendered, or light, camera or material numbers are zero."
    } else if luma > 0.99 {
        "Your picture is white all over: the values are far too large, or the file was written in other units."
    } else {
        "Your picture is of one tone all over: every ray gets the same colour."
    };
    let alpha = if alpha { " The file has an alpha channel, which is not applied: write one without." } else { "" };
    format!("{tone}{alpha}")
}

fn laid(operation: ImageOperation) -> &'static str {
    match operation {
        ImageOperation::None => "Your picture is laid as expected",
        ImageOperation::FlipLeftRight => {
            "Your picture is flipped left-right: the camera's right vector, or the x of the pixel, has the wrong sign"
        }
        ImageOperation::FlipTopBottom => {
            "Your picture is flipped top-bottom: rows are counted from the bottom where the file counts from the top"
        }
        ImageOperation::Turn180 => "Your picture is turned by 180°: both x and y of the pixel have the wrong sign",
        ImageOperation::TurnClockwise => "Your picture is turned by 90° clockwise",
        ImageOperation::TurnCounterclockwise => "Your picture is turned by 90° counterclockwise",
        ImageOperation::Transpose => {
            "Your picture is mirrored about the diagonal from the top left: rows and columns are exchanged"
        }
        ImageOperation::Transverse => {
            "Your picture is mirrored about the diagonal from the top right: rows and columns are exchanged, and counted backwards"
        }
    }
}

fn encoding(curve: Curve) -> String {
    match curve {
        Curve::AsExpected => "The encoding is as expected".to_owned(),
        Curve::NotEncoded => "Your picture looks like the expected one without gamma: the linear values are in the file, encode them as sRGB before writing".to_owned(),
        Curve::EncodedTwice => "Your picture is gamma-encoded twice: encode it only once, when the file is written".to_owned(),
        Curve::PlainGamma => "Your picture is encoded with the power 1/2.2 where the sRGB curve is expected: dark tones differ a little".to_owned(),
        Curve::Power(power) => format!("Your contrast is another: your light is the expected light to the power {power:.2}"),
    }
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

fn shifted(x: f64, y: f64) -> String {
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
        [way(x, "to the right", "to the left"), way(y, "down", "up")].into_iter().flatten().collect();
    let half = [x, y].iter().any(|shift| (shift.abs() - 0.5).abs() < 1e-6);
    let hint = if half { ": send rays through the pixels' centres, at x + 0.5 and y + 0.5" } else { "" };
    format!("Your picture is shifted by {}{hint}", ways.join(" and "))
}
