//! The loops over pixels that an optimised package supplies to the file formats.

use image::{ImageDecoder, ImageResult};

use super::Format;

/// What is compiled where it is fast: this package is not.
pub trait PixelLoops {
    /// A decoder of a format whose crate compiles its loops where they are called; `None` for formats whose crates bring
    /// them compiled.
    fn decoder<'a>(&self, format: Format, encoded: &'a [u8]) -> Option<ImageResult<Box<dyn ImageDecoder + 'a>>>;

    /// What is wrong with the data of a file, where its decoder would not say it.
    fn damage(&self, format: Format, encoded: &[u8]) -> Option<String>;

    /// Stores a stretch of samples among the colours of a picture, given row by row from the top left.
    fn store(&self, stretch: &Stretch, colours: &mut [[f32; 3]]);
}

/// Samples of one channel that lie side by side in a row of an OpenEXR picture.
#[derive(Debug, Clone, Copy)]
pub struct Stretch<'a> {
    /// The number of its first pixel.
    pub start: usize,
    /// Which components of the colour the channel is: one of them, or all three for grey.
    pub components: [bool; 3],
    /// How the file stores them.
    pub kind: SampleKind,
    /// In the order of this machine; as many as there are samples.
    pub bytes: &'a [u8],
}

/// How a sample is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SampleKind {
    /// IEEE 754 half precision, 16 bits.
    Half,
    /// IEEE 754 single precision, 32 bits.
    Float,
    /// Unsigned integer of 32 bits.
    Unsigned,
}

impl SampleKind {
    /// Bytes of a sample.
    pub fn size(self) -> usize {
        if self == Self::Half { 2 } else { 4 }
    }
}
