//! What is to be said of the difference that is left.

use super::edges::Edges;
use super::noise::Residue;
use super::region::PLAIN;
use super::undoing::{Aligned, Undoing};
use super::{Finding, Region, View, clipped};
use crate::math::Vec3;

/// A region is named if it holds this share of the difference, and differs this much.
const REGION: (f64, f64) = (0.4, 0.15);
/// A place that is plainly other is named alone if it holds this share of the difference.
const SMALLEST_SHARE: f64 = 0.2;
/// Mean FLIP that is left without being noise or a region, and is worth saying.
const EVERYWHERE: f64 = 0.05;
/// The share of the pixels whose highlights are cut off, if that is worth saying.
const CUT_OFF: f64 = 0.002;

/// The findings. `enlarged`: mine had fewer pixels, and lacks their detail. What interpolation took away looks like noise,
/// so noise is not named then.
pub(super) fn rest(view: &View, undoing: &Undoing, worst: Region, enlarged: bool) -> Vec<Finding> {
    let aligned = Aligned { mine: view.mine.clone(), expected: view.expected.clone(), corner: view.corner };
    let mut findings = Vec::new();
    let share = clipped::share(&aligned, &undoing.tone);
    if share >= CUT_OFF {
        findings.push(Finding::ClippedHighlights { share });
    }
    // Undone, white is grey where it was cut off: that explains a difference in one place.
    let cut_shows = share >= CUT_OFF && undoing.tone.undone(Vec3::ONE).min_element() < 0.99;
    if !cut_shows {
        findings.extend(left(view, &aligned, worst, enlarged || undoing.interpolates()));
    }
    findings
}

/// What is left: all over, and in one place.
fn left(view: &View, aligned: &Aligned, worst: Region, interpolated: bool) -> Vec<Finding> {
    let place = Finding::Region { region: worst };
    let residue = Residue::of(aligned);
    let plain = is_plainly_other(view, worst) && is_a_place(&worst, view);
    if (plain && worst.share >= SMALLEST_SHARE) || (!residue.is_noise() && stands_out(&worst)) {
        return vec![place];
    }
    let mut findings = Vec::new();
    if !(interpolated && residue.is_noise()) {
        findings.extend(all_over(view, aligned, residue));
    }
    if plain {
        findings.push(place);
    }
    findings
}

fn all_over(view: &View, aligned: &Aligned, residue: Residue) -> Option<Finding> {
    let Residue { deviation, .. } = residue;
    let notable = if residue.is_noise() { residue.is_notable_noise() } else { view.metrics.flip > EVERYWHERE };
    if !notable {
        return None;
    }
    Some(match Edges::of(aligned) {
        Some(Edges { share, area }) => Finding::Edges { share, area, deviation },
        None if residue.is_noise() => Finding::Noise { deviation },
        None => Finding::Everywhere,
    })
}

fn stands_out(worst: &Region) -> bool {
    worst.share >= REGION.0 && worst.flip >= REGION.1 && worst.flip >= 4.0 * worst.flip_outside
}

/// True if the region is less than half of the picture.
fn is_a_place(region: &Region, view: &View) -> bool {
    2 * region.width * region.height < view.mine.pixels().len()
}

/// True if an eye sees another thing in the region, and it is not noise. The region is given in pixels of the expected
/// picture.
pub(super) fn is_plainly_other(view: &View, region: Region) -> bool {
    region.flip >= PLAIN && !Residue::within(&view.mine, &view.expected, view.corner, region).is_noise()
}
