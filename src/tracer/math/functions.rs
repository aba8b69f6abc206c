//! Elementary functions with the same result on every machine.
//!
//! The standard library delegates `sin`, `pow` and the like to the C library of the machine, whose last bit differs
//! between systems. The `libm` crate computes them in software, so pictures agree byte for byte.

/// Sine of an angle in radians.
pub fn sin(angle: f64) -> f64 {
    libm::sin(angle)
}

/// Cosine of an angle in radians.
pub fn cos(angle: f64) -> f64 {
    libm::cos(angle)
}

/// Sine and cosine of `turns` full turns, `turns` in `[0, 1]`; to 2 units in the last place, faster than those of radians.
///
/// The nearest quarter turn is taken off exactly, the rest (an eighth of a turn at most) goes into the Taylor series,
/// whose first term left out is below 1e-16.
#[inline]
pub fn sin_cos_turns(turns: f64) -> (f64, f64) {
    let quarters = (4.0 * turns + 0.5).floor();
    let angle = (turns - 0.25 * quarters) * std::f64::consts::TAU;
    let square = angle * angle;
    let series =
        |coefficients: &[f64]| coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * square + coefficient);
    const SINE: [f64; 8] = [
        1.0,
        -1.0 / 6.0,
        1.0 / 120.0,
        -1.0 / 5_040.0,
        1.0 / 362_880.0,
        -1.0 / 39_916_800.0,
        1.0 / 6_227_020_800.0,
        -1.0 / 1_307_674_368_000.0,
    ];
    const COSINE: [f64; 9] = [
        1.0,
        -1.0 / 2.0,
        1.0 / 24.0,
        -1.0 / 720.0,
        1.0 / 40_320.0,
        -1.0 / 3_628_800.0,
        1.0 / 479_001_600.0,
        -1.0 / 87_178_291_200.0,
        1.0 / 20_922_789_888_000.0,
    ];
    let (sine, cosine) = (angle * series(&SINE), series(&COSINE));
    match quarters as i32 & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// Arc cosine in radians, `[0, pi]`; the argument is clamped to `[-1, 1]` first.
pub fn arccos(cosine: f64) -> f64 {
    libm::acos(cosine.clamp(-1.0, 1.0))
}

/// Angle of the point `(x, y)` in radians, `(-pi, pi]`.
pub fn arctan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Slopes at which [`arctan2_turns`] starts, from 0 to 1.
const SLOPES: usize = 64;

/// Angles of the slopes `k / SLOPES`, in turns.
static ANGLES: [f64; SLOPES + 1] = angles_of_slopes();

const fn angles_of_slopes() -> [f64; SLOPES + 1] {
    let mut angles = [0.0; SLOPES + 1];
    let mut step = 0;
    while step <= SLOPES {
        // Euler's series: x / (1 + x^2) times the sum of the products of 2n / (2n + 1) * x^2 / (1 + x^2).
        let slope = step as f64 / SLOPES as f64;
        let ratio = slope * slope / (1.0 + slope * slope);
        let (mut sum, mut n) = (1.0, 60);
        while n > 0 {
            sum = 1.0 + sum * ratio * (2 * n) as f64 / (2 * n + 1) as f64;
            n -= 1;
        }
        angles[step] = slope / (1.0 + slope * slope) * sum / std::f64::consts::TAU;
        step += 1;
    }
    angles
}

