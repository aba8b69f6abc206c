//! Elementary functions with the same result on every machine.
//!
//! The standard library hands `sin`, `pow` and their kin to the C library of the machine, whose last bit differs from
//! one system to the next. These are computed in software by the `libm` crate, so pictures agree byte for byte.

/// Sine of an angle in radians.
pub fn sin(angle: f64) -> f64 {
    libm::sin(angle)
}

/// Cosine of an angle in radians.
pub fn cos(angle: f64) -> f64 {
    libm::cos(angle)
}

/// Arc cosine in radians, `[0, pi]`; the argument is clamped to `[-1, 1]` first.
pub fn arccos(cosine: f64) -> f64 {
    libm::acos(cosine.clamp(-1.0, 1.0))
}

/// Angle of the point `(x, y)` in radians, `(-pi, pi]`.
pub fn arctan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// `base` raised to `exponent`.
pub fn power(base: f32, exponent: f32) -> f32 {
    libm::powf(base, exponent)
}

/// `e` raised to `exponent`.
pub fn exponential(exponent: f32) -> f32 {
    libm::expf(exponent)
}

/// Natural logarithm.
pub fn logarithm(value: f32) -> f32 {
    libm::logf(value)
}

/// The largest integer that is not above a number; beyond the range of the integers the nearest of them, 0 for NaN.
///
/// A conversion and a comparison, where `f64::floor` is a call of the C library on processors without an instruction
/// for it.
#[inline(always)]
pub fn floor(value: f64) -> i64 {
    let truncated = value as i64;
    truncated.saturating_sub(i64::from(truncated as f64 > value))
}

/// The nearest value in `[low, high]`; NaN gives `low`.
///
/// Compiles to one instruction a side, which `f32::max` and `f32::min` do not, since they treat NaN otherwise.
#[inline(always)]
pub fn clamp_number(value: f32, low: f32, high: f32) -> f32 {
    let above = if value > low { value } else { low };
    if above < high { above } else { high }
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
///
/// A rotation by 90 degrees then maps axes onto axes exactly, which `sin(pi/2 * k)` does not.
pub fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turn = degrees.rem_euclid(360.0);
    match turn {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => (sin(turn.to_radians()), cos(turn.to_radians())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floor_agrees_with_the_standard_library() {
        let large = (1u64 << 62) as f64;
        for value in [
            0.0,
            -0.0,
            0.5,
            -0.5,
            1.0,
            -1.0,
            3.999,
            -3.001,
            1e15 + 0.5,
            -1e15 - 0.5,
            large,
            -large,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
        ] {
            assert_eq!(floor(value), value.floor() as i64, "{value}");
        }
    }

    #[test]
    fn clamping_leaves_a_number_in_range_for_any_input() {
        for value in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, 1e-45, -1e38, 3.0, 7.5] {
            let clamped = clamp_number(value, 0.0, 7.0);
            assert!((0.0..=7.0).contains(&clamped), "{value} {clamped}");
        }
        assert_eq!((clamp_number(f32::NAN, 0.0, 7.0), clamp_number(3.0, 0.0, 7.0)), (0.0, 3.0));
    }
}
