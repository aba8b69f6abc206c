//! When one arrangement fits decisively better than another.

use super::arrangement::{Arrangement, Comparison, Problem};

/// Standard errors by which an arrangement must be better.
const STANDARD_ERRORS: f64 = 3.5;
/// The part of the cost that it must save.
const IMPROVEMENT: f64 = 0.12;
/// Nearly nothing is left of the cost: fewer standard errors will do, as where only a few lines cross the borders.
const FEW_STANDARD_ERRORS: f64 = 2.5;
const NEARLY_ALL: f64 = 0.5;

/// In a plain sky only a few coarse coefficients tell one orientation from another: those that differ strongly must
/// agree. Least logarithm of the likelihood, least count, and largest part of losses.
const STRONG_GAIN: f64 = 15.0;
const STRONG_COUNT: usize = 6;
const STRONG_LOSS: f64 = 0.12;

/// Coarse ground under strong compression: neither the costs nor the patterns along the borders decide alone, but both point
/// the same way. Logarithms of likelihood of the two together: of n standard errors n^2 / 2, and the agreement. Each
/// must tell something. A clear sky whose turned faces were stored at JPEG quality 50 reaches 0.9 standard errors for a wrong
/// orientation by chance, so the least number of them protects from little: what protects is the agreement, which counts only
/// what two patterns do not have in common ([`super::super::borders::agreement`]), and the sum of both.
const TOGETHER: f64 = 5.5;
const SOME_AGREEMENT: f64 = 3.0;
const SOME_STANDARD_ERRORS: f64 = 0.5;
const SOME_IMPROVEMENT: f64 = 0.03;

impl Comparison {
    /// True if chance does not explain the difference, and it is not a trifle either.
    pub fn is_decisive(&self) -> bool {
        let (errors, improvement) = (self.standard_errors(), self.improvement());
        let (gain, count, loss) = self.strong();
        gain >= STRONG_GAIN && count >= STRONG_COUNT && loss <= STRONG_LOSS
            || errors >= STANDARD_ERRORS && improvement >= IMPROVEMENT
            || self.is_decisive_by_patterns()
            || errors >= FEW_STANDARD_ERRORS && improvement >= NEARLY_ALL
    }

    fn is_decisive_by_patterns(&self) -> bool {
        let errors = self.standard_errors();
        errors >= SOME_STANDARD_ERRORS
            && self.improvement() >= SOME_IMPROVEMENT
            && self.agreement >= SOME_AGREEMENT
            && errors * errors / 2.0 + self.agreement >= TOGETHER
    }
}

impl Problem {
    /// True if `other` is as good as `best`, as far as the pixels can tell.
    pub fn ties(&self, best: &Arrangement, other: &Arrangement) -> bool {
        !self.compare(best, other).is_decisive()
    }
}
