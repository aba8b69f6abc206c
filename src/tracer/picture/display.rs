//! Pictures for drawings: four bytes per pixel, red, green, blue and opacity.

use super::Raster;
use crate::colour::{Encoding, ToneMap};

/// The bytes of a raster as it is displayed, sRGB-encoded and opaque, row by row from the top.
pub fn display_bytes(raster: &Raster, tone_map: ToneMap) -> Vec<u8> {
    let pixel = |&colour| {
        let [red, green, blue] = tone_map.bytes_as(colour, Encoding::Srgb);
        [red, green, blue, 255]
    };
    raster.pixels().iter().flat_map(pixel).collect()
}

/// Red, green and blue of every four bytes.
pub fn without_opacity(bytes: &[u8]) -> Vec<u8> {
    bytes.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    #[test]
    fn bytes_are_encoded_and_opaque() {
        let raster = Raster::from_pixels(2, 1, vec![Vec3::new(0.0, 0.5, 2.0), Vec3::ONE]);
        let bytes = display_bytes(&raster, ToneMap::Clamp);
        assert_eq!(bytes, [0, 188, 255, 255, 255, 255, 255, 255]);
        assert_eq!(without_opacity(&bytes), [0, 188, 255, 255, 255, 255]);
    }
}
