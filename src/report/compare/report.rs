//! The report of `skycube compare`, as text and as JSON.
//!
//! The JSON has these keys, in this order; numbers are rounded to the digits that are stable:
//!
//! ```text
//! verdict:      identical | matches | differs
//! metric, value, threshold                                   what the verdict went by
//! mine:         { width, height, format, bit_depth, alpha }
//! expected:     { the same }
//! findings:     [ { kind, sentence, and the figures of that kind } ]
//! metrics:      { before: { rmse, psnr, ssim, flip },        psnr is null for equal pictures
//!                 after:  { the same } or null }             null if nothing was undone
//! worst_region: { x, y, width, height, flip, flip_outside, share }
//! ```

use std::fmt;

use clap::ValueEnum;
use serde::Serialize;

use super::super::json::to_json;
use crate::compare::{Comparison, Finding, Region, Verdict};
use crate::digits::digits;
use crate::metrics::Metrics;
use crate::picture::Header;

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
pub struct CompareReport<'a> {
    /// What was compared, and what was found.
    pub comparison: &'a Comparison,
    /// The metric that decides the verdict.
    pub metric: Metric,
    /// The largest error that passes (PSNR: the smallest), in units of the metric.
    pub threshold: f64,
}

impl CompareReport<'_> {
    /// What it comes to. The measure is taken of the pictures as they are.
    pub fn verdict(&self) -> Verdict {
        self.comparison.verdict(self.metric.is_within(self.value(), self.threshold))
    }

    fn value(&self) -> f64 {
        self.metric.of(&self.comparison.before.metrics)
    }

    /// The report for machines.
    pub fn to_json(&self) -> String {
        let Comparison { mine, expected, findings, before, after, worst, .. } = self.comparison;
        let report = Json {
            verdict: self.verdict(),
            metric: self.metric,
            value: self.value(),
            threshold: self.threshold,
            mine,
            expected,
            findings,
            metrics: Both { before: before.metrics, after: after.as_ref().map(|view| view.metrics) },
            worst_region: worst,
        };
        to_json("compare", &report)
    }

    fn verdict_line(&self) -> String {
        let (name, value, threshold) = (format!("{:?}", self.metric).to_uppercase(), self.value(), self.threshold);
        let bound = match self.metric {
            Metric::Flip | Metric::Rmse => "at most",
            Metric::Psnr | Metric::Ssim => "at least",
        };
        let measured = format!("{name} is {} ({bound} {threshold} required)", in_digits(value));
        let within = self.metric.is_within(value, threshold);
        match self.verdict() {
            Verdict::Identical => "identical: every pixel is the same".to_owned(),
            Verdict::Matches => format!("matches: {measured}"),
            Verdict::Differs if within => format!("differs: {measured}, but it is not the same picture"),
            Verdict::Differs => format!("differs: {measured}"),
        }
    }
}

impl fmt::Display for CompareReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Comparison { mine, expected, findings, before, after, worst, .. } = self.comparison;
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
        writeln!(formatter, "as it is   {}", row(&before.metrics))?;
        if let Some(after) = after {
            writeln!(formatter, "undone     {}", row(&after.metrics))?;
        }
        if worst.flip > 0.0 && self.comparison.last_view().metrics.flip > 0.0 {
            let pixels = self.comparison.last_view().mine.pixels().len();
            writeln!(formatter, "\n{}", worst_line(worst, pixels, after.is_some()))?;
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

/// The report for machines.
#[derive(Serialize)]
struct Json<'a> {
    verdict: Verdict,
    metric: Metric,
    #[serde(serialize_with = "digits::<5, _>")]
    value: f64,
    threshold: f64,
    mine: &'a Header,
    expected: &'a Header,
    findings: &'a [Finding],
    metrics: Both,
    worst_region: &'a Region,
}

#[derive(Serialize)]
struct Both {
    before: Metrics,
    after: Option<Metrics>,
}
