//! The lines of a convergence plot.

use super::report::{ConvergeReport, ConvergedScene};
use crate::converge::{Curve, Errors, Step};

/// The error that is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum Measure {
    /// Root mean square error
    #[default]
    Rmse,
    /// Mean of the squared error over the squared reference
    RelativeMse,
    /// The same without the worst 0.1 % of the pixels
    TrimmedRelativeMse,
    /// Mean FLIP: what an eye sees
    Flip,
}

impl Measure {
    /// The measure among the errors.
    pub fn of(self, errors: &Errors) -> f64 {
        match self {
            Measure::Rmse => errors.rmse,
            Measure::RelativeMse => errors.relative_mse,
            Measure::TrimmedRelativeMse => errors.trimmed_relative_mse,
            Measure::Flip => errors.flip,
        }
    }

    pub(super) fn title(self) -> &'static str {
        match self {
            Measure::Rmse => "root mean square error",
            Measure::RelativeMse => "relative mean square error",
            Measure::TrimmedRelativeMse => "relative mean square error, worst 0.1 % left out",
            Measure::Flip => "mean FLIP",
        }
    }

    /// How the measure falls with independent samples: the exponent, and what the legend calls it.
    pub(super) fn law(self) -> (f64, &'static str) {
        match self {
            Measure::Rmse | Measure::Flip => (-0.5, "slope -1/2: independent samples"),
            Measure::RelativeMse | Measure::TrimmedRelativeMse => (-1.0, "slope -1: independent samples"),
        }
    }
}

/// What the horizontal axis shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cost {
    Samples,
    Seconds,
}

impl Cost {
    pub fn of(self, step: &Step) -> f64 {
        match self {
            Cost::Samples => f64::from(step.samples),
            Cost::Seconds => step.seconds,
        }
    }

    pub fn title(self) -> &'static str {
        match self {
            Cost::Samples => "samples per pixel",
            Cost::Seconds => "seconds",
        }
    }
}

/// One variant of one scene.
pub(super) struct Series<'a> {
    pub label: String,
    measure: Measure,
    steps: &'a [Step],
}

impl Series<'_> {
    /// Cost and error of every step that a logarithmic axis can show.
    pub fn points(&self, cost: Cost) -> Vec<(f64, f64)> {
        let point = |step: &Step| (cost.of(step), self.measure.of(&step.errors));
        let shown = |(x, y): &(f64, f64)| [x, y].iter().all(|value| **value > 0.0 && value.is_finite());
        self.steps.iter().map(point).filter(shown).collect()
    }
}

/// All lines, scene by scene.
pub(super) fn series(report: &ConvergeReport, measure: Measure) -> Vec<Series<'_>> {
    let of_scene = |scene: &'_ ConvergedScene, curve: &'_ Curve| {
        let slope = curve.fit.against_samples.filter(|_| measure == Measure::Rmse);
        let slope = slope.map_or_else(String::new, |slope| format!("  (slope {slope:.2})"));
        match (report.scenes.len(), curve.label.as_str()) {
            (1, _) => format!("{}{slope}", scene.label(curve)),
            (_, "") => format!("{}{slope}", scene.name),
            (_, label) => format!("{}: {label}{slope}", scene.name),
        }
    };
    let scenes = report.scenes.iter();
    let curves = scenes.flat_map(|scene| scene.convergence.curves.iter().map(move |curve| (scene, curve)));
    curves.map(|(scene, curve)| Series { label: of_scene(scene, curve), measure, steps: &curve.steps }).collect()
}

/// The errors of the references themselves, each value once.
pub(super) fn floors(report: &ConvergeReport, measure: Measure) -> Vec<f64> {
    let references = report.scenes.iter().flat_map(|scene| &scene.convergence.references);
    let mut floors: Vec<f64> = references.map(|reference| measure.of(&reference.errors)).collect();
    floors.retain(|floor| *floor > 0.0 && floor.is_finite());
    floors.dedup();
    floors
}
