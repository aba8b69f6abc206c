//! The straight line through points of a log-log plot.

use crate::math::functions::logarithm_f64;

/// The slope of the line of least squares through `(log x, log y)`.
///
/// `None` for fewer than two different x, and where a number is not positive and finite.
pub fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let fits = |value: f64| value > 0.0 && value.is_finite();
    if !points.iter().all(|&(x, y)| fits(x) && fits(y)) {
        return None;
    }
    let logarithms: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (logarithm_f64(x), logarithm_f64(y))).collect();
    let count = logarithms.len() as f64;
    let mean_x = logarithms.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = logarithms.iter().map(|(_, y)| y).sum::<f64>() / count;
    let across: f64 = logarithms.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let spread: f64 = logarithms.iter().map(|(x, _)| (x - mean_x) * (x - mean_x)).sum();
    (spread > 0.0).then_some(across / spread)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_have_their_exponents_as_slopes() {
        for exponent in [-1.5, -0.5, 0.0, 2.0] {
            let points: Vec<(f64, f64)> =
                [1.0, 4.0, 16.0, 64.0, 1000.0].map(|x: f64| (x, 0.3 * x.powf(exponent))).to_vec();
            assert!((slope(&points).unwrap() - exponent).abs() < 1e-12);
        }
    }

    #[test]
    fn noise_on_both_sides_cancels() {
        // e^(0, 1, 2) with y = e^(-x) off by factors of e, e^-2, e: the residuals 1, -2, 1 are orthogonal to 1 and x.
        let e = std::f64::consts::E;
        let points = [(1.0, e), (e, (-3.0_f64).exp()), (e * e, (-1.0_f64).exp())];
        assert!((slope(&points).unwrap() + 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_has_no_line_has_no_slope() {
        for points in [&[][..], &[(1.0, 1.0)], &[(2.0, 1.0), (2.0, 3.0)], &[(1.0, 0.0), (2.0, 1.0)]] {
            assert_eq!(slope(points), None);
        }
    }
}
