//! Findings about the remaining difference.

use super::clipped;
use super::edges;
use super::everywhere;
use super::finding::Finding;
use super::noise;
use super::region::{self, PLAIN, Region};
use super::residue::Residue;
use super::subject::Left;
use super::turned_region;
use super::undoing::{Aligned, Undoing};
use super::view::View;
use crate::math::Vec3;

/// What may be said of a difference all over the picture; the first that applies is said.
const ALL_OVER: [fn(&Left) -> Option<Finding>; 3] = [edges::found, noise::found, everywhere::found];

/// A place that is clearly different is named alone if it holds this share of the difference.
const SMALLEST_SHARE: f64 = 0.2;
/// Mean FLIP that is left without being noise or a region, and is worth saying.
const NOTABLE: f64 = 0.05;

/// The findings. `enlarged`: mine had fewer pixels, and lacks their detail. What interpolation took away looks like noise,
/// so noise is not named then.
pub(super) fn rest(view: &View, undoing: &Undoing, worst: Region, enlarged: bool) -> Vec<Finding> {
    let aligned = Aligned { mine: view.mine.clone(), expected: view.expected.clone(), corner: view.corner };
    let clipped = clipped::found(&aligned, &undoing.tone);
    // Undone, white is grey where it was cut off: that explains a difference in one place.
    let cut_shows = clipped.is_some() && undoing.tone.undone(Vec3::ONE).min_element() < 0.99;
    let mut findings: Vec<Finding> = clipped.into_iter().collect();
    if !cut_shows {
        let residue = Residue::of(&aligned);
        let left = Left { view, aligned: &aligned, residue, undone: *undoing != Undoing::NOTHING };
        findings.extend(all_over_or_in_place(&left, worst, enlarged || undoing.interpolates()));
    }
    findings
}

/// What is left: all over, and in one place.
fn all_over_or_in_place(left: &Left, worst: Region, interpolated: bool) -> Vec<Finding> {
    let noise = left.residue.is_noise();
    let plain = is_clearly_different(left.view, worst) && is_a_place(&worst, left.view);
    if (plain && worst.share >= SMALLEST_SHARE) || (!noise && worst.stands_out()) {
        return vec![in_place(left, worst)];
    }
    let notable = if noise { left.residue.is_notable_noise() } else { left.view.metrics.flip > NOTABLE };
    let mut findings = Vec::new();
    if notable && !(interpolated && noise) {
        findings.extend(ALL_OVER.iter().find_map(|found| found(left)));
    }
    if plain {
        findings.push(in_place(left, worst));
    }
    findings
}

/// What is said of the worst region.
fn in_place(left: &Left, worst: Region) -> Finding {
    turned_region::found(left).unwrap_or_else(|| region::finding(worst))
}

/// True if the region is less than half of the picture.
fn is_a_place(region: &Region, view: &View) -> bool {
    2 * region.width * region.height < view.mine.pixels().len()
}

/// True if an eye sees another thing in the region, and it is not noise. The region is given in pixels of the expected
/// picture.
pub(super) fn is_clearly_different(view: &View, region: Region) -> bool {
    region.flip >= PLAIN && !Residue::within(&view.mine, &view.expected, view.corner, region).is_noise()
}
