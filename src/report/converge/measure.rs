//! The errors that can be drawn.

use crate::converge::Errors;

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
