//! Vectors of double-double numbers.

use std::ops::{Add, Mul, Sub};

use super::wide::Wide;
use crate::math::DVec3;

/// Three numbers of about 32 digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WideVector(pub [Wide; 3]);

impl WideVector {
    pub fn dot(self, other: Self) -> Wide {
        let [a, b, c] = [0, 1, 2].map(|axis| self.0[axis] * other.0[axis]);
        a + b + c
    }

    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        Self([b * f - c * e, c * d - a * f, a * e - b * d])
    }

    pub fn length(self) -> Wide {
        self.dot(self).sqrt()
    }
}

impl From<DVec3> for WideVector {
    fn from(vector: DVec3) -> Self {
        Self(vector.to_array().map(Wide::from))
    }
}

impl Add for WideVector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|axis| self.0[axis] + other.0[axis]))
    }
}

impl Sub for WideVector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|axis| self.0[axis] - other.0[axis]))
    }
}

impl Mul<Wide> for WideVector {
    type Output = Self;
    fn mul(self, factor: Wide) -> Self {
        Self(self.0.map(|component| component * factor))
    }
}
