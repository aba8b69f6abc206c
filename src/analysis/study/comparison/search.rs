//! The search for what was done to a picture.

use super::laid::inverse;
use super::noise::Residue;
use super::structure::{self, Match};
use super::tone_search::{self, Pair};
use super::undoing::{Aligned, Part, Undoing};
use super::{Evidence, Finding, Region, Tone, View, clipped, shift};
use crate::colour::luminance;
use crate::envmap::ImageOperation;
use crate::math::Vec3;
use crate::math::functions::binary_logarithm;
use crate::picture::Raster;
use crate::study::Plane;
use crate::study::plane::display;

/// Pictures that correlate less, under the best laying and shift, show different things.
const RELATED: f64 = 0.5;
/// How much more must be left without a finding than with it: a factor, and codes of 255.
const DECISIVE: (f64, f64) = (1.1, 0.1);
/// A region is named if it holds this share of the difference, and differs this much.
const REGION: (f64, f64) = (0.4, 0.15);
/// Mean FLIP that is left without being noise or a region, and is worth saying.
const EVERYWHERE: f64 = 0.05;

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
    let codes = |raster: &Raster| {
        Raster::from_pixels(
            raster.width(),
            raster.height(),
            raster.pixels().iter().map(|&colour| display(colour)).collect(),
        )
    };
    let (mine_codes, expected_codes) = (codes(mine), codes(expected));
    let flat = [&mine_codes, &expected_codes].map(structure::is_flat);
    let (matched, related) = match flat {
        [true, false] => {
            let luma = Plane::of_raster(&mine_codes, luminance).mean();
            return (Undoing::NOTHING, vec![Finding::Flat { luma, alpha }]);
        }
        // Nothing to compare but the tone.
        [_, true] => (Match { operation: ImageOperation::None, correlation: 0.0, shift: [0, 0] }, flat[0]),
        _ => {
            let matched = structure::decided(&structure::matches(&mine_codes, &expected_codes));
            (matched, matched.correlation >= RELATED)
        }
    };
    if !related {
        return (Undoing::NOTHING, vec![Finding::Unrelated { correlation: matched.correlation }]);
    }
    let tone = tone_search::explained(&pairs(&mine_codes, &expected_codes, &matched));
    let mut undoing = Undoing { operation: matched.operation, tone, shift: None };
    if flat == [false, false] {
        undoing.shift = fine_shift(&undoing, mine, expected, &matched);
    }
    confirmed(undoing, mine, expected)
}

/// Pixels of both made small, mine laid and roughly shifted back.
fn pairs(mine_codes: &Raster, expected_codes: &Raster, matched: &Match) -> Vec<Pair> {
    let size = structure::thumbnail_size(expected_codes, structure::DECIDING_SIDE);
    let mine = structure::thumbnail(mine_codes, matched.operation, size);
    let expected = structure::thumbnail(expected_codes, ImageOperation::None, size);
    let linear = |code: Vec3| Vec3::from_array(code.to_array().map(super::tone::decoded));
    let mut pairs = Vec::with_capacity(size[0] * size[1]);
    for (x, y) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))) {
        let there = [x as i32 + matched.shift[0], y as i32 + matched.shift[1]];
        if there[0] < 0 || there[1] < 0 || there[0] >= size[0] as i32 || there[1] >= size[1] as i32 {
            continue;
        }
        let mine_code = mine.pixel(there[0] as usize, there[1] as usize);
        let expected_code = expected.pixel(x, y);
        pairs.push(Pair { mine: linear(mine_code), mine_code, expected: linear(expected_code), expected_code });
    }
    pairs
}

/// The shift in pixels of the expected picture, from the rough one of the small pictures.
fn fine_shift(undoing: &Undoing, mine: &Raster, expected: &Raster, matched: &Match) -> Option<[f64; 2]> {
    let size = structure::thumbnail_size(expected, structure::DECIDING_SIDE);
    let scale = [expected.width() as f64 / size[0] as f64, expected.height() as f64 / size[1] as f64];
    let start = [0, 1].map(|axis| f64::from(matched.shift[axis]) * scale[axis]);
    let mine = undoing.unshifted(mine, expected);
    shift::estimated(&Plane::luma(&mine), &Plane::luma(expected), start)
}

/// The undoing without the parts that explain little, and the findings that the others are.
fn confirmed(mut undoing: Undoing, mine: &Raster, expected: &Raster) -> (Undoing, Vec<Finding>) {
    let difference = |undoing: &Undoing| undoing.applied(mine, expected).difference();
    loop {
        let parts: Vec<Part> = Undoing::PARTS.into_iter().filter(|&part| undoing.has(part)).collect();
        if parts.is_empty() {
            return (undoing, Vec::new());
        }
        let after = difference(&undoing);
        let evidence: Vec<Evidence> =
            parts.iter().map(|&part| Evidence { before: difference(&undoing.without(part)), after }).collect();
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
        Part::Laying => Finding::Laid { operation: inverse(undoing.operation), evidence },
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

/// What is to be said of the difference that is left. `enlarged`: mine had fewer pixels, and lacks their
/// detail. What interpolation took away looks like noise, so noise is not named then.
pub(super) fn rest(view: &View, undoing: &Undoing, worst: Region, enlarged: bool) -> Vec<Finding> {
    let aligned = Aligned { mine: view.mine.clone(), expected: view.expected.clone(), corner: view.corner };
    let mut findings = Vec::new();
    let share = clipped::share(&aligned, &undoing.tone);
    if share >= 0.002 {
        findings.push(Finding::ClippedHighlights { share });
    }
    // Undone, white is grey where it was cut off: that explains a difference in one place.
    let cut_shows = share >= 0.002 && undoing.tone.undone(Vec3::ONE).min_element() < 0.99;
    let residue = Residue::of(&aligned);
    let interpolated = enlarged || undoing.shift.is_some_and(|shift| shift.iter().any(|along| along.fract() != 0.0));
    if cut_shows || (interpolated && residue.is_noise()) {
        return findings;
    }
    if residue.is_notable_noise() {
        findings.push(Finding::Noise { deviation: residue.deviation });
    } else if !residue.is_noise() {
        let stands_out = worst.share >= REGION.0 && worst.flip >= REGION.1 && worst.flip >= 4.0 * worst.flip_outside;
        if stands_out {
            findings.push(Finding::Region { region: worst });
        } else if view.metrics.flip > EVERYWHERE {
            findings.push(Finding::Everywhere);
        }
    }
    findings
}
