//! Where the nodes of a table over the cosine lie.
//!
//! What a surface of roughness alpha loses changes over cosines of the order of alpha, and like `mu log mu` at 0: nodes
//! are evenly spaced in every octave of `1 + sqrt(mu / alpha)`, so that there are as many near grazing view as there must
//! be. The octave and the cell in it are read off the exponent and the first bits of the mantissa: no logarithm is
//! computed.

/// Bits of the mantissa of an `f64`.
const MANTISSA: u32 = 52;
/// The bits of 1.0.
const ONE: u64 = 1.0_f64.to_bits();

/// Cells over the cosines `[0, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Octaves {
    /// Inverse of a number not more than the roughness, so that the cosine 1 is the end of an octave.
    inverse_scale: f64,
    /// Mantissa bits that number the cells of an octave.
    bits: u32,
    count: u32,
}

impl Octaves {
    /// At least `count` cells.
    pub fn new(roughness: f64, count: u32) -> Self {
        let mut octaves = 1;
        while square(((1_u64 << octaves) - 1) as f64) * roughness < 1.0 {
            octaves += 1;
        }
        let bits = count.div_ceil(octaves).next_power_of_two().trailing_zeros();
        Self { inverse_scale: square(((1_u64 << octaves) - 1) as f64), bits, count: octaves << bits }
    }

    /// How many cells there are.
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// The cosine at the lower end of a cell; `count` gives 1.
    pub fn node(&self, cell: usize) -> f64 {
        let bits = ONE + ((cell as u64) << (MANTISSA - self.bits));
        (square(f64::from_bits(bits) - 1.0) / self.inverse_scale).min(1.0)
    }

    /// The cell of a cosine in `[0, 1]` and the place in it, in `[0, 1]`.
    #[inline]
    pub fn find(&self, cosine: f64) -> (usize, f64) {
        let past_one = (1.0 + (cosine * self.inverse_scale).sqrt()).to_bits() - ONE;
        let shift = MANTISSA - self.bits;
        let cell = (past_one >> shift) as usize;
        if cell >= self.count as usize {
            return (self.count as usize - 1, 1.0);
        }
        let rest = past_one & ((1 << shift) - 1);
        (cell, rest as f64 * (1.0 / (1_u64 << shift) as f64))
    }
}

fn square(number: f64) -> f64 {
    number * number
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_follow_one_another_from_0_to_1() {
        for roughness in [1e-4, 0.01, 0.3, 1.0] {
            let octaves = Octaves::new(roughness, 256);
            assert_eq!((octaves.node(0), octaves.node(octaves.count())), (0.0, 1.0));
            for cell in 0..octaves.count() {
                let (low, high) = (octaves.node(cell), octaves.node(cell + 1));
                let (found, place) = octaves.find(0.5 * (low + high));
                assert!(low < high && found == cell && place > 0.4 && place < 0.8, "{cell} {found} {place}");
            }
        }
    }
}
