//! From unbounded radiance to the `[0, 1]` of a display.

use super::{encode_srgb, luminance};
use crate::math::Vec3;

/// How radiance above 1 is brought into range before it is sRGB-encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum ToneMap {
    /// Cut off at 1: what is in range stays exactly as it is.
    #[default]
    Clamp,
    /// `L / (1 + L)` on the luminance (Reinhard et al., Photographic Tone Reproduction, 2002, eq. 3).
    Reinhard,
}

impl ToneMap {
    /// The sRGB-encoded display colour, each channel in `[0, 1]`, of a linear colour.
    pub fn display(self, colour: Vec3) -> Vec3 {
        let mapped = match self {
            ToneMap::Clamp => colour,
            ToneMap::Reinhard => colour / (1.0 + luminance(colour).max(0.0)),
        };
        Vec3::new(encode_srgb(mapped.x), encode_srgb(mapped.y), encode_srgb(mapped.z))
    }
}
