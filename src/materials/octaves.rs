//! Where the nodes of a table over the cosine lie.
//!
//! What a surface of roughness alpha loses changes over cosines of the order of alpha: nodes are evenly spaced in every
//! octave of `1 + mu / alpha`, so that there are as many near grazing view as there must be. The octave and the cell in
//! it are read off the exponent and the first bits of the mantissa: no logarithm is computed.

/// Bits of the mantissa of an `f64`.
const MANTISSA: u32 = 52;
/// The bits of 1.0.
const ONE: u64 = 1.0_f64.to_bits();

/// Cells over the cosines `[0, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Octaves {
    /// Not more than the roughness, such that the cosine 1 is the end of an octave.
    scale: f64,
    inverse_scale: f64,
    /// Mantissa bits that number the cells of an octave.
    bits: u32,
    count: u32,
}

impl Octaves {
    /// At least `count` cells.
    pub fn new(roughness: f64, count: u32) -> Self {
        let mut octaves = 1;
        while ((1_u64 << octaves) - 1) as f64 * roughness < 1.0 {
            octaves += 1;
        }
        let bits = count.div_ceil(octaves).next_power_of_two().trailing_zeros();
        let inverse_scale = ((1_u64 << octaves) - 1) as f64;
        Self { scale: 1.0 / inverse_scale, inverse_scale, bits, count: octaves << bits }
    }

    /// How many cells there are.
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// The cosine at the lower end of a cell; `count` gives 1.
    pub fn node(&self, cell: usize) -> f64 {
        let bits = ONE + ((cell as u64) << (MANTISSA - self.bits));
        ((f64::from_bits(bits) - 1.0) * self.scale).min(1.0)
    }

    /// The cell of a cosine in `[0, 1]` and the place in it, in `[0, 1]`.
    #[inline]
    pub fn find(&self, cosine: f64) -> (usize, f64) {
        let past_one = (1.0 + cosine * self.inverse_scale).to_bits() - ONE;
        let shift = MANTISSA - self.bits;
        let cell = (past_one >> shift) as usize;
        if cell >= self.count as usize {
            return (self.count as usize - 1, 1.0);
        }
        let rest = past_one & ((1 << shift) - 1);
        (cell, rest as f64 * (1.0 / (1_u64 << shift) as f64))
    }
}
