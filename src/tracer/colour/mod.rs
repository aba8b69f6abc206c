//! Linear RGB (Rec. 709 primaries), the sRGB encoding of files, and tone mapping.

mod colour_map;
mod srgb;
mod tone_map;

pub use colour_map::magma_bytes;
pub use srgb::{SRGB8_TO_LINEAR, decode_srgb, decode_srgb8, decode_srgb16, encode_srgb, encode_srgb8};
pub use tone_map::{Encoding, ToneMap};

use crate::math::Vec3;

/// Relative luminance of a linear Rec. 709 colour (ITU-R BT.709, section 3.2).
pub fn luminance(colour: Vec3) -> f32 {
    0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z
}
