//! A case: one magnitude swept over decades, and the range in which the kernel stays accurate.

use clap::ValueEnum;
use serde::Serialize;

use super::effort::Effort;
use crate::choice::name_of;
use crate::digits::significant;
use crate::limits::Range;

/// What is to be swept.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Subject {
    /// The group under which the report lists it.
    pub group: Group,
    /// One word, for `--case`.
    pub name: &'static str,
    /// What grows along the sweep.
    pub swept: &'static str,
    /// What the error is, in words and with its unit.
    pub error: &'static str,
    /// The unit alone, short.
    pub unit: &'static str,
    /// The largest error that is right.
    pub bound: f64,
    /// Where the bound must be kept. The sweep goes on beyond, to show where it ends.
    pub promised: Range,
    /// Measures every step.
    #[serde(skip)]
    pub sweep: fn(Effort) -> Vec<Measurement>,
}

/// What a case is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Group {
    /// A direction becomes a texel.
    Lookup,
    /// A ray meets a shape.
    Shapes,
    /// A ray that leaves a surface does not meet it again.
    SelfIntersection,
    /// Reflection and refraction.
    Optics,
    /// Scattering functions, and light sources with an extent.
    #[value(name = "lobes and light")]
    Lobes,
    /// Sums of many samples.
    Sums,
    /// What `check` says about pictures that are small, noisy or compressed.
    Validator,
}

/// The worst error at one magnitude.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Measurement {
    /// What was swept, at this step; more than 0.
    pub magnitude: f64,
    /// In units of the case; infinite where no number came out.
    #[serde(serialize_with = "significant::<3, _>")]
    pub error: f64,
    /// The input that made the error.
    pub input: String,
}

/// A subject that was swept.
#[derive(Debug, Clone)]
pub struct Case {
    /// What was swept.
    pub subject: Subject,
    /// In the order of the magnitudes, upwards; never empty.
    pub measurements: Vec<Measurement>,
}

/// How a case ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Within the bound wherever it was measured.
    Holds,
    /// Within the bound where that is promised; the sweep found where it ends beyond.
    Ends,
    /// Beyond the bound where it is promised; a wrong answer of the validator anywhere.
    Fails,
}

impl Group {
    /// The heading above its cases.
    pub fn title(self) -> String {
        name_of(self)
    }

    /// The largest error beyond the promised range that is no failure: the validator may be undecided about all maps, and
    /// wrong about none.
    fn most(self) -> f64 {
        if self == Self::Validator { 100.0 } else { f64::INFINITY }
    }
}

impl Measurement {
    /// A step, its error and the input that made it.
    pub fn new(magnitude: f64, error: f64, input: impl Into<String>) -> Self {
        Self { magnitude, error, input: input.into() }
    }
}

impl Subject {
    /// Sweeps.
    pub fn measured(self, effort: Effort) -> Case {
        Case { subject: self, measurements: (self.sweep)(effort) }
    }
}

impl Case {
    fn is_within(&self, measurement: &Measurement) -> bool {
        measurement.error <= self.subject.bound
    }

    fn is_promised(&self, measurement: &Measurement) -> bool {
        self.subject.promised.holds(measurement.magnitude)
    }

    /// From the first to the last magnitude of the longest stretch without an error beyond the bound; of equally long ones
    /// the one of larger magnitudes. `None` if there is none.
    pub fn range(&self) -> Option<Range> {
        let stretches = self.measurements.split(|measurement| !self.is_within(measurement));
        let longest = stretches.max_by_key(|stretch| stretch.len())?;
        Some(Range { least: longest.first()?.magnitude, most: longest.last()?.magnitude })
    }

    /// The worst measurement where the bound is promised, or beyond if that is a failure, too.
    pub fn worst(&self) -> &Measurement {
        let counted = self.measurements.iter().filter(|measurement| self.counts(measurement));
        let worst = counted.reduce(|one, other| if other.error > one.error { other } else { one });
        worst.unwrap_or(&self.measurements[0])
    }

    /// True if an error of this measurement is a failure.
    fn counts(&self, measurement: &Measurement) -> bool {
        self.is_promised(measurement) || measurement.error > self.subject.group.most()
    }

    /// Whether the bound is kept over the promised range.
    pub fn verdict(&self) -> Verdict {
        let beyond = |measurement: &&Measurement| !self.is_within(measurement);
        if self.measurements.iter().filter(beyond).any(|measurement| self.counts(measurement)) {
            Verdict::Fails
        } else if self.measurements.iter().any(|measurement| beyond(&measurement)) {
            Verdict::Ends
        } else {
            Verdict::Holds
        }
    }
}
