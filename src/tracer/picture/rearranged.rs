//! Pictures in another orientation, and their lossless output.

use super::{Format, OutputFormat, Picture, PngDepth, Samples, Texels, WriteOptions, encode, encode_jpeg, encode_png};
use crate::colour::ToneMap;
use crate::error::Result;

impl Picture {
    /// A square picture of the same texels in other places: `source(x, y)` tells where the texel in column `x` and row
    /// `y` comes from.
    pub fn rearranged(&self, source: impl Fn(usize, usize) -> (usize, usize)) -> Self {
        let (width, height) = (self.width(), self.height());
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| source(x, y));
        let indices = places.map(|(x, y)| y * width + x);
        let texels = match self.texels() {
            Texels::Srgb8(bytes) => {
                Texels::Srgb8(indices.flat_map(|at| [bytes[3 * at], bytes[3 * at + 1], bytes[3 * at + 2]]).collect())
            }
            Texels::Linear(colours) => Texels::Linear(indices.map(|at| colours[at]).collect()),
        };
        Self::new(self.header(), texels)
    }

    /// The picture as a file. Where the format holds bytes, those of an 8-bit picture stay as they are.
    pub fn encode_as(&self, format: OutputFormat, options: &WriteOptions) -> Result<Vec<u8>> {
        let (width, height) = (self.width(), self.height());
        match (self.texels(), format) {
            (Texels::Srgb8(bytes), OutputFormat::Png) if options.png_depth == PngDepth::Eight => {
                encode_png(width, height, Samples::Rgb8(bytes))
            }
            (Texels::Srgb8(bytes), OutputFormat::Jpeg) => encode_jpeg(width, height, bytes, options.jpeg_quality),
            _ => encode(&self.to_raster(), format, options),
        }
    }

    /// The picture as a file without loss, and the extension of that file: PNG of 8 or 16 bits, OpenEXR for floats.
    pub fn encode_lossless(&self) -> Result<(Vec<u8>, &'static str)> {
        let header = self.header();
        if let Texels::Srgb8(bytes) = self.texels() {
            return Ok((encode_png(header.width, header.height, Samples::Rgb8(bytes))?, "png"));
        }
        let floats = matches!(header.format, Format::Hdr | Format::Exr) || header.bit_depth > 16;
        let (format, extension) = if floats { (OutputFormat::Exr, "exr") } else { (OutputFormat::Png, "png") };
        let options =
            WriteOptions { tone_map: ToneMap::Clamp, png_depth: PngDepth::Sixteen, ..WriteOptions::default() };
        Ok((encode(&self.to_raster(), format, &options)?, extension))
    }
}
