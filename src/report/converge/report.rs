//! The report of `skycube converge`, as text and JSON.

use std::fmt;

use serde::Serialize;
use serde_json::json;

use super::super::grouped::grouped;
use super::super::json::to_json;
use crate::converge::{Bias, Convergence, Curve, ReferenceFacts};

/// The report of `skycube converge`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConvergeReport {
    /// In the order of the command line.
    pub scenes: Vec<ConvergedScene>,
    /// True if Ctrl-C ended it before all was measured.
    pub stopped: bool,
}

/// The result for one scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConvergedScene {
    /// The scene file's name.
    #[serde(rename = "scene")]
    pub name: String,
    /// Width of the picture in pixels.
    pub width: usize,
    /// Height of the picture in pixels.
    pub height: usize,
    /// Renderings of every variant.
    pub seeds: u32,
    /// References and curves of the scene.
    #[serde(flatten)]
    pub convergence: Convergence,
}

impl ConvergeReport {
    /// The report for machines, its keys in the order of the alphabet.
    pub fn to_json(&self) -> String {
        to_json("converge", &json!(self))
    }
}

impl fmt::Display for ConvergeReport {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, scene) in self.scenes.iter().enumerate() {
            if index > 0 {
                writeln!(formatter)?;
            }
            scene.fmt(formatter)?;
        }
        if self.stopped {
            writeln!(formatter, "stopped by Ctrl-C: only the finished steps are shown")?;
        }
        Ok(())
    }
}

impl fmt::Display for ConvergedScene {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, width, height, seeds, convergence } = self;
        writeln!(formatter, "{name}: {width} x {height} pixels, means over {seeds} seeds")?;
        for (number, reference) in convergence.references.iter().enumerate() {
            writeln!(formatter, "reference {}: {}", number + 1, reference_line(reference))?;
        }
        for curve in &convergence.curves {
            self.write_curve(formatter, curve)?;
        }
        if convergence.curves.len() > 1 {
            self.write_summary(formatter)?;
        }
        Ok(())
    }
}

fn reference_line(reference: &ReferenceFacts) -> String {
    let named = reference.configuration.named();
    let value = |index: usize| named[index].1.as_str();
    format!(
        "{}, depth {}, {} filter, {} samples, mean {}, standard error {}, {}",
        value(0),
        value(1),
        value(5),
        reference.samples,
        figure(reference.mean_radiance),
        figure(reference.errors.rmse),
        if reference.cached { "from the cache" } else { "rendered now" }
    )
}

impl ConvergedScene {
    /// What a curve is called beside others.
    pub fn label<'a>(&'a self, curve: &'a Curve) -> &'a str {
        if curve.label.is_empty() { "as in the scene" } else { &curve.label }
    }

    fn write_curve(&self, formatter: &mut fmt::Formatter<'_>, curve: &Curve) -> fmt::Result {
        let against = if self.convergence.references.len() > 1 {
            format!(" (against reference {})", curve.reference + 1)
        } else {
            String::new()
        };
        writeln!(formatter, "\n{}{against}", self.label(curve))?;
        writeln!(
            formatter,
            "  {:>8} {:>9} {:>13} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10}",
            "samples", "seconds", "rays", "RMSE", "rel. MSE", "trimmed", "FLIP", "bias", "1/(MSE s)"
        )?;
        for step in &curve.steps {
            let errors = step.errors;
            writeln!(
                formatter,
                "  {:>8} {:>9} {:>13} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10}",
                step.samples,
                figure(step.seconds),
                grouped(step.rays),
                figure(errors.rmse),
                figure(errors.relative_mse),
                figure(errors.trimmed_relative_mse),
                figure(errors.flip),
                bias(&step.bias),
                figure(step.efficiency())
            )?;
        }
        writeln!(formatter, "  {}", slopes(curve))
    }

    /// One line a variant, at its last step.
    fn write_summary(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let curves = &self.convergence.curves;
        let last = |curve: &Curve| *curve.steps.last().expect("a curve has a step");
        let best = curves.iter().map(|curve| last(curve).efficiency()).fold(0.0, f64::max);
        let width = curves.iter().map(|curve| self.label(curve).len()).max().unwrap_or(0).max(16);
        let head = "at the last step";
        writeln!(
            formatter,
            "\n{head:width$} {:>9} {:>9} {:>9} {:>10} {:>7}  time for the error of the best",
            "samples", "seconds", "RMSE", "bias", "slope"
        )?;
        for curve in curves {
            let step = last(curve);
            let factor = best / step.efficiency();
            let time = if factor > 1.0 { format!("{} times", figure(factor)) } else { "the best".to_owned() };
            let slope = curve.fit.against_samples.map_or_else(|| "-".to_owned(), |slope| format!("{slope:.2}"));
            writeln!(
                formatter,
                "{:width$} {:>9} {:>9} {:>9} {:>10} {slope:>7}  {time}",
                self.label(curve),
                step.samples,
                figure(step.seconds),
                figure(step.errors.rmse),
                bias(&step.bias)
            )?;
        }
        Ok(())
    }
}

/// How the error falls, in words.
fn slopes(curve: &Curve) -> String {
    let total = curve.steps.len();
    let counted = if curve.fit.steps == total { format!("{total}") } else { format!("{} of {total}", curve.fit.steps) };
    match (curve.fit.against_samples, curve.fit.against_seconds) {
        (Some(samples), Some(seconds)) => {
            format!("slope of RMSE: {samples:.2} against samples, {seconds:.2} against seconds, from {counted} steps")
        }
        _ => format!("no slope: {counted} steps with an error above twice the error of the reference"),
    }
}

/// A bias, or what it is below if it cannot be told from 0.
fn bias(bias: &Bias) -> String {
    if bias.is_significant() { figure(bias.root()) } else { format!("< {}", figure(bias.limit())) }
}

/// A number with four significant digits.
pub(super) fn figure(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if !(1e-4..1e7).contains(&size) => format!("{value:.2e}"),
        size if size < 1e-3 => format!("{value:.7}"),
        size if size < 1e-2 => format!("{value:.6}"),
        size if size < 1e-1 => format!("{value:.5}"),
        size if size < 1e1 => format!("{value:.4}").chars().take(6).collect(),
        size if size < 1e2 => format!("{value:.2}"),
        size if size < 1e3 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_about_four_digits() {
        let numbers = [0.0, 1.5e-7, 0.000_123_45, 0.012_345, 0.5, 3.0, 12.345, 99_999.4, 2e9, f64::INFINITY];
        insta::assert_snapshot!(
            numbers.map(figure).join("  "),
            @"0  1.50e-7  0.0001234  0.01235  0.5000  3.0000  12.35  99999  2.00e9  inf"
        );
    }
}