/// Angle of the point `(x, y)` in turns, `[-1/2, 1/2]`, 0 at the origin; to 1e-16 turns, three times as fast as that in
/// radians. Coordinates are below 1e300; NaN gives NaN.
///
/// ```text
///     |     / the nearest of 64 slopes, its angle by table     tan(a - b) = (tan a - tan b) / (1 + tan a tan b):
///     |    /  . (x, y)                                         the angle that is left is at most 1/128, and the
///     |   / .                                                  first term left out of its series 6e-25
///     |  /.
///     +------------
/// ```
#[inline]
pub fn arctan2_turns(y: f64, x: f64) -> f64 {
    let (across, up) = (x.abs(), y.abs());
    let (small, large) = if up < across { (up, across) } else { (across, up) };
    if large == 0.0 || small.is_nan() {
        return small;
    }
    let step = ((small / large * SLOPES as f64 + 0.5) as usize).min(SLOPES);
    let slope = step as f64 / SLOPES as f64;
    let rest = (small - slope * large) / (large + slope * small);
    let square = rest * rest;
    let series = rest * (1.0 - square * (1.0 / 3.0 - square * (1.0 / 5.0 - square * (1.0 / 7.0 - square / 9.0))));
    let of_octant = ANGLES[step] + series / std::f64::consts::TAU;
    let of_quadrant = if up < across { of_octant } else { 0.25 - of_octant };
    let of_half = if x < 0.0 { 0.5 - of_quadrant } else { of_quadrant };
    if y < 0.0 { -of_half } else { of_half }
}

/// `base` raised to `exponent`.
pub fn power(base: f32, exponent: f32) -> f32 {
    libm::powf(base, exponent)
}

/// `base` raised to `exponent`, in double precision.
pub fn power_f64(base: f64, exponent: f64) -> f64 {
    libm::pow(base, exponent)
}

/// `e` raised to `exponent`.
pub fn exponential(exponent: f32) -> f32 {
    libm::expf(exponent)
}

/// Natural logarithm.
pub fn logarithm(value: f32) -> f32 {
    libm::logf(value)
}

/// Natural logarithm, in double precision.
pub fn logarithm_f64(value: f64) -> f64 {
    libm::log(value)
}

/// `e` raised to `exponent`, in double precision.
pub fn exponential_f64(exponent: f64) -> f64 {
    libm::exp(exponent)
}

/// Logarithm to the base 2.
pub fn binary_logarithm(value: f64) -> f64 {
    libm::log2(value)
}

/// Logarithm to the base 10.
pub fn decimal_logarithm(value: f64) -> f64 {
    libm::log10(value)
}

/// The real cube root.
pub fn cube_root(value: f32) -> f32 {
    libm::cbrtf(value)
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
    fn sine_and_cosine_of_turns_agree_with_those_of_radians() {
        for step in 0..=4096 {
            let turns = f64::from(step) / 4096.0;
            let (sine, cosine) = sin_cos_turns(turns);
            let angle = turns * std::f64::consts::TAU;
            assert!((sine - sin(angle)).abs() < 1e-15 && (cosine - cos(angle)).abs() < 1e-15, "{turns}");
            assert!((sine * sine + cosine * cosine - 1.0).abs() < 4e-16, "{turns}");
        }
        assert_eq!(sin_cos_turns(0.25), (1.0, 0.0));
    }

    #[test]
    fn angles_in_turns_agree_with_those_in_radians() {
        for step in 0..=100_000 {
            let angle = (f64::from(step) / 50_000.0 - 1.0) * std::f64::consts::PI;
            let (y, x) = (3.0 * sin(angle), 3.0 * cos(angle));
            let expected = arctan2(y, x) / std::f64::consts::TAU;
            assert!((arctan2_turns(y, x) - expected).abs() < 1.2e-16, "{angle}: {}", arctan2_turns(y, x) - expected);
        }
        assert_eq!([(0.0, 1.0), (1.0, 0.0), (-1.0, 0.0)].map(|(y, x)| arctan2_turns(y, x)), [0.0, 0.25, -0.25]);
        assert_eq!([(0.0, -1.0), (0.0, 0.0), (1e300, 1e300)].map(|(y, x)| arctan2_turns(y, x)), [0.5, 0.0, 0.125]);
        for (y, x) in [(f64::NAN, 1.0), (1.0, f64::NAN), (0.0, f64::NAN), (f64::NAN, 0.0)] {
            assert!(arctan2_turns(y, x).is_nan(), "{y} {x}");
        }
    }

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
