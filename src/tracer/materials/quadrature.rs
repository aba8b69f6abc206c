//! Gauss and Legendre's rule, for the averages a material is made with.

use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::math::functions::cos;

/// Places in `(0, 1)` and their weights, which add up to 1.
type Rule<const POINTS: usize> = LazyLock<[(f64, f64); POINTS]>;

static LONG: Rule<16> = LazyLock::new(|| std::array::from_fn(|number| point(number, 16)));
static SHORT: Rule<7> = LazyLock::new(|| std::array::from_fn(|number| point(number, 7)));

/// Integral of a function over `[0, 1]`, exact for polynomials of degree 31.
pub(super) fn integral(function: impl Fn(f64) -> f64) -> f64 {
    LONG.iter().map(|&(place, weight)| weight * function(place)).sum()
}

/// The same for polynomials of degree 13.
pub(super) fn short_integral(function: impl Fn(f64) -> f64) -> f64 {
    SHORT.iter().map(|&(place, weight)| weight * function(place)).sum()
}

/// A zero of the Legendre polynomial by Newton's method (Press et al., Numerical Recipes, section 4.6).
fn point(number: usize, points: usize) -> (f64, f64) {
    let degree = points as f64;
    let mut x = cos(PI * (number as f64 + 0.75) / (degree + 0.5));
    let mut slope = 1.0;
    for _ in 0..8 {
        let (mut value, mut previous) = (x, 1.0);
        for order in 2..=points {
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
        for degree in [0, 1, 7, 30, 31] {
            let found = integral(|x| x.powi(degree));
            assert!((found - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "{degree} {found}");
            let found = short_integral(|x| x.powi(degree));
            assert!(degree > 13 || (found - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "{degree} {found}");
        }
    }
}
