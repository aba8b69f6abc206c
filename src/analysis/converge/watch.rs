//! The observer of a measurement: progress and cancellation.

use std::time::Duration;

use crate::render::{Progress, Silent};

/// How long a phase will take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Work {
    /// Samples of pixels.
    Samples(u64),
    /// Run time.
    Time(Duration),
}

/// Told of the phases of an experiment; asked whether to stop.
pub trait Watch {
    /// Counts the work of one phase while it runs.
    type Phase: Progress;

    /// A phase begins; it ends when the answer is dropped.
    fn begin(&self, what: &str, work: Work) -> Self::Phase;

    /// True if no more is wanted.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Nobody looks on.
pub struct Unwatched;

impl Watch for Unwatched {
    type Phase = Silent;

    fn begin(&self, _what: &str, _work: Work) -> Silent {
        Silent
    }
}
