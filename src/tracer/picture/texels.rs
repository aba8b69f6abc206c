//! A picture as its file holds it, decoded but not converted: 8-bit files stay 8 bits per channel.

use super::{Header, Raster};
use crate::colour::{SRGB8_TO_LINEAR, decode_srgb8};
use crate::math::Vec3;

/// A decoded picture. 8-bit files keep their bytes, a quarter of the memory of floats; they are decoded to linear
/// light by table, once, wherever a texel is read. All other files are linear floats.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    header: Header,
    texels: Texels,
}

/// Texels row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub enum Texels {
    /// Three sRGB-encoded bytes a texel.
    Srgb8(Vec<u8>),
    /// Linear radiance.
    Linear(Vec<Vec3>),
}

impl Picture {
    /// A picture from its parts. Panics if the texels are not `width * height`.
    pub fn new(header: Header, texels: Texels) -> Self {
        let count = match &texels {
            Texels::Srgb8(bytes) => bytes.len() / 3,
            Texels::Linear(colours) => colours.len(),
        };
        assert_eq!(count, header.width * header.height, "a picture needs width * height texels");
        Self { header, texels }
    }

    /// Size, format and bits of the file.
    pub fn header(&self) -> Header {
        self.header
    }

    /// Columns of texels.
    pub fn width(&self) -> usize {
        self.header.width
    }

    /// Rows of texels.
    pub fn height(&self) -> usize {
        self.header.height
    }

    /// The texels in rows, from the top left.
    pub fn texels(&self) -> &Texels {
        &self.texels
    }

    /// The linear colour of the texel in column `x` and row `y`, counted from the top left.
    #[inline]
    pub fn texel(&self, x: usize, y: usize) -> Vec3 {
        let index = y * self.header.width + x;
        match &self.texels {
            Texels::Srgb8(bytes) => decode_srgb8([bytes[3 * index], bytes[3 * index + 1], bytes[3 * index + 2]]),
            Texels::Linear(colours) => colours[index],
        }
    }

    /// The picture as linear floats.
    pub fn to_raster(&self) -> Raster {
        let pixels = match &self.texels {
            Texels::Srgb8(bytes) => bytes
                .chunks_exact(3)
                .map(|texel| Vec3::from_array([0, 1, 2].map(|channel| SRGB8_TO_LINEAR[usize::from(texel[channel])])))
                .collect(),
            Texels::Linear(colours) => colours.clone(),
        };
        Raster::from_pixels(self.width(), self.height(), pixels)
    }
}
