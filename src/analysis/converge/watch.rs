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

/// Follows the phases of an experiment, and may stop it.
pub trait Watch {
    /// Counts the work of one phase while it runs.
    type Phase: Progress;

    /// A phase begins; it ends when the answer is dropped.
    fn begin(&self, what: &str, work: Work) -> Self::Phase;

    /// True if the experiment should stop.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Shows nothing and never stops.
pub struct Unwatched;

impl Watch for Unwatched {
    type Phase = Silent;

    fn begin(&self, _what: &str, _work: Work) -> Silent {
        Silent
    }
}
