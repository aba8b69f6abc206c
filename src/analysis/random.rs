//! Pseudo-random numbers, the same on every machine.

use crate::math::DVec3;

/// SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014).
#[derive(Debug, Clone)]
pub struct Random(pub u64);

impl Random {
    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in the unit ball, not at its centre.
    pub fn in_ball(&mut self) -> DVec3 {
        loop {
            let point = DVec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0;
            if point.length_squared() <= 1.0 && point.length_squared() > 1e-6 {
                return point;
            }
        }
    }

    /// Uniform on the unit sphere.
    pub fn direction(&mut self) -> DVec3 {
        self.in_ball().normalize()
    }

    /// One of `0..count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }

    /// A power of ten from `10^low` to `10^high`.
    pub fn decade(&mut self, low: i32, high: i32) -> f64 {
        power_of_ten(low + self.below((high - low + 1) as usize) as i32)
    }
}

/// `10^exponent`, correctly rounded.
pub fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().expect("a number")
}
