//! The findings of a comparison in plain sentences.

use super::rounded::rounded;
use crate::compare::{Curve, Evidence, Finding, Partial, Region};
use crate::envmap::ImageOperation;

/// The kind of a finding, for machines.
pub(super) fn kind(finding: &Finding) -> &'static str {
    match finding {
        Finding::NotFinite { .. } => "not_finite",
        Finding::Size { .. } => "size",
        Finding::Flat { .. } => "flat",
        Finding::ExpectedEven { .. } => "expected_even",
        Finding::Scaled { .. } => "scaled",
        Finding::Stretched { .. } => "stretched",
        Finding::Recoloured { .. } => "recoloured",
        Finding::Partial { .. } => "partial",
        Finding::Unrelated { .. } => "unrelated",
        Finding::Laid { .. } => "laid",
        Finding::RedBlueSwapped { .. } => "red_blue_swapped",
        Finding::Encoding { .. } => "encoding",
        Finding::Exposure { .. } => "exposure",
        Finding::Shifted { .. } => "shifted",
        Finding::ClippedHighlights { .. } => "clipped_highlights",
        Finding::Noise { .. } => "noise",
        Finding::Region { .. } => "region",
        Finding::Edges { .. } => "edges",
        Finding::Everywhere => "everywhere",
    }
}

/// What a student reads. `undone`: mistakes that were found were undone before the rest was looked at.
pub(super) fn sentence(finding: &Finding, undone: bool) -> String {
    let left = if undone { "What is left" } else { "The difference" };
    match finding {
        Finding::NotFinite { pixels, first } => not_finite(*pixels, *first),
        Finding::Size { mine, expected, same_proportions } => size(*mine, *expected, *same_proportions),
        Finding::Flat { luma, alpha, deviation } => flat(*luma, *alpha, *deviation),
        Finding::ExpectedEven { mine, expected } => format!(
            "The expected picture is even; yours shows something: your tones deviate by {mine:.1} of 255, those expected by \
             {expected:.1}."
        ),
        Finding::Scaled { factor, correlation } => scaled(*factor, *correlation),
        Finding::Stretched { horizontally, factor, aspect, correlation } => {
            stretched(*horizontally, *factor, *aspect, *correlation)
        }
        Finding::Recoloured { outlines, inverted } => recoloured(*outlines, *inverted),
        Finding::Partial { part } => partial(part),
        Finding::Unrelated { .. } => SOMETHING_ELSE.to_owned(),
        Finding::Laid { operation, evidence } => format!("{} ({}).", laid(*operation), explained(evidence)),
        Finding::RedBlueSwapped { evidence } => {
            format!("Red and blue have changed places: you write BGR where RGB is expected ({}).", explained(evidence))
        }
        Finding::Encoding { curve, evidence } => format!("{} ({}).", encoding(*curve), explained(evidence)),
        Finding::Exposure { factor, stops, evidence } => {
            format!("Yours is {factor:.2} times as bright: {stops:+.2} stops ({}).", explained(evidence))
        }
        Finding::Shifted { x, y, evidence } => format!("{} ({}).", shifted(*x, *y), explained_shift(*x, *y, evidence)),
        Finding::ClippedHighlights { share } => format!(
            "Highlights are cut off: {:.1} % of your pixels are white at the limit of the file where the expected picture \
             goes on. What is cut off cannot be compared.",
            100.0 * share
        ),
        Finding::Noise { deviation } => format!(
            "{left} has no structure, it is noise (standard deviation {deviation:.1} of 255): more samples a pixel \
             make it smaller, unless it is the expected picture's noise."
        ),
        Finding::Region { region } => one_place(region),
        Finding::Edges { share, area, .. } => along_edges(left, *share, *area),
        Finding::Everywhere => MANY_PLACES.to_owned(),
    }
}

const SOMETHING_ELSE: &str = "Your picture shows something else: nothing in it stands where the expected picture has it, \
                              however it is flipped, turned or shifted by up to a tenth. Check the scene, and the camera's \
                              position, direction and field of view.";

const MANY_PLACES: &str = "The same things are to be seen, but they differ in many places, and no flip, shift, gamma or \
                           exposure explains it.";

fn not_finite(pixels: usize, [x, y]: [usize; 2]) -> String {
    let (are, they) = match pixels {
        1 => (format!("1 of your pixels is not a finite number (column {x}, row {y})"), "It is"),
        _ => {
            let first = format!("the first from the top is column {x}, row {y}");
            (format!("{pixels} of your pixels are not finite numbers ({first})"), "They are")
        }
    };
    format!("{are}: somewhere you divide by zero or take the root of a negative number. {they} compared as black.")
}

fn along_edges(left: &str, share: f64, area: f64) -> String {
    let (share, area) = (100.0 * share, 100.0 * area);
    format!(
        "{left} lies along edges ({share:.0} % of it on {area:.0} % of the pixels), where samples within the pixel \
         count: render with as many as the expected picture has, and let a single ray go through the pixel's centre."
    )
}

fn one_place(region: &Region) -> String {
    let Region { x, y, width, height, flip, flip_outside, share } = *region;
    let place = format!("columns {x} to {}, rows {y} to {}", x + width - 1, y + height - 1);
    let share = 100.0 * share;
    if share >= 40.0 {
        return format!("It differs in one place: {place} hold {share:.0} % of the difference.");
    }
    format!(
        "It is plainly other in {place}: FLIP {flip:.2} there, {flip_outside:.3} elsewhere ({share:.0} % of the difference)."
    )
}

