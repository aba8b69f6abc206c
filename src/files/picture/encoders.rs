//! Encoding of samples as JPEG and HDR.

use image::codecs::hdr::HdrEncoder;
use image::codecs::jpeg::JpegEncoder;
use image::{ExtendedColorType, ImageError};

use crate::error::{Error, Result};

/// A JPEG file of three sRGB-encoded bytes per pixel, row by row from the top. `quality` is from 1 (small) to 100 (good).
pub fn encode_jpeg(width: usize, height: usize, bytes: &[u8], quality: u8) -> Result<Vec<u8>> {
    let (Ok(columns), Ok(rows)) = (u16::try_from(width), u16::try_from(height)) else {
        return Err(Error::new(format!("{width} x {height} is too large for JPEG"))
            .expected("at most 65535 x 65535")
            .help("write it as .png or .exr"));
    };
    if !(1..=100).contains(&quality) {
        return Err(Error::new(format!("JPEG quality {quality}")).expected("from 1 to 100"));
    }
    let mut encoded = Vec::new();
    JpegEncoder::new_with_quality(&mut encoded, quality)
        .encode(bytes, u32::from(columns), u32::from(rows), ExtendedColorType::Rgb8)
        .map_err(|error| cannot_encode("JPEG", &error))?;
    Ok(encoded)
}

/// An HDR (RGBE) file of linear pixels, row by row from the top.
pub fn encode_hdr(width: usize, height: usize, pixels: impl Iterator<Item = [f32; 3]>) -> Result<Vec<u8>> {
    let pixels: Vec<_> = pixels.map(image::Rgb).collect();
    let mut encoded = Vec::new();
    HdrEncoder::new(&mut encoded).encode(&pixels, width, height).map_err(|error| cannot_encode("HDR", &error))?;
    Ok(encoded)
}

fn cannot_encode(format: &str, error: &ImageError) -> Error {
    Error::new(format!("cannot encode as {format}: {error}"))
}
