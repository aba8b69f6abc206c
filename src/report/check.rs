//! The report of `skycube check` as text; [`super::map_check`] has it as JSON.

mod repair;
mod text;

pub use repair::picture_repairs;
pub(super) use repair::{Repair, code, repairs, statements};
pub(super) use text::notes;
pub use text::{counted_maps, map_line, totals_line};

use serde::Serialize;

use crate::error::Result;
use crate::validate::{Check, Verdict, joined};

/// A check of a map, to be printed.
#[derive(Serialize)]
pub struct CheckReport<'a> {
    map: String,
    #[serde(flatten)]
    check: &'a Check,
}

impl<'a> CheckReport<'a> {
    /// The report on the map that the user calls `map`.
    pub fn new(map: String, check: &'a Check) -> Self {
        Self { map, check }
    }
}

/// A map as the user calls it, and its check.
pub type MapCheck = (String, Result<Check>);

/// The number of maps per verdict.
#[derive(Default, Serialize)]
pub struct Totals {
    /// Fit.
    pub fits: usize,
    /// Are broken.
    pub broken: usize,
    /// Cannot be decided.
    pub undecidable: usize,
    /// Could not be checked.
    pub failed: usize,
}

impl Totals {
    /// Counts the verdicts.
    pub fn of<'a>(checks: impl IntoIterator<Item = &'a MapCheck>) -> Self {
        let mut totals = Self::default();
        for (_, checked) in checks {
            let count = match checked.as_ref().map(|check| check.verdict) {
                Ok(Verdict::Fits) => &mut totals.fits,
                Ok(Verdict::Broken) => &mut totals.broken,
                Ok(Verdict::Undecidable) => &mut totals.undecidable,
                Err(_) => &mut totals.failed,
            };
            *count += 1;
        }
        totals
    }
}

/// Why the fix of a map changes nothing, as a sentence without its full stop: the map may fit, be undecidable, or have
/// faces that do not belong, which no lookup repairs.
pub fn nothing_to_fix(check: &Check) -> String {
    let names = check.file_names().faces;
    let outliers: Vec<String> = check.outliers.iter().map(|one| names[one.face.index()].clone()).collect();
    match check.verdict {
        Verdict::Fits => "the map fits under this lookup: nothing to fix".to_owned(),
        _ if !check.has_equal_squares() => {
            "broken: the faces are not square or differ in size, which no lookup repairs".to_owned()
        }
        _ if !outliers.is_empty() => {
            format!("broken, and no lookup repairs it: {} does not belong here", joined(&outliers))
        }
        Verdict::Undecidable => {
            "undecidable: the pixels cannot decide whether these faces fit; nothing is changed".to_owned()
        }
        Verdict::Broken => "broken, but no change is certain; nothing is changed".to_owned(),
    }
}
