//! What a student's picture does differently from the expected one.
//!
//! The search goes from what is seen in spite of everything else to what is fine:
//!
//! ```text
//!   orientation   which way it is laid, and roughly shifted, by correlation, which hardly sees tones
//!   tone     gamma, exposure, channels: a small search, the exposure solved in closed form
//!   shift    to a fraction of a pixel
//!   rest     clipped highlights, a region, edges, noise, or all over
//! ```
//!
//! Pictures without detail are laid by their colours. Where no orientation correlates, another field of view or factor
//! width/height is tried, whether a part of the picture fits in place, and whether the outlines do in other tones.
//!
//! Each finding is kept only if undoing all the others without it leaves decisively more.

mod clipped;
mod edges;
mod evenness;
mod finding;
mod laid;
mod noise;
mod outlines;
mod partial;
mod region;
mod resized;
mod rest;
mod scaled;
mod search;
mod shift;
mod smooth;
mod structure;
mod tone;
mod tone_search;
mod undoing;

pub use finding::{Evidence, Finding};
pub use partial::Partial;
pub use region::Region;
pub use tone::{Curve, Tone};

use crate::metrics::{Metrics, Plane};
use crate::picture::{Header, Picture, Raster};
use undoing::Undoing;

/// Two pictures compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    pub mine: Header,
    pub expected: Header,
    /// In the order they were looked for.
    pub findings: Vec<Finding>,
    /// The pictures as they are; mine resampled if the sizes differ.
    pub before: View,
    /// The pictures after undoing what was found; none if nothing can be undone.
    pub after: Option<View>,
    /// Where they differ most, after undoing what was found.
    pub worst: Region,
    /// True if the pictures, as they are (but for a shift) or after undoing what was found, are plainly other in one
    /// place: a mean FLIP of at least 0.3 in their worst region, and not by noise.
    pub plainly_other: bool,
}

/// Mine and the expected picture in one size, and how they differ.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    pub mine: Raster,
    pub expected: Raster,
    /// Where its top left corner lies in the expected picture.
    pub corner: [usize; 2],
    pub metrics: Metrics,
    /// FLIP of every pixel.
    pub flip: Plane,
}

/// How a comparison ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Every pixel is the same.
    Identical,
    /// Different by no more than the threshold.
    Matches,
    Differs,
}

impl Comparison {
    /// Compares a picture with the expected one. Panics if either has no pixels, which no file has.
    pub fn of(mine: &Picture, expected: &Picture) -> Self {
        let (mine_raster, unknown) = search::finite(&mine.to_raster());
        let (expected_raster, _) = search::finite(&expected.to_raster());
        let mut findings: Vec<Finding> = unknown.into_iter().collect();
        findings.extend(search::size_finding(&mine_raster, &expected_raster));
        let (undoing, found) = search::undoing(&mine_raster, &expected_raster, mine.header().alpha);
        findings.extend(found);
        let view = |undoing: &Undoing| View::of(undoing, &mine_raster, &expected_raster);
        let (before, after) =
            rayon::join(|| view(&Undoing::NOTHING), || (undoing != Undoing::NOTHING).then(|| view(&undoing)));
        let view = after.as_ref().unwrap_or(&before);
        let worst = view.worst_region();
        if !findings.iter().any(Finding::is_another_picture) {
            let pixels = |raster: &Raster| raster.pixels().len();
            let enlarged = pixels(&mine_raster) < pixels(&expected_raster);
            findings.extend(rest::rest(view, &undoing, worst, enlarged));
        }
        let is_plain = |view: &View| rest::is_plainly_other(view, view.worst_region());
        // A shifted edge is not another thing.
        let plainly_other = (undoing.shift.is_none() && is_plain(&before)) || after.as_ref().is_some_and(is_plain);
        Self { mine: mine.header(), expected: expected.header(), findings, before, after, worst, plainly_other }
    }

    /// The view that shows what is left: after undoing what was found.
    pub fn last_view(&self) -> &View {
        self.after.as_ref().unwrap_or(&self.before)
    }

    /// The verdict, given whether the metric is within its threshold.
    pub fn verdict(&self, within: bool) -> Verdict {
        let same_size = (self.mine.width, self.mine.height) == (self.expected.width, self.expected.height);
        if same_size && self.findings.is_empty() && self.before.mine == self.before.expected {
            return Verdict::Identical;
        }
        let other = self.plainly_other || self.findings.iter().any(Finding::is_fault);
        if within && !other { Verdict::Matches } else { Verdict::Differs }
    }
}

impl View {
    fn of(undoing: &Undoing, mine: &Raster, expected: &Raster) -> Self {
        let aligned = undoing.applied(mine, expected);
        let (metrics, flip) = Metrics::with_flip_map(&aligned.mine, &aligned.expected);
        Self { mine: aligned.mine, expected: aligned.expected, corner: aligned.corner, metrics, flip }
    }

    /// The worst region, in pixels of the expected picture.
    fn worst_region(&self) -> Region {
        let region = region::worst(&self.flip);
        Region { x: region.x + self.corner[0], y: region.y + self.corner[1], ..region }
    }
}
