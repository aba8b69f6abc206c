//! Gauss and Legendre's rule, for the averages a material is made with.

use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::math::functions::cos;

/// Points of the rule: exact for polynomials of degree 63.
const POINTS: usize = 32;

/// Places in `(0, 1)` and their weights, which add up to 1.
pub(super) static GAUSS_LEGENDRE: LazyLock<[(f64, f64); POINTS]> = LazyLock::new(|| std::array::from_fn(point));

/// Integral of a function over `[0, 1]`.
pub(super) fn integral(function: impl Fn(f64) -> f64) -> f64 {
    GAUSS_LEGENDRE.iter().map(|&(place, weight)| weight * function(place)).sum()
}

/// A zero of the Legendre polynomial by Newton's method (Press et al., Numerical Recipes, section 4.6).
fn point(number: usize) -> (f64, f64) {
    let degree = POINTS as f64;
    let mut x = cos(PI * (number as f64 + 0.75) / (degree + 0.5));
    let mut slope = 1.0;
    for _ in 0..8 {
        let (mut value, mut previous) = (x, 1.0);
        for order in 2..=POINTS {
            let order = order as f64;
            (value, previous) = (((2.0 * order - 1.0) * x * value - (order - 1.0) * previous) / order, value);
        }
        slope = degree * (x * value - previous) / (x * x - 1.0);
        x -= value / slope;
    }
    (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrates_polynomials_exactly() {
        for degree in [0, 1, 7, 30, 63] {
            let found = integral(|x| x.powi(degree));
            assert!((found - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "{degree} {found}");
        }
    }
}
