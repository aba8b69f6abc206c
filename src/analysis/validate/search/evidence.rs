//! When one arrangement fits decisively better than another.

use super::super::thresholds::evidence::{
    FEW_STANDARD_ERRORS, IMPROVEMENT, NEARLY_ALL, NOTICEABLE, NOTICEABLE_IMPROVEMENT, SOME_AGREEMENT, SOME_IMPROVEMENT,
    SOME_STANDARD_ERRORS, STANDARD_ERRORS, STRONG_COUNT, STRONG_GAIN, STRONG_LOSS, TOGETHER,
};
use super::arrangement::{Arrangement, Comparison, Problem};

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

    /// True if neither costs nor patterns decide alone, but both point the same way.
    pub fn is_decisive_by_patterns(&self) -> bool {
        let errors = self.standard_errors();
        errors >= SOME_STANDARD_ERRORS
            && self.improvement() >= SOME_IMPROVEMENT
            && self.agreement >= SOME_AGREEMENT
            && self.likelihood() >= TOGETHER
    }

    /// True if the better one fits noticeably better, though perhaps not decisively.
    pub fn is_noticeable(&self) -> bool {
        self.improvement() >= NOTICEABLE_IMPROVEMENT && self.likelihood() >= NOTICEABLE
    }

    /// What the costs and the patterns along the borders tell together: a logarithm of likelihood.
    pub fn likelihood(&self) -> f64 {
        let errors = self.standard_errors();
        errors * errors / 2.0 + self.agreement
    }
}

impl Problem {
    /// True if `other` is as good as `best`, as far as the pixels can tell.
    pub fn ties(&self, best: &Arrangement, other: &Arrangement) -> bool {
        !self.compare(best, other).is_decisive()
    }
}
