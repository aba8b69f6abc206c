//! When one arrangement fits decisively better than another.

use super::arrangement::{Arrangement, Comparison, Puzzle};

/// Standard errors by which an arrangement must be better.
const STANDARD_ERRORS: f64 = 3.5;
/// The part of the cost that it must save.
const IMPROVEMENT: f64 = 0.12;
/// Nearly nothing is left of the cost: fewer standard errors will do, as where only a few lines cross the borders.
const FEW_STANDARD_ERRORS: f64 = 2.5;
const NEARLY_ALL: f64 = 0.5;

/// In a plain sky only a few coarse coefficients tell one laying from another: those that differ strongly must
/// agree. Least logarithm of the likelihood, least count, and largest part of losses.
const STRONG_GAIN: f64 = 15.0;
const STRONG_COUNT: usize = 6;
const STRONG_LOSS: f64 = 0.12;

/// Coarse ground under strong compression: the costs are better by little, but the patterns along the borders agree in one
/// arrangement alone. No seam tells more than [`super::agreement::MOST`] of it, so two must.
const AGREEMENT: f64 = 10.0;
const SOME_STANDARD_ERRORS: f64 = 0.5;
const SOME_IMPROVEMENT: f64 = 0.03;

impl Comparison {
    /// True if chance does not explain the difference, and it is not a trifle either.
    pub fn is_decisive(&self) -> bool {
        let (errors, improvement) = (self.standard_errors(), self.improvement());
        let (gain, count, loss) = self.strong();
        gain >= STRONG_GAIN && count >= STRONG_COUNT && loss <= STRONG_LOSS
            || errors >= STANDARD_ERRORS && improvement >= IMPROVEMENT
            || errors >= SOME_STANDARD_ERRORS && improvement >= SOME_IMPROVEMENT && self.agreement >= AGREEMENT
            || errors >= FEW_STANDARD_ERRORS && improvement >= NEARLY_ALL
    }
}

impl Puzzle {
    /// True if `other` is as good as `best`, as far as the pixels can tell.
    pub fn ties(&self, best: &Arrangement, other: &Arrangement) -> bool {
        !self.compare(best, other).is_decisive()
    }
}
