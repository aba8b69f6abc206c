//! Sample positions: reproducible from pixel and sample number alone, so that threads do not matter.

mod pixel;

pub use pixel::PixelSampler;
