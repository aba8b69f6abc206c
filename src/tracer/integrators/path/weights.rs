//! Weights of several ways to find the same light.

/// What a sample counts that was chosen with one density where another technique would have chosen it with the other: the
/// power heuristic with exponent 2, in `[0, 1]` (Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997,
/// section 9.2.3). The weights of both techniques add up to 1.
#[inline]
pub(super) fn power_heuristic(density: f64, other: f64) -> f32 {
    // Divided through by the density's square, which may overflow.
    let ratio = other / density;
    (1.0 / (1.0 + ratio * ratio)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_of_both_techniques_add_up_to_one() {
        for (a, b) in [(1.0, 1.0), (1e-3, 7.0), (1e200, 1e-200), (3.0, 0.0), (1e300, 1e300)] {
            assert!((power_heuristic(a, b) + power_heuristic(b, a) - 1.0).abs() < 1e-6, "{a} {b}");
        }
    }
}
