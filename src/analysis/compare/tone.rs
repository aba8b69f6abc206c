//! The changes to the tones of a picture before it is written.

use crate::math::Vec3;
use crate::math::functions::power;

/// What stands between the light and the numbers of the file, besides the sRGB encoding it should be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Curve {
    /// sRGB-encoded, as it should be.
    AsExpected,
    /// The linear values are in the file: the encoding is missing.
    NotEncoded,
    /// Encoded twice.
    EncodedTwice,
    /// Encoded by the power 1/2.2 in place of the sRGB curve.
    PlainGamma,
    /// The light is raised to this power, and then encoded.
    Power(f32),
}

/// How the tones of mine came from those of the expected picture: `mine = curve(exposure * expected)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tone {
    pub curve: Curve,
    /// How many times as bright mine is.
    pub exposure: f32,
    /// Red stands where blue belongs, and blue where red.
    pub red_blue_swapped: bool,
}

impl Tone {
    /// Nothing is done.
    pub const AS_EXPECTED: Self = Self { curve: Curve::AsExpected, exposure: 1.0, red_blue_swapped: false };

    /// The light that a colour of mine, read as it stands, was made from.
    pub fn undone(&self, colour: Vec3) -> Vec3 {
        let colour = if self.red_blue_swapped { Vec3::new(colour.z, colour.y, colour.x) } else { colour };
        if self.curve == Curve::AsExpected && self.exposure == 1.0 {
            return colour;
        }
        Vec3::from_array(colour.to_array().map(|channel| self.curve.undone(channel))) / self.exposure
    }
}

impl Curve {
    /// The light behind a channel that was decoded as sRGB. Negative values are 0.
    pub fn undone(self, linear: f32) -> f32 {
        let linear = if linear > 0.0 { linear } else { 0.0 };
        match self {
            Curve::AsExpected => linear,
            Curve::NotEncoded => encoded(linear),
            Curve::EncodedTwice => decoded(linear),
            Curve::PlainGamma => power(encoded(linear), 2.2),
            Curve::Power(exponent) => power(linear, 1.0 / exponent),
        }
    }
}

/// The sRGB encoding, continued above 1.
fn encoded(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * power(linear, 1.0 / 2.4) - 0.055 }
}

/// Its inverse, continued above 1.
pub(super) fn decoded(encoded: f32) -> f32 {
    if encoded <= 0.04045 { encoded / 12.92 } else { power((encoded + 0.055) / 1.055, 2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undoes_what_students_do() {
        for step in 1..20 {
            let light = step as f32 / 19.0;
            let mistakes = [
                // The file holds the light itself; reading decodes it once.
                (Curve::NotEncoded, decoded(light)),
                (Curve::EncodedTwice, encoded(light)),
                (Curve::PlainGamma, decoded(power(light, 1.0 / 2.2))),
                (Curve::Power(1.4), power(light, 1.4)),
            ];
            for (curve, read) in mistakes {
                assert!((curve.undone(read) - light).abs() < 1e-5, "{curve:?} {light} {}", curve.undone(read));
            }
        }
    }
}
