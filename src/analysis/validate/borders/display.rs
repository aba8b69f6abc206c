//! Display colours, in which steps are measured.
//!
//! 8- and 16-bit files: sRGB-encoded, 0 to 255. Files of unbounded radiance (HDR, OpenEXR): the radiance is divided by
//! its logarithmic mean along all borders, brought into range by `x / (1 + x)` (Reinhard et al., "Photographic Tone
//! Reproduction for Digital Images", 2002) and then encoded alike, so that a lamp counts as white.

use std::sync::LazyLock;

use crate::colour::encode_srgb;
use crate::math::Vec3;
use crate::math::functions::{exponential, logarithm};
use crate::picture::{Format, Header};

/// How linear colours are turned into display units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Display {
    /// Files of 8 bits a channel.
    EightBit,
    /// Files of more bits that are display-referred all the same.
    Deep,
    /// Unbounded radiance, to be multiplied by this first.
    Radiance(f32),
}

/// The codes of linear values on a scale of square roots, which has four entries or more for every code.
static CODE_OF_ROOT: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let code = |index: usize| {
        let root = index as f32 / 1024.0;
        (encode_srgb(root * root) * 255.0).round() as u8
    };
    (0..=1024).map(code).collect()
});

/// True if the files of a format hold unbounded radiance.
pub fn is_radiance(header: Header) -> bool {
    matches!(header.format, Format::Hdr | Format::Exr) || header.bit_depth == 32
}

impl Display {
    /// The encoding of radiance whose samples along the borders are given.
    pub fn of_radiance(samples: impl Iterator<Item = Vec3>) -> Self {
        let (mut sum, mut count) = (0.0_f64, 0_u32);
        for sample in samples {
            let brightness = sample.element_sum() / 3.0;
            if brightness > 1e-6 && brightness.is_finite() {
                sum += f64::from(logarithm(brightness));
                count += 1;
            }
        }
        let mean = exponential((sum / f64::from(count.max(1))) as f32);
        Self::Radiance(1.0 / mean)
    }

    /// Display units, 0 to 255 a channel; what is not a number counts as 0.
    #[inline]
    pub fn encode(self, linear: Vec3) -> [f32; 3] {
        linear.to_array().map(|value| match self {
            Self::EightBit => f32::from(CODE_OF_ROOT[(value.clamp(0.0, 1.0).sqrt() * 1024.0 + 0.5) as usize]),
            Self::Deep => 255.0 * encode_srgb(value),
            Self::Radiance(factor) => {
                let bright = (value.max(0.0) * factor).min(1e6);
                255.0 * encode_srgb(bright / (1.0 + bright))
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::SRGB8_TO_LINEAR;

    #[test]
    fn eight_bit_codes_come_back_exactly() {
        for (code, &linear) in SRGB8_TO_LINEAR.iter().enumerate() {
            assert_eq!(Display::EightBit.encode(Vec3::splat(linear)), [code as f32; 3]);
        }
    }

    #[test]
    fn radiance_is_bounded_and_its_mean_is_in_the_middle() {
        let display = Display::of_radiance([Vec3::splat(8.0), Vec3::splat(2.0)].into_iter());
        let middle = 255.0 * encode_srgb(0.5);
        assert!((display.encode(Vec3::splat(4.0))[0] - middle).abs() < 0.01);
        assert!(display.encode(Vec3::splat(f32::INFINITY))[0] <= 255.0);
        assert_eq!(display.encode(Vec3::splat(f32::NAN)), [0.0; 3]);
    }
}
