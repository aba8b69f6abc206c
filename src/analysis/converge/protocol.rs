//! How an experiment is done.

use std::path::Path;

use super::schedule::Schedule;

/// How an experiment is done.
#[derive(Debug, Clone, PartialEq)]
pub struct Protocol<'a> {
    /// The numbers of samples, and when to stop.
    pub schedule: Schedule,
    /// Renderings of every variant, each with another seed; at least 2, since a single one does not show the bias.
    pub seeds: u32,
    /// Samples per pixel of a reference, over both of its halves.
    pub reference_samples: u32,
    /// The folder where references are kept; `None` keeps none.
    pub cache: Option<&'a Path>,
}
