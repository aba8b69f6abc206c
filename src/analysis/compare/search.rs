//! The search for what was done to a picture.

use super::evenness::Evenness;
use super::laid::inverse;
use super::structure::{self, Match};
use super::undoing::{Part, Undoing};
use super::{Evidence, Finding, Tone, outlines, partial, scaled, shift, smooth, tone_search};
use crate::envmap::ImageOperation;
use crate::math::Vec3;
use crate::math::functions::binary_logarithm;
use crate::metrics::Plane;
use crate::metrics::displayed;
use crate::picture::Raster;

/// Pictures that correlate less, under the best orientation and shift, show different things.
const RELATED: f64 = 0.5;
/// Detail lies no farther from where the small pictures have it, in pixels.
const DETAIL_REACH: f64 = 4.0;
/// How much more must be left without a finding than with it: a factor, and codes of 255.
const DECISIVE: (f64, f64) = (1.1, 0.1);
/// The raster with black in place of what is no finite number, and the finding if there was any.
pub(super) fn finite(raster: &Raster) -> (Raster, Option<Finding>) {
    let is_unknown = |colour: &Vec3| !colour.is_finite();
    let Some(first) = raster.pixels().iter().position(is_unknown) else { return (raster.clone(), None) };
    let pixels = raster.pixels().iter().filter(|colour| is_unknown(colour)).count();
    let known = |colour: &Vec3| if colour.is_finite() { *colour } else { Vec3::ZERO };
    let mended = raster.pixels().iter().map(known).collect();
    let first = [first % raster.width(), first / raster.width()];
    let mended = Raster::from_pixels(raster.width(), raster.height(), mended);
    (mended, Some(Finding::NotFinite { pixels, first }))
}

/// The finding if the sizes differ, other than by a quarter turn.
pub(super) fn size_finding(mine: &Raster, expected: &Raster) -> Option<Finding> {
    let size = |raster: &Raster| [raster.width(), raster.height()];
    let (mine, expected) = (size(mine), size(expected));
    let turned = [mine[1], mine[0]];
    let same_proportions = structure::same_proportions(mine, expected) || structure::same_proportions(turned, expected);
    (mine != expected && turned != expected).then_some(Finding::Size { mine, expected, same_proportions })
}

/// What is to be undone, and the findings it stands for.
pub(super) fn undoing(mine: &Raster, expected: &Raster, alpha: bool) -> (Undoing, Vec<Finding>) {
    let (mine_codes, expected_codes) = (displayed(mine), displayed(expected));
    let related = match related(&mine_codes, &expected_codes, alpha) {
        Ok(related) => related,
        Err(finding) => return (Undoing::NOTHING, vec![finding]),
    };
    let matched = related.matched;
    let pairs = structure::pairs(&mine_codes, &expected_codes, &matched, structure::DECIDING_SIDE);
    let mut undoing = Undoing { operation: matched.operation, tone: tone_search::explained(&pairs), shift: None };
    if let Some(reach) = related.reach {
        undoing.shift = fine_shift(&undoing, mine, expected, &matched, reach);
    }
    confirmed(undoing, mine, expected)
}

/// Two pictures of the same thing.
struct Related {
    matched: Match,
    /// How far the shift may lie from the rough one, in pixels; none if there is nothing to compare but the tone.
    reach: Option<f64>,
}

/// How pictures of display codes belong together, or the finding if they do not.
fn related(mine: &Raster, expected: &Raster, alpha: bool) -> Result<Related, Finding> {
    let evenness = [mine, expected].map(Evenness::of);
    let flat = evenness.map(|evenness| evenness.is_flat());
    if flat == [false, false] {
        let matched = structure::decided(&structure::matches(mine, expected));
        let correlates = matched.correlation >= RELATED;
        let by_colours = !correlates || structure::is_smooth(mine, expected);
        if let Some(matched) = by_colours.then(|| smooth::matched(mine, expected)).flatten() {
            // Their rough shift is not known, and slow changes show a large one as well as a small one.
            let reach = expected.width().max(expected.height()) as f64 / 10.0;
            return Ok(Related { matched, reach: Some(reach) });
        }
        if correlates {
            return Ok(Related { matched, reach: Some(DETAIL_REACH) });
        }
        return uneven(mine, expected, evenness, &matched, alpha);
    }
    let nothing = Match { operation: ImageOperation::None, correlation: 0.0, shift: [0, 0] };
    uneven(mine, expected, evenness, &nothing, alpha)
}

