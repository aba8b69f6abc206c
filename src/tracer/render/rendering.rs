//! A finished picture.

use super::layers::Layers;
use crate::integrators::RayCounts;
use crate::picture::Raster;
use crate::scene::Wing;

/// A finished picture and what it cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// Linear radiance.
    pub raster: Raster,
    /// Rays of all samples, by kind.
    pub counts: RayCounts,
    /// Samples that every pixel has; some may have more if the rendering was stopped.
    pub samples: u32,
    /// Rows without a sample, which show the coarse picture.
    pub coarse_rows: usize,
    /// True if it was stopped before all samples were taken.
    pub stopped: bool,
    /// The layers requested beside the picture.
    pub layers: Option<Layers>,
    /// What was left out beyond the plan, after a look at the light itself; one sentence an item.
    pub left_out: Vec<String>,
    /// The code that rendered.
    pub wing: Wing,
}
