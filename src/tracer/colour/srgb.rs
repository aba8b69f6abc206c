//! The sRGB transfer function of 8- and 16-bit files (IEC 61966-2-1).

use std::sync::LazyLock;

use crate::math::Vec3;
use crate::math::functions::power;

/// Linear light of every 8-bit sRGB code, computed at compile time.
pub static SRGB8_TO_LINEAR: [f32; 256] = srgb8_table();

/// The linear colour of three 8-bit sRGB codes, by table.
#[inline(always)]
pub fn decode_srgb8(codes: [u8; 3]) -> Vec3 {
    Vec3::new(
        SRGB8_TO_LINEAR[usize::from(codes[0])],
        SRGB8_TO_LINEAR[usize::from(codes[1])],
        SRGB8_TO_LINEAR[usize::from(codes[2])],
    )
}

/// Linear light of every 16-bit sRGB code, computed when the first 16-bit file is read.
static SRGB16_TO_LINEAR: LazyLock<Vec<f32>> =
    LazyLock::new(|| (0..=u16::MAX).map(|code| decode_srgb(f64::from(code) / 65535.0) as f32).collect());

/// The linear value of a 16-bit sRGB code, by table.
pub fn decode_srgb16(code: u16) -> f32 {
    SRGB16_TO_LINEAR[usize::from(code)]
}

/// The sRGB-encoded value in `[0, 1]` of a linear channel; values outside `[0, 1]` are clamped, NaN gives 0.
pub fn encode_srgb(linear: f32) -> f32 {
    let linear = if linear > 0.0 { linear.min(1.0) } else { 0.0 };
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * power(linear, 1.0 / 2.4) - 0.055 }
}

/// The 8-bit code of a linear channel: [`encode_srgb`] times 255, rounded.
///
/// The power in the encoding takes longer than all else; it is computed only where it decides between two codes.
pub fn encode_srgb8(linear: f32) -> u8 {
    let code = BETWEEN_CODES.partition_point(|&between| between <= linear);
    let close = |index: usize| BETWEEN_CODES.get(index).is_some_and(|between| (linear / between - 1.0).abs() < 1e-4);
    if close(code) || code > 0 && close(code - 1) {
        return (encode_srgb(linear) * 255.0).round() as u8;
    }
    code as u8
}

/// Linear light halfway between each 8-bit code and the next.
static BETWEEN_CODES: [f32; 255] = {
    let mut between = [0.0; 255];
    let mut code = 0;
    while code < 255 {
        between[code] = decode_srgb((code as f64 + 0.5) / 255.0) as f32;
        code += 1;
    }
    between
};

/// The linear value of an sRGB-encoded channel in `[0, 1]`.
pub const fn decode_srgb(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        return encoded / 12.92;
    }
    // x^2.4 = x^2 * fifth root of x^2, the root by Newton's method from above, where it converges monotonically.
    let base = (encoded + 0.055) / 1.055;
    let square = base * base;
    let mut root = 1.0_f64;
    let mut step = 0;
    while step < 64 {
        let fourth = root * root * root * root;
        root -= (root * fourth - square) / (5.0 * fourth);
        step += 1;
    }
    square * root
}

const fn srgb8_table() -> [f32; 256] {
    let mut table = [0.0; 256];
    let mut code = 0;
    while code < 256 {
        table[code] = decode_srgb(code as f64 / 255.0) as f32;
        code += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_follows_the_standard() {
        for (code, &linear) in SRGB8_TO_LINEAR.iter().enumerate() {
            let encoded = code as f64 / 255.0;
            let exact = if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) };
            assert!((f64::from(linear) - exact).abs() <= 1e-7 * exact, "code {code}: {linear} against {exact}");
        }
    }

    #[test]
    fn every_code_survives_decoding_and_encoding() {
        for (code, &linear) in SRGB8_TO_LINEAR.iter().enumerate() {
            assert_eq!((encode_srgb(linear) * 255.0).round() as usize, code);
        }
    }

    #[test]
    fn every_16_bit_code_survives_decoding_and_encoding() {
        for code in 0..=u16::MAX {
            assert_eq!((encode_srgb(decode_srgb16(code)) * 65535.0).round() as u16, code);
        }
        assert_eq!(decode_srgb16(257 * 188), SRGB8_TO_LINEAR[188]);
    }

    #[test]
    fn codes_are_rounded_encodings() {
        let rounded = |linear: f32| (encode_srgb(linear) * 255.0).round() as u8;
        let special = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, -0.0, 0.0, 1e-40, 1.0, 1.0_f32.next_up(), 9e9];
        // All floats at the ends of the range in which the power decides, and many in the middle of it and elsewhere.
        let near = BETWEEN_CODES.iter().flat_map(|between| {
            let around = |linear: f32| (0..64).map(move |step| f32::from_bits(linear.to_bits() - 32 + step));
            around(between * 0.9999).chain(around(*between)).chain(around(between * 1.0001))
        });
        let even = (0..100_000).map(|step| step as f32 * 1.1e-5);
        for linear in special.into_iter().chain(near).chain(even) {
            assert_eq!(encode_srgb8(linear), rounded(linear), "{linear}");
        }
    }

    #[test]
    fn encoding_clamps_and_swallows_nan() {
        assert_eq!(encode_srgb(f32::NAN), 0.0);
        assert_eq!(encode_srgb(-1.0), 0.0);
        assert_eq!(encode_srgb(f32::INFINITY), encode_srgb(1.0));
        assert!((encode_srgb(1.0) - 1.0).abs() < 1e-6);
    }
}
