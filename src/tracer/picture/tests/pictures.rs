//! Small pictures that the tests share.

use crate::colour::SRGB8_TO_LINEAR;
use crate::math::Vec3;
use crate::picture::{Format, Header, Picture, Raster, Texels};

/// Bytes of an RGB picture in which no two texels, rows or channels are alike.
pub fn rgb8_bytes(width: usize, height: usize) -> Vec<u8> {
    (0..width * height * 3).map(|index| ((index * 37 + index / 11 * 5) % 256) as u8).collect()
}

/// A smooth raster of display colours, kind to lossy formats.
pub fn smooth(width: usize, height: usize) -> Raster {
    Raster::from_function(width, height, |x, y| {
        let (u, v) = (x as f32 / width as f32, y as f32 / height as f32);
        Vec3::new(0.1 + 0.8 * u, 0.9 - 0.7 * v, 0.2 + 0.3 * u * v)
    })
}

/// A raster of radiance over a wide range, as only float files hold it.
pub fn radiant(width: usize, height: usize) -> Raster {
    Raster::from_function(width, height, |x, y| {
        Vec3::new(0.001 * (x + 1) as f32, 1.7 * (y + 1) as f32, 1000.0 / (x + y + 1) as f32)
    })
}

/// A picture of 8-bit texels.
pub fn srgb8(width: usize, height: usize, bytes: Vec<u8>) -> Picture {
    let header = Header { width, height, format: Format::Png, bit_depth: 8, alpha: false };
    Picture::new(header, Texels::Srgb8(bytes))
}

/// The bytes of a picture of 8-bit texels.
pub fn bytes_of(picture: &Picture) -> &[u8] {
    match picture.texels() {
        Texels::Srgb8(bytes) => bytes,
        Texels::Linear(_) => panic!("expected 8-bit texels, found linear ones"),
    }
}

/// The colours of a picture of float texels.
pub fn colours_of(picture: &Picture) -> &[Vec3] {
    match picture.texels() {
        Texels::Linear(colours) => colours,
        Texels::Srgb8(_) => panic!("expected linear texels, found 8-bit ones"),
    }
}

/// The linear grey of an 8-bit code.
pub fn grey(code: u8) -> Vec3 {
    Vec3::splat(SRGB8_TO_LINEAR[usize::from(code)])
}