fn scaled(factor: f64, correlation: f64) -> String {
    let view = if factor > 1.0 { "narrower" } else { "wider" };
    format!(
        "Your picture shows the same things {factor:.2} times as large: your field of view is {view} (scaled back about the \
         centre, it correlates with the expected one by {correlation:.2}). Multiply the tangent of half your angle by \
         {factor:.2}, and check whether the angle is meant across the width or the height, in degrees or radians."
    )
}

fn stretched(horizontally: bool, factor: f64, aspect: f64, correlation: f64) -> String {
    let is = |other: f64| (factor / other - 1.0).abs() < 0.03;
    let way = if horizontally { "horizontally" } else { "vertically" };
    let how = if factor > 1.0 { format!("stretched {way} by") } else { format!("squeezed {way}, by") };
    let (ratio, cause) = match horizontally {
        true if is(aspect) => (" = width/height", "the factor width/height of the half width is forgotten"),
        true if is(1.0 / aspect) => (" = height/width", "the factor width/height of the half width is applied twice"),
        true if is(aspect * aspect) => {
            (" = (width/height)²", "the half width has the factor height/width in place of width/height")
        }
        false if is(aspect) => (" = width/height", "the half height is divided by width/height, as it should not be"),
        false if is(1.0 / aspect) => {
            (" = height/width", "the half height has the factor width/height, which belongs to the half width alone")
        }
        _ => ("", "check the factor width/height, and which of the two halves it belongs to"),
    };
    format!(
        "Your picture shows the same things {how} {factor:.2}{ratio}: {cause} (scaled back about the centre, \
         it correlates with the expected one by {correlation:.2}). half_height = tan(angle / 2), half_width = half_height \
         * width / height."
    )
}

fn recoloured(outlines: f64, inverted: f64) -> String {
    let tones = if inverted >= 0.1 {
        format!("in {:.0} % of what has structure light and dark are exchanged", 100.0 * inverted)
    } else {
        "differently from place to place".to_owned()
    };
    format!(
        "Everything stands in its place (the outlines correlate by {outlines:.2}), but its colours are other ones: {tones}. \
         The camera is right. Check the normals (one that points the other way turns (n + 1) / 2 into the complementary \
         colour, and a lit surface black), then materials and lights."
    )
}

fn partial(part: &Partial) -> String {
    let fits = 100.0 * part.fits;
    if part.is_surrounding() {
        return format!(
            "The shapes stand where they should ({fits:.0} % of what has structure fits in place); what differs is mostly \
             the background ({:.0} % of the picture's border differs). Is the environment read by the right lookup? \
             `skycube grade` finds out.",
            100.0 * part.border
        );
    }
    let ([left, right], [top, bottom]) = (part.columns, part.rows);
    format!(
        "{fits:.0} % of what has structure fits in place; what differs is mostly in columns {left} to {right}, rows {top} to \
         {bottom}. Check what stands there; if everything does, check the camera."
    )
}

fn explained(evidence: &Evidence) -> String {
    let Evidence { before, after } = evidence;
    format!("undoing it takes the mean difference from {before:.1} to {after:.1} of 255")
}

/// Of a shift between pixels the evidence is that of blurred pictures.
fn explained_shift(x: f64, y: f64, evidence: &Evidence) -> String {
    if x.fract() == 0.0 && y.fract() == 0.0 {
        return explained(evidence);
    }
    let Evidence { before, after } = evidence;
    format!(
        "undoing it takes the mean difference of the slightly blurred pictures from {before:.1} to {after:.1} of 255"
    )
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

fn flat(luma: f64, alpha: bool, deviation: f64) -> String {
    let tone = if deviation >= 0.6 {
        format!(
            "Your picture is even but for noise (standard deviation {deviation:.1} of 255); the expected one shows \
             something."
        )
    } else if luma < 0.01 {
        "Your picture is black: nothing was rendered, or light, camera or material numbers are zero.".to_owned()
    } else if luma > 0.99 {
        "Your picture is white all over: the values are far too large, or the file was written in other units."
            .to_owned()
    } else {
        "Your picture is of one tone all over: every ray gets the same colour.".to_owned()
    };
    let alpha = if alpha { " The file has an alpha channel, which is not applied: write one without." } else { "" };
    format!("{tone}{alpha}")
}

fn laid(operation: ImageOperation) -> &'static str {
    match operation {
        ImageOperation::None => "Your picture is laid as expected",
        ImageOperation::FlipLeftRight => {
            "Your picture is flipped left-right: x of the pixel has the wrong sign, or right was negated after top = right x \
             forward was computed"
        }
        ImageOperation::FlipTopBottom => {
            "Your picture is flipped top-bottom: rows are counted from the bottom where the file counts from the top, or \
             top = forward x right"
        }
        ImageOperation::Turn180 => {
            "Your picture is turned by 180°: right = up x forward in place of forward x up (top = right x forward then turns \
             round with it), or x and y of the pixel both have the wrong sign"
        }
        ImageOperation::TurnClockwise => {
            "Your picture is turned by 90° clockwise: rows and columns are exchanged, and one of them is counted backwards"
        }
        ImageOperation::TurnCounterclockwise => {
            "Your picture is turned by 90° counterclockwise: rows and columns are exchanged, and one of them is counted \
             backwards"
        }
        ImageOperation::Transpose => {
            "Your picture is mirrored about the diagonal from the top left: rows and columns are exchanged"
        }
        ImageOperation::Transverse => {
            "Your picture is mirrored about the diagonal from the top right: right and top are exchanged, or rows and \
             columns are, both counted backwards"
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