/// The same for pictures in which nothing correlates.
fn uneven(
    mine: &Raster,
    expected: &Raster,
    evenness: [Evenness; 2],
    matched: &Match,
    alpha: bool,
) -> Result<Related, Finding> {
    let [own, other] = evenness;
    let as_it_is = Match { operation: ImageOperation::None, ..*matched };
    let in_codes = |evenness: Evenness| 255.0 * evenness.deviation;
    match [own.is_even(), other.is_even()] {
        [true, true] => Ok(Related { matched: Match { shift: [0, 0], ..as_it_is }, reach: None }),
        [true, false] => Err(Finding::Flat { luma: own.luma, alpha, deviation: in_codes(own) }),
        [false, true] => Err(Finding::ExpectedEven { mine: in_codes(own), expected: in_codes(other) }),
        [false, false] => Err(something_else(mine, expected, &as_it_is, matched.correlation)),
    }
}

/// What can be said of pictures in which nothing stands where it should in the tones it should have.
fn something_else(mine: &Raster, expected: &Raster, as_it_is: &Match, correlation: f64) -> Finding {
    let aspect = expected.width() as f64 / expected.height() as f64;
    let part = || partial::found(mine, expected).map(|part| Finding::Partial { part });
    let outlines = || outlines::found(mine, expected);
    scaled::found(mine, expected, as_it_is)
        .map(|scale| scale.finding(aspect))
        .or_else(part)
        .or_else(|| {
            outlines().map(|found| Finding::Recoloured { outlines: found.correlation, inverted: found.inverted })
        })
        .unwrap_or(Finding::Unrelated { correlation })
}

/// The shift in pixels of the expected picture, from the rough one of the small pictures.
fn fine_shift(undoing: &Undoing, mine: &Raster, expected: &Raster, matched: &Match, reach: f64) -> Option<[f64; 2]> {
    let size = structure::thumbnail_size(expected, structure::DECIDING_SIDE);
    let scale = [expected.width() as f64 / size[0] as f64, expected.height() as f64 / size[1] as f64];
    let start = [0, 1].map(|axis| f64::from(matched.shift[axis]) * scale[axis]);
    let mine = undoing.unshifted(mine, expected);
    shift::estimated(&Plane::luma(&mine), &Plane::luma(expected), start, reach)
}

/// The undoing without the parts that explain little, and the findings that the others are.
fn confirmed(mut undoing: Undoing, mine: &Raster, expected: &Raster) -> (Undoing, Vec<Finding>) {
    let difference = |undoing: &Undoing| undoing.applied(mine, expected).difference();
    let blurred = |undoing: &Undoing| undoing.applied(mine, expected).blurred_difference();
    loop {
        let parts: Vec<Part> = Undoing::PARTS.into_iter().filter(|&part| undoing.has(part)).collect();
        if parts.is_empty() {
            return (undoing, Vec::new());
        }
        let after = difference(&undoing);
        let evidence = |&part: &Part| match part {
            Part::Shift if undoing.interpolates() => {
                Evidence { before: blurred(&undoing.without(part)), after: blurred(&undoing) }
            }
            _ => Evidence { before: difference(&undoing.without(part)), after },
        };
        let evidence: Vec<Evidence> = parts.iter().map(evidence).collect();
        let idle = |evidence: &Evidence| evidence.before < DECISIVE.0 * evidence.after + DECISIVE.1;
        match evidence.iter().position(idle) {
            Some(index) => undoing = undoing.without(parts[index]),
            None => {
                let findings = parts.iter().zip(evidence).map(|(&part, evidence)| finding(part, &undoing, evidence));
                return (undoing, findings.collect());
            }
        }
    }
}

fn finding(part: Part, undoing: &Undoing, evidence: Evidence) -> Finding {
    let Tone { curve, exposure, .. } = undoing.tone;
    match part {
        Part::Orientation => Finding::Laid { operation: inverse(undoing.operation), evidence },
        Part::Channels => Finding::RedBlueSwapped { evidence },
        Part::Curve => Finding::Encoding { curve, evidence },
        Part::Exposure => {
            let factor = f64::from(exposure);
            Finding::Exposure { factor, stops: binary_logarithm(factor), evidence }
        }
        Part::Shift => {
            let [x, y] = undoing.shift.expect("the shift is among the parts");
            Finding::Shifted { x, y, evidence }
        }
    }
}
