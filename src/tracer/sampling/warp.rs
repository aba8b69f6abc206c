//! Warps of uniform numbers to points on discs and indices among weights.

use crate::math::DVec2;
use crate::math::functions::sin_cos_turns;

/// A point of the unit disc, uniform by area; squares become discs with little distortion, so that well-spread points
/// stay well spread (Shirley and Chiu, A Low Distortion Map Between Disk and Square, 1997).
#[inline]
pub fn concentric_disc([a, b]: [f64; 2]) -> DVec2 {
    let (x, y) = (2.0 * a - 1.0, 2.0 * b - 1.0);
    if x == 0.0 && y == 0.0 {
        return DVec2::ZERO;
    }
    // Radius and angle in the quarter of the square that the point lies in.
    let (radius, eighths) = if x.abs() > y.abs() { (x, y / x) } else { (y, 2.0 - x / y) };
    let (sine, cosine) = sin_cos_turns(eighths / 8.0);
    DVec2::new(radius * cosine, radius * sine)
}

/// The index of the weight, of `count` in a row, that a number falls into, and the position in it; the last index for
/// numbers beyond all.
#[inline(always)]
pub fn among_weights(count: usize, weight: impl Fn(usize) -> f64, number: f64) -> (usize, f64) {
    let (mut chosen, mut left) = (0, number);
    while chosen + 1 < count && left >= weight(chosen) {
        left -= weight(chosen);
        chosen += 1;
    }
    (chosen, left)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means over a fine grid of the unit square, right to 1e-4 for values with kinks along the diagonals.
    fn mean(value: impl Fn([f64; 2]) -> f64) -> f64 {
        let count = 400;
        let middle = |index: usize| (index as f64 + 0.5) / count as f64;
        let sum: f64 = (0..count * count).map(|index| value([middle(index % count), middle(index / count)])).sum();
        sum / (count * count) as f64
    }

    #[test]
    fn the_disc_has_the_moments_of_a_uniform_one() {
        // E[x] = 0, E[x^2] = 1/4, E[r^4] = 1/3, and a quarter of the area within half the radius.
        assert!(mean(|place| concentric_disc(place).x).abs() < 1e-9);
        assert!((mean(|place| concentric_disc(place).x.powi(2)) - 0.25).abs() < 1e-4);
        assert!((mean(|place| concentric_disc(place).length_squared().powi(2)) - 1.0 / 3.0).abs() < 1e-4);
        assert!((mean(|place| f64::from(concentric_disc(place).length() < 0.5)) - 0.25).abs() < 1e-3);
    }
}
