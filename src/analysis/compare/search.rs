//! The search for the changes to a picture.

use super::evenness::{self, Evenness};
use super::finding::{Evidence, Finding};
use super::structure::{self, Match};
use super::subject::Apart;
use super::undoing::{Part, Undoing};
use super::{channels, encoding, exposure, orientation, shifted};
use super::{outlines, partial, scaled, shift, smooth, tone_search, unrelated};
use crate::envmap::ImageOperation;
use crate::metrics::{Plane, displayed};
use crate::picture::Raster;

/// The mistakes that can be undone, in the order in which they are told.
const PARTS: [Part; 5] = [orientation::PART, channels::PART, encoding::PART, exposure::PART, shifted::PART];

/// What may be said of pictures in which nothing stands where it should in the tones it should have; the first that
/// applies is said.
const OTHER_PICTURES: [fn(&Apart) -> Option<Finding>; 4] =
    [scaled::found, partial::found, outlines::found, unrelated::found];

/// Pictures that correlate less, under the best orientation and shift, show different things.
const RELATED: f64 = 0.5;
/// Detail lies no farther from where the small pictures have it, in pixels.
const DETAIL_REACH: f64 = 4.0;
/// How much more must be left without a finding than with it: a factor, and codes of 255.
const DECISIVE: (f64, f64) = (1.1, 0.1);

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
    let as_it_is = Match { operation: ImageOperation::None, ..*matched };
    if evenness.iter().all(Evenness::is_even) {
        return Ok(Related { matched: Match { shift: [0, 0], ..as_it_is }, reach: None });
    }
    let apart = Apart { mine, expected, as_it_is: as_it_is.correlation, correlation: matched.correlation };
    let other_picture = || OTHER_PICTURES.iter().find_map(|found| found(&apart)).expect("the last always applies");
    Err(evenness::found(evenness, alpha).unwrap_or_else(other_picture))
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
        let parts: Vec<Part> = PARTS.into_iter().filter(|part| undoing.has(part)).collect();
        if parts.is_empty() {
            return (undoing, Vec::new());
        }
        let after = difference(&undoing);
        let evidence = |part: &Part| {
            let without = (part.without)(undoing);
            if (part.is_judged_blurred)(&undoing) {
                return Evidence { before: blurred(&without), after: blurred(&undoing) };
            }
            Evidence { before: difference(&without), after }
        };
        let evidence: Vec<Evidence> = parts.iter().map(evidence).collect();
        let idle = |evidence: &Evidence| evidence.before < DECISIVE.0 * evidence.after + DECISIVE.1;
        match evidence.iter().position(idle) {
            Some(index) => undoing = (parts[index].without)(undoing),
            None => {
                let findings = parts.iter().zip(evidence).map(|(part, evidence)| (part.finding)(&undoing, evidence));
                return (undoing, findings.collect());
            }
        }
    }
}
