//! From unbounded radiance to the `[0, 1]` of a display.

use super::{encode_srgb, encode_srgb8, luminance};
use crate::math::Vec3;

/// How radiance above 1 is mapped into range before it is sRGB-encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum ToneMap {
    /// Cut off at 1: values in range stay exact.
    #[default]
    Clamp,
    /// `L / (1 + L)` on the luminance (Reinhard et al., Photographic Tone Reproduction, 2002, eq. 3).
    Reinhard,
}

impl ToneMap {
    /// The sRGB-encoded display colour, each channel in `[0, 1]`, of a linear colour.
    pub fn display(self, colour: Vec3) -> Vec3 {
        self.display_as(colour, Encoding::Srgb)
    }

    /// The display colour under an encoding, each channel in `[0, 1]`.
    pub fn display_as(self, colour: Vec3, encoding: Encoding) -> Vec3 {
        Vec3::from_array(self.in_range(colour).to_array().map(|channel| encoding.code(channel)))
    }

    /// The same as bytes: times 255, rounded.
    pub fn bytes_as(self, colour: Vec3, encoding: Encoding) -> [u8; 3] {
        self.in_range(colour).to_array().map(|channel| match encoding {
            Encoding::Srgb => encode_srgb8(channel),
            Encoding::Linear => (encoding.code(channel) * 255.0).round() as u8,
        })
    }

    /// Linear, and in range but for what the encoding cuts off.
    fn in_range(self, colour: Vec3) -> Vec3 {
        match self {
            ToneMap::Clamp => colour,
            ToneMap::Reinhard => colour / (1.0 + luminance(colour).max(0.0)),
        }
    }
}

/// How 8- and 16-bit files say how much light a number stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum Encoding {
    /// As displays expect it.
    #[default]
    Srgb,
    /// The linear light itself: a mistake, made on purpose by a lesson. Displays show it too dark.
    Linear,
}

impl Encoding {
    /// The code in `[0, 1]` of a linear channel; values outside `[0, 1]` are clamped, NaN gives 0.
    fn code(self, linear: f32) -> f32 {
        match self {
            Encoding::Srgb => encode_srgb(linear),
            Encoding::Linear if linear > 0.0 => linear.min(1.0),
            Encoding::Linear => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_encoding_the_number_is_the_light_in_range() {
        let colour = Vec3::new(0.25, 1.5, f32::NAN);
        assert_eq!(ToneMap::Clamp.display_as(colour, Encoding::Linear), Vec3::new(0.25, 1.0, 0.0));
        assert_eq!(ToneMap::Reinhard.display_as(Vec3::ONE, Encoding::Linear), Vec3::splat(0.5));
    }
}
