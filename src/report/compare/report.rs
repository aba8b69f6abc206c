//! The report of `skycube compare`, as text and as JSON.

use std::fmt;
use std::path::Path;

use clap::ValueEnum;
use serde::Serialize;

use super::super::formats::{Examined, ReportedFinding};
use crate::choice::name_of;
use crate::compare::{Comparison, Region, Verdict};
use crate::digits::digits;
use crate::metrics::Metrics;
use crate::picture::Header;
use crate::validate::Level;

/// The measure that decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Metric {
    /// Mean FLIP, what an eye sees when the pictures alternate: 0 for equal pictures, 1 at most
    #[default]
    Flip,
    /// Root mean square error of the linear radiance: 0 for equal pictures
    Rmse,
    /// Peak signal to noise ratio in decibels: the higher the better
    Psnr,
    /// Structural similarity: 1 for equal pictures
    Ssim,
}

impl Metric {
    /// The value of this measure.
    pub fn of(self, metrics: &Metrics) -> f64 {
        match self {
            Metric::Flip => metrics.flip,
            Metric::Rmse => metrics.rmse,
            Metric::Psnr => metrics.psnr,
            Metric::Ssim => metrics.ssim,
        }
    }

    /// The threshold if none is given: another rendering of a scene with few samples passes, another scene does not.
    pub fn default_threshold(self) -> f64 {
        match self {
            Metric::Flip => 0.05,
            Metric::Rmse => 0.05,
            Metric::Psnr => 28.0,
            Metric::Ssim => 0.85,
        }
    }

    /// True if the value is good enough.
    pub fn is_within(self, value: f64, threshold: f64) -> bool {
        match self {
            Metric::Flip | Metric::Rmse => value <= threshold,
            Metric::Psnr | Metric::Ssim => value >= threshold,
        }
    }
}

/// A comparison, to be printed.
#[derive(Serialize)]
pub struct CompareReport<'a> {
    /// What it comes to. The measure is taken of the pictures as they are.
    pub verdict: Verdict,
    metric: Metric,
    #[serde(serialize_with = "digits::<5, _>")]
    value: f64,
    threshold: f64,
    #[serde(flatten)]
    comparison: &'a Comparison,
}

impl<'a> CompareReport<'a> {
    /// The report by the metric that decides, and the largest error that passes (PSNR: the smallest) in its units.
    pub fn new(comparison: &'a Comparison, metric: Metric, threshold: f64) -> Self {
        let value = metric.of(&comparison.views.before.metrics);
        let verdict = comparison.verdict(metric.is_within(value, threshold));
        Self { verdict, metric, value, threshold, comparison }
    }

    /// What was compared, and what was found.
    pub(super) fn comparison(&self) -> &Comparison {
        self.comparison
    }

    /// What was found, for formats that list findings: the verdict if the pictures differ, then each mistake.
    pub(super) fn examined(&self, name: String, verdict: &'static str, mine: &Path) -> Examined {
        let differs = self.verdict == Verdict::Differs;
        let level = if differs { Level::Error } else { Level::Note };
        let reported = |kind, sentence| ReportedFinding { level, ..ReportedFinding::error(kind, sentence, mine) };
        let fault = differs.then(|| reported(verdict, self.verdict_line()));
        let findings = self.comparison.findings.iter().map(|finding| reported(finding.kind, finding.sentence.clone()));
        Examined { name, verdict, findings: fault.into_iter().chain(findings).collect() }
    }

    /// The verdict, and what it goes by.
    pub fn verdict_line(&self) -> String {
        let Self { verdict, metric, value, threshold, .. } = *self;
        let name = name_of(metric).to_uppercase();
        let bound = match metric {
            Metric::Flip | Metric::Rmse => "at most",
            Metric::Psnr | Metric::Ssim => "at least",
        };
        let measured = format!("{name} is {} ({bound} {threshold} required)", in_digits(value));
        let within = metric.is_within(value, threshold);
        match verdict {
            Verdict::Identical => "identical: every pixel is the same".to_owned(),
            Verdict::Matches => format!("matches: {measured}"),
            Verdict::Differs if within => format!("differs: {measured}, but it is not the same picture"),
            Verdict::Differs => format!("differs: {measured}"),
        }
    }
}

impl fmt::Display for CompareReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Comparison { mine, expected, findings, views, worst, .. } = self.comparison;
        writeln!(formatter, "{}", self.verdict_line())?;
        writeln!(formatter, "\nyours     {}", header(mine))?;
        writeln!(formatter, "expected  {}", header(expected))?;
        if !findings.is_empty() {
            writeln!(formatter)?;
        }
        for finding in findings {
            writeln!(formatter, "- {}", finding.sentence)?;
        }
        writeln!(formatter, "\n              RMSE     PSNR     SSIM     FLIP")?;
        writeln!(formatter, "as it is   {}", row(&views.before.metrics))?;
        if let Some(after) = &views.after {
            writeln!(formatter, "undone     {}", row(&after.metrics))?;
        }
        if worst.flip > 0.0 && views.last().metrics.flip > 0.0 {
            let pixels = views.last().mine.pixels().len();
            writeln!(formatter, "\n{}", worst_line(worst, pixels, views.after.is_some()))?;
        }
        Ok(())
    }
}

fn header(header: &Header) -> String {
    let alpha = if header.alpha { ", with alpha (not applied)" } else { "" };
    format!("{} x {}, {}, {} bits{alpha}", header.width, header.height, header.format.name(), header.bit_depth)
}

fn row(metrics: &Metrics) -> String {
    let psnr = if metrics.psnr.is_finite() { format!("{:.2}", metrics.psnr) } else { "inf".to_owned() };
    format!("{:>7.4}  {psnr:>7}  {:>7.4}  {:>7.4}", metrics.rmse, metrics.ssim, metrics.flip)
}

/// The region where a picture of this size differs most.
fn worst_line(worst: &Region, pixels: usize, undone: bool) -> String {
    let Region { x, y, width, height, flip, flip_outside, share } = *worst;
    let left = if undone { "what is left" } else { "the difference" };
    if width * height == pixels {
        return format!("{left} covers the whole picture: mean FLIP {flip:.3}, no region stands out");
    }
    format!(
        "{left} is largest in columns {x} to {}, rows {y} to {}: FLIP {flip:.3} there, {flip_outside:.3} elsewhere, {:.0} % of all",
        x + width - 1,
        y + height - 1,
        100.0 * share
    )
}

fn in_digits(value: f64) -> String {
    if value.is_finite() { format!("{value:.4}") } else { "infinite".to_owned() }
}
