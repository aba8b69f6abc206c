//! Double-double arithmetic: a number as the unevaluated sum of two `f64`, about 32 digits. The reference for the
//! kernels.
//!
//! ```text
//!   high  |======== 53 bits ========|
//!   low                               |======== 53 bits ========|       |low| <= half a unit in the last place of high
//! ```
//!
//! Sums by Knuth's TwoSum (The Art of Computer Programming, volume 2, section 4.2.2), products by Dekker's TwoProduct with
//! Veltkamp's splitting (A Floating-Point Technique for Extending the Available Precision, 1971): additions and
//! multiplications only, so the same on every machine. The operations on pairs are those of Hida, Li and Bailey (Library
//! for Double-Double and Quad-Double Arithmetic, 2007).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of about 32 digits.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Wide {
    high: f64,
    low: f64,
}

/// Sum and its rounding error, exactly.
fn two_sum(a: f64, b: f64) -> Wide {
    let high = a + b;
    let of_b = high - a;
    Wide { high, low: (a - (high - of_b)) + (b - of_b) }
}

/// The same, if `a` is the larger one in absolute value.
fn quick_two_sum(a: f64, b: f64) -> Wide {
    let high = a + b;
    Wide { high, low: b - (high - a) }
}

/// The upper 26 bits and the rest, exactly.
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let spread = SPLITTER * a;
    let high = spread - (spread - a);
    (high, a - high)
}

/// Product and its rounding error, exactly, between 1e-290 and 1e290.
fn two_product(a: f64, b: f64) -> Wide {
    let high = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    Wide { high, low: ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low }
}

impl Wide {
    pub const ZERO: Self = Self { high: 0.0, low: 0.0 };
    pub const ONE: Self = Self { high: 1.0, low: 0.0 };

    /// The nearest `f64`.
    pub fn value(self) -> f64 {
        self.high
    }

    /// The square root; 0 for numbers below 0 (one Newton step on that of `f64`: Karp and Markstein 1997).
    pub fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::ZERO;
        }
        let root = self.high.sqrt();
        let rest = self - two_product(root, root);
        quick_two_sum(root, rest.high / (2.0 * root))
    }

    /// The square.
    pub fn square(self) -> Self {
        self * self
    }

    /// The distance from zero.
    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }
}

impl From<f64> for Wide {
    fn from(number: f64) -> Self {
        Self { high: number, low: 0.0 }
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (sum, rest) = (two_sum(self.high, other.high), two_sum(self.low, other.low));
        let sum = quick_two_sum(sum.high, sum.low + rest.high);
        quick_two_sum(sum.high, sum.low + rest.low)
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.high, other.high);
        quick_two_sum(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * first.into();
        let second = rest.high / other.high;
        let rest = rest - other * second.into();
        Self::from(first) + second.into() + (rest.high / other.high).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_thirty_digits() {
        let third = Wide::ONE / 3.0.into();
        assert!((third * 3.0.into() - Wide::ONE).abs().value() < 1e-31);
        let root = Wide::from(2.0).sqrt();
        assert!((root.square() - 2.0.into()).abs().value() < 1e-31);
        // 1e16 + 1 - 1e16, lost in f64.
        assert_eq!((Wide::from(1e16) + Wide::ONE - 1e16.into()).value(), 1.0);
        // The second half of the square root of 2, to 16 digits: 1.41421356237309504880168872420969807857.
        assert!((root.high - std::f64::consts::SQRT_2).abs() == 0.0);
        assert!((root.low / -9.667_293_313_452_913e-17 - 1.0).abs() < 1e-14);
    }
}
