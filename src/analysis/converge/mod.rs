//! Error against run time: what a second of computing buys.
//!
//! ```text
//!   scene x variants              for every variant, at 1, 4, 16, ... samples:
//!        |                          several renderings of different seeds
//!        v                                    |
//!   reference, of other seeds ------->  errors, bias  ------->  slope of log error against log samples, log time
//!   (two halves: its own error)
//! ```
//!
//! Data only. Times vary from run to run; everything else is the same on any machine and any number of threads.

mod bias;
mod cache;
mod configuration;
mod curve;
mod errors;
mod fit;
mod reference;
mod schedule;
mod variation;
mod watch;

pub use bias::Bias;
pub use configuration::Configuration;
pub use curve::{Curve, Fit, Step};
pub use errors::Errors;
pub use fit::slope;
pub use reference::{Reference, ReferenceFacts};
pub use schedule::Schedule;
pub use variation::{Aspect, Comparison, Setting, Variant, Variation, variants};
pub use watch::{Unwatched, Watch, Work};

use std::path::Path;

use crate::error::{Error, Result};
use crate::scene::Scene;

/// How an experiment is done.
#[derive(Debug, Clone, PartialEq)]
pub struct Protocol<'a> {
    pub schedule: Schedule,
    /// Renderings of every variant, each with a seed of its own; at least 2, for the bias cannot be told from one.
    pub seeds: u32,
    /// Samples a pixel of a reference, over both of its halves.
    pub reference_samples: u32,
    /// The folder where references are kept; `None` keeps none.
    pub cache: Option<&'a Path>,
}

/// The result for one scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Convergence {
    pub references: Vec<ReferenceFacts>,
    /// One of every variant that was begun, with the steps that were finished.
    pub curves: Vec<Curve>,
    /// True if it was stopped before all was measured.
    pub stopped: bool,
}

/// Measures all variants of a scene. Asked to stop, gives the finished steps; an error if there are none.
///
/// The scene is changed on the way and left with the settings of the last variant.
pub fn converge(
    scene: &mut Scene,
    variants: &[Variant],
    protocol: &Protocol,
    watch: &impl Watch,
) -> Result<Convergence> {
    let (aims, numbers) = reference::aims(variants);
    let mut references = Vec::new();
    for (index, aim) in aims.iter().enumerate() {
        let what = if aims.len() > 1 { format!("reference {}", index + 1) } else { "reference".to_owned() };
        references.push(Reference::obtain(scene, *aim, protocol, watch, &what)?);
    }
    let mut curves = Vec::new();
    for (variant, &number) in variants.iter().zip(&numbers) {
        if watch.cancelled() {
            break;
        }
        variant.configuration.apply(scene);
        let curve = Curve::measure(scene, variant, number, &references[number], protocol, watch)?;
        if !curve.steps.is_empty() {
            curves.push(curve);
        }
    }
    if curves.is_empty() {
        return Err(Error::new("stopped before the first step was finished: nothing was written"));
    }
    let references = references.into_iter().map(|reference| reference.facts).collect();
    Ok(Convergence { references, curves, stopped: watch.cancelled() })
}
