//! A decoded picture: its header and its samples.

use super::{ColourSpace, Header};

/// A decoded picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Decoded {
    /// Size, format and bits, as [`read_header`](super::read_header) gives them.
    pub header: Header,
    /// `width * height` pixels in rows, from the top left.
    pub samples: Samples,
    /// How the samples become light, if not in the usual way: bytes and words by the sRGB curve, floats as they are.
    pub space: Option<ColourSpace>,
    /// What the file says and the decoder ignores.
    pub notes: Vec<String>,
}

impl Decoded {
    /// Samples in the usual colour space.
    pub(super) fn plain(header: Header, samples: Samples) -> Self {
        Self { header, samples, space: None, notes: Vec::new() }
    }
}

/// Samples row by row from the top left, as the file holds them, after the count of channels: grey, grey and alpha, RGB,
/// or RGB and alpha.
#[derive(Debug, Clone, PartialEq)]
pub enum Samples {
    /// sRGB-encoded.
    Bytes(usize, Vec<u8>),
    /// sRGB-encoded.
    Words(usize, Vec<u16>),
    /// Linear radiance.
    Floats(usize, Vec<f32>),
}
