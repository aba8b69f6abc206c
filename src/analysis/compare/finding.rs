//! The findings about a picture.
//!
//! A kind of finding is one file with its detector, its figures and its sentence, and one line in a list: `PARTS` of
//! [`super::search`] for mistakes that can be corrected, `OTHER_PICTURES` there for pictures of something else,
//! `ALL_OVER` of [`super::rest`] for the remaining difference.

use std::fmt;

use serde::Serialize;
use serde_json::Value;

use crate::digits::digits;

/// Something that mine does differently, as its detector says it. "Mine" is the student's picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// The kind, for machines.
    pub kind: &'static str,
    /// What a student reads.
    pub sentence: String,
    #[serde(skip)]
    pub(crate) weight: Weight,
    /// The figures of this kind by their names, rounded to the digits that are stable.
    #[serde(flatten)]
    pub figures: Value,
}

/// What a finding means for the verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weight {
    /// The metric decides.
    Difference,
    /// It is not the expected picture, however small the difference in numbers: a missing sphere is a small part of the mean.
    Fault,
    /// The same, and mine shows something else, so that nothing finer can be said.
    AnotherPicture,
}

/// A kind of finding; its fields are the figures.
pub(super) trait Kind: Serialize {
    const NAME: &'static str;
    const WEIGHT: Weight = Weight::Difference;

    fn sentence(&self) -> String;
}

impl<K: Kind> From<K> for Finding {
    fn from(found: K) -> Self {
        let figures = serde_json::to_value(&found).expect("figures are plain data");
        Self { kind: K::NAME, sentence: found.sentence(), weight: K::WEIGHT, figures }
    }
}

/// How much a finding explains: the mean difference on display, in codes of 255, with everything else undone, and with
/// this undone too.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct Evidence {
    #[serde(rename = "difference_before", serialize_with = "digits::<2, _>")]
    pub before: f64,
    #[serde(rename = "difference_after", serialize_with = "digits::<2, _>")]
    pub after: f64,
}

impl fmt::Display for Evidence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { before, after } = self;
        write!(formatter, "its correction reduces the mean difference from {before:.1} to {after:.1} of 255")
    }
}
