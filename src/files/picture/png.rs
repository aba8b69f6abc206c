//! PNG files of samples as they stand: drawings, corrected faces.

use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};

use crate::atomic_file::write_atomically;
use crate::error::{Error, Result};

/// Bits per channel of a PNG file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PngDepth {
    /// 8 bits.
    #[default]
    Eight,
    /// 16 bits.
    Sixteen,
}

/// Samples of a picture as a PNG file holds them, sRGB-encoded, row by row from the top left.
#[derive(Debug, Clone, Copy)]
pub enum PngSamples<'a> {
    /// Three bytes per pixel.
    Rgb8(&'a [u8]),
    /// Four bytes per pixel; the alpha is not premultiplied.
    Rgba8(&'a [u8]),
    /// Three 16-bit numbers per pixel.
    Rgb16(&'a [u16]),
}

/// A PNG file of the samples, lossless. An error if they are not `width * height` pixels.
pub fn encode_png(width: usize, height: usize, samples: PngSamples<'_>) -> Result<Vec<u8>> {
    let wide: Vec<u8>;
    let (bytes, colour) = match samples {
        PngSamples::Rgb8(bytes) => (bytes, ExtendedColorType::Rgb8),
        PngSamples::Rgba8(bytes) => (bytes, ExtendedColorType::Rgba8),
        PngSamples::Rgb16(numbers) => {
            wide = numbers.iter().flat_map(|number| number.to_ne_bytes()).collect();
            (wide.as_slice(), ExtendedColorType::Rgb16)
        }
    };
    let expected = width * height * usize::from(colour.bits_per_pixel()) / 8;
    let (Ok(columns), Ok(rows)) = (u32::try_from(width), u32::try_from(height)) else {
        return Err(Error::new(format!("{width} x {height} is too large for PNG")));
    };
    if bytes.len() != expected || expected == 0 {
        return Err(Error::new(format!("{} bytes do not make a picture of {width} x {height} pixels", bytes.len())));
    }
    let mut encoded = Vec::new();
    PngEncoder::new_with_quality(&mut encoded, CompressionType::Fast, FilterType::Adaptive)
        .write_image(bytes, columns, rows, colour)
        .map_err(|error| Error::new(format!("cannot encode as PNG: {error}")))?;
    Ok(encoded)
}

/// Writes a PNG file of the samples, lossless; the extension of `path` does not matter.
pub fn write_png(path: &Path, width: usize, height: usize, samples: PngSamples<'_>) -> Result<()> {
    let encoded = encode_png(width, height, samples).map_err(|error| error.in_file(path))?;
    write_atomically(path, &encoded)
}
