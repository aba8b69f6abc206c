//! Sample positions: reproducible from pixel and sample number alone, so that threads do not matter.

mod filter;
mod pixel;
pub mod warp;

pub use filter::{FilteredPlace, PixelFilter};
pub use pixel::{PixelSampler, RowSampler, SamplerKind, Sampling};
