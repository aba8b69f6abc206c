//! Two pictures compared.

use serde::Serialize;

use super::finding::{Finding, Weight};
use super::region::Region;
use super::undoing::Undoing;
use super::view::{View, Views};
use super::{not_finite, rest, search, size};
use crate::picture::{Header, Picture, Raster};

/// Two pictures compared.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The student's file.
    pub mine: Header,
    /// The expected file.
    pub expected: Header,
    /// In the order they were looked for.
    pub findings: Vec<Finding>,
    /// The pictures in one size, and their metrics.
    #[serde(rename = "metrics")]
    pub views: Views,
    /// Where they differ most, after undoing what was found.
    #[serde(rename = "worst_region")]
    pub worst: Region,
    /// True if the pictures, as they are (but for a shift) or after undoing what was found, are clearly different in one
    /// place: a mean FLIP of at least 0.3 in their worst region, and not by noise.
    #[serde(skip)]
    pub clearly_different: bool,
}

/// How a comparison ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Every pixel is the same.
    Identical,
    /// Different by no more than the threshold.
    Matches,
    /// Different by more than the threshold, or of another size.
    Differs,
}

impl Comparison {
    /// Compares a picture with the expected one. Panics if either has no pixels, which no file has.
    pub fn of(mine: &Picture, expected: &Picture) -> Self {
        let (mine_raster, unknown) = not_finite::finite(&mine.to_raster());
        let (expected_raster, _) = not_finite::finite(&expected.to_raster());
        let mut findings: Vec<Finding> = unknown.into_iter().collect();
        findings.extend(size::found(&mine_raster, &expected_raster));
        let (undoing, found) = search::undoing(&mine_raster, &expected_raster, mine.header().alpha);
        findings.extend(found);
        let view = |undoing: &Undoing| View::of(undoing, &mine_raster, &expected_raster);
        let (before, after) =
            rayon::join(|| view(&Undoing::NOTHING), || (undoing != Undoing::NOTHING).then(|| view(&undoing)));
        let views = Views { before, after };
        let view = views.last();
        let worst = view.worst_region();
        if !findings.iter().any(|finding| finding.weight == Weight::AnotherPicture) {
            let pixels = |raster: &Raster| raster.pixels().len();
            let enlarged = pixels(&mine_raster) < pixels(&expected_raster);
            findings.extend(rest::rest(view, &undoing, worst, enlarged));
        }
        let is_different = |view: &View| rest::is_clearly_different(view, view.worst_region());
        // A shifted edge is not another thing.
        let clearly_different =
            (undoing.shift.is_none() && is_different(&views.before)) || views.after.as_ref().is_some_and(is_different);
        Self { mine: mine.header(), expected: expected.header(), findings, views, worst, clearly_different }
    }

    /// The verdict, given whether the metric is within its threshold.
    pub fn verdict(&self, within: bool) -> Verdict {
        let same_size = (self.mine.width, self.mine.height) == (self.expected.width, self.expected.height);
        if same_size && self.findings.is_empty() && self.views.before.mine == self.views.before.expected {
            return Verdict::Identical;
        }
        let other = self.clearly_different || self.findings.iter().any(|finding| finding.weight != Weight::Difference);
        if within && !other { Verdict::Matches } else { Verdict::Differs }
    }
}
