//! The report of `skycube compare` on folders: a table, JSON, and a page with the pictures.

use std::fmt;
use std::path::Path;

use serde::Serialize;
use serde_json::{Value, json};

use super::super::formats::{Examined, ReportedFinding};
use super::super::json::to_json;
use super::drawing::encoded_views;
use super::report::CompareReport;
use crate::compare::Verdict;
use crate::error::{Error, Result};

/// Two pictures of the same name, reported.
#[derive(Debug)]
pub struct PairReport {
    /// Their name inside the folders, without extension.
    pub name: String,
    /// What it comes to.
    pub verdict: PairVerdict,
    /// What a person reads: the verdict, then what was found.
    pub sentences: Vec<String>,
    /// For the report as JSON; none unless both pictures were read.
    pub(super) figures: Option<Value>,
    /// PNG files of yours, the expected picture and the difference; none if they need not be seen.
    pub(super) pictures: Option<[Vec<u8>; 3]>,
    pub(crate) examined: Examined,
}

/// What became of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PairVerdict {
    /// Every pixel is the same.
    Identical,
    /// Different by no more than the threshold.
    Matches,
    /// Different by more than the threshold, or another picture.
    Differs,
    /// Expected, and not among yours.
    Missing,
    /// Among yours, and not expected.
    New,
    /// One of the two could not be read.
    Failed,
}

impl PairVerdict {
    /// The word in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Identical => "identical",
            Self::Matches => "matches",
            Self::Differs => "differs",
            Self::Missing => "missing",
            Self::New => "new",
            Self::Failed => "failed",
        }
    }

    /// True if the pair is as it should be.
    pub fn is_right(self) -> bool {
        matches!(self, Self::Identical | Self::Matches)
    }
}

/// The pairs of two folders, in the order of their names.
pub struct FolderReport<'a>(pub &'a [PairReport]);

/// How many pairs have which verdict.
#[derive(Debug, Default, Serialize)]
struct Totals {
    identical: usize,
    matches: usize,
    differs: usize,
    missing: usize,
    new: usize,
    failed: usize,
}

#[derive(Serialize)]
struct Entry<'a> {
    #[serde(skip_serializing_if = "str::is_empty")]
    name: &'a str,
    #[serde(flatten)]
    figures: Option<&'a Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    verdict: Option<PairVerdict>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<&'a str>,
}

impl FolderReport<'_> {
    fn totals(&self) -> Totals {
        let mut totals = Totals::default();
        for pair in self.0 {
            *match pair.verdict {
                PairVerdict::Identical => &mut totals.identical,
                PairVerdict::Matches => &mut totals.matches,
                PairVerdict::Differs => &mut totals.differs,
                PairVerdict::Missing => &mut totals.missing,
                PairVerdict::New => &mut totals.new,
                PairVerdict::Failed => &mut totals.failed,
            } += 1;
        }
        totals
    }

    /// The report for machines. The keys of a pair that is alone, not in folders, stand at the top as well.
    pub fn to_json(&self, is_alone: bool) -> String {
        #[derive(Serialize)]
        struct Json<'a> {
            #[serde(flatten)]
            alone: Option<&'a Value>,
            pairs: Vec<Entry<'a>>,
            totals: Totals,
        }
        let entry = |pair| {
            let PairReport { name, verdict, sentences, figures, .. }: &PairReport = pair;
            let error = sentences.first().filter(|_| *verdict == PairVerdict::Failed).map(String::as_str);
            Entry { name, figures: figures.as_ref(), verdict: figures.is_none().then_some(*verdict), error }
        };
        let alone = self.0.first().filter(|_| is_alone).and_then(|pair| pair.figures.as_ref());
        to_json("compare", &Json { alone, pairs: self.0.iter().map(entry).collect(), totals: self.totals() })
    }

    /// How many pairs there are of each verdict: `3 pairs: 2 identical, 1 differs`.
    pub fn summary(&self) -> String {
        let Totals { identical, matches, differs, missing, new, failed } = self.totals();
        let counts = [
            (identical, "identical"),
            (matches, "within the threshold"),
            (differs, "different"),
            (missing, "missing"),
            (new, "new"),
            (failed, "could not be compared"),
        ];
        let counts: Vec<String> =
            counts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
        let pairs = if self.0.len() == 1 { "1 pair".to_owned() } else { format!("{} pairs", self.0.len()) };
        format!("{pairs}: {}", counts.join(", "))
    }
}

impl CompareReport<'_> {
    /// The report for machines on this pair alone.
    pub fn to_json(&self) -> String {
        let pair = PairReport::compared(String::new(), Path::new(""), self, false);
        FolderReport(&pair.into_iter().collect::<Vec<_>>()).to_json(true)
    }
}

impl PairReport {
    /// Two pictures that were compared; those of a pair that differs are kept, to be shown.
    pub(crate) fn compared(name: String, mine: &Path, report: &CompareReport, keeps_pictures: bool) -> Result<Self> {
        let verdict = match report.verdict {
            Verdict::Identical => PairVerdict::Identical,
            Verdict::Matches => PairVerdict::Matches,
            Verdict::Differs => PairVerdict::Differs,
        };
        let findings = report.comparison().findings.iter().map(|finding| finding.sentence.clone());
        let shown = keeps_pictures && verdict != PairVerdict::Identical;
        Ok(Self {
            sentences: std::iter::once(report.verdict_line()).chain(findings).collect(),
            figures: Some(json!(report)),
            pictures: if shown { Some(encoded_views(&report.comparison().views.before)?) } else { None },
            examined: report.examined(name.clone(), verdict.name(), mine),
            name,
            verdict,
        })
    }

    /// A picture that has no counterpart.
    pub(crate) fn alone(name: String, file: &Path, verdict: PairVerdict) -> Self {
        let sentence = match verdict {
            PairVerdict::Missing => "missing: it is expected, but not among yours",
            _ => "new: no picture of this name is expected",
        };
        Self::without_figures(name, verdict, sentence.to_owned(), |name, sentence| {
            let finding = ReportedFinding::error(verdict.name(), sentence, file);
            Examined { name, verdict: verdict.name(), findings: vec![finding] }
        })
    }

    /// A pair that could not be compared.
    pub(crate) fn failed(name: String, error: &Error) -> Self {
        let sentence = format!("failed: {error}");
        Self::without_figures(name, PairVerdict::Failed, sentence, |name, _| Examined::failed(name, error))
    }

    fn without_figures(
        name: String,
        verdict: PairVerdict,
        sentence: String,
        examined: impl FnOnce(String, String) -> Examined,
    ) -> Self {
        let examined = examined(name.clone(), sentence.clone());
        Self { name, verdict, sentences: vec![sentence], figures: None, pictures: None, examined }
    }

    /// `name  differs: FLIP is 0.3 (at most 0.05 required). It is flipped left-right.`
    pub fn line(&self, width: usize) -> String {
        let sentences = self.sentences.iter().flat_map(|sentence| sentence.lines());
        let most = if self.verdict == PairVerdict::Differs { 2 } else { 1 };
        format!("{:<width$}  {}", self.name, sentences.take(most).collect::<Vec<_>>().join(". "))
    }
}

/// A table with a line for each pair.
impl fmt::Display for FolderReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.0.iter().map(|pair| pair.name.chars().count()).max().unwrap_or(0);
        for pair in self.0 {
            writeln!(formatter, "{}", pair.line(width))?;
        }
        writeln!(formatter, "{}", self.summary())
    }
}
