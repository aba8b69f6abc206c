//! Sample positions: reproducible from pixel and sample number alone, so that threads do not matter.

mod filter;
mod pixel;
pub mod warp;

pub use filter::{FilteredPlace, PixelFilter};
pub use pixel::{PixelSampler, RowSampler, SamplerKind};

/// How the samples of a picture are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sampling {
    pub sampler: SamplerKind,
    pub filter: PixelFilter,
    /// Another seed gives another, independent picture of the same scene.
    pub seed: u32,
}
