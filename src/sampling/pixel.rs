//! Samples of one pixel.

/// The samples of one pixel: Owen-scrambled Sobol points (Burley, Practical Hash-based Owen Scrambling, JCGT 2020),
/// a different scramble for every pixel.
#[derive(Debug, Clone, Copy)]
pub struct PixelSampler {
    seed: u32,
    index: u32,
    dimension: u32,
}

impl PixelSampler {
    /// Sample number `index` of the pixel in column `x` and row `y`.
    #[inline]
    pub fn new(x: usize, y: usize, index: u32) -> Self {
        // The crate has 2^16 points; each further block of as many gets a scramble of its own.
        let (block, index) = (index >> 16, index & 0xffff);
        Self { seed: hash(x as u32 ^ hash(y as u32 ^ hash(block))), index, dimension: 0 }
    }

    /// The next coordinate of the sample, uniform in `[0, 1)`.
    #[inline]
    pub fn uniform(&mut self) -> f32 {
        let dimension = self.dimension;
        self.dimension += 1;
        // The crate has 256 dimensions; beyond them the seed changes, which leaves plain random numbers.
        let block = dimension / sobol_burley::NUM_DIMENSIONS;
        let seed = if block == 0 { self.seed } else { hash(self.seed ^ block) };
        sobol_burley::sample(self.index, dimension % sobol_burley::NUM_DIMENSIONS, seed)
    }

    /// A place in the pixel, `[0, 1) x [0, 1)`; its middle if the pixel has one sample only.
    #[inline]
    pub fn place(&mut self, samples: u32) -> [f64; 2] {
        if samples == 1 {
            return [0.5, 0.5];
        }
        [f64::from(self.uniform()), f64::from(self.uniform())]
    }
}

/// Scrambles the bits of a number (the finaliser of MurmurHash3).
#[inline]
fn hash(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x85eb_ca6b);
    bits ^= bits >> 13;
    bits = bits.wrapping_mul(0xc2b2_ae35);
    bits ^ (bits >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sixteen_samples_are_stratified_in_both_coordinates() {
        for (x, y) in [(0, 0), (17, 5), (639, 479)] {
            let mut columns = [0; 16];
            let mut rows = [0; 16];
            for index in 0..16 {
                let [across, down] = PixelSampler::new(x, y, index).place(16);
                columns[(across * 16.0) as usize] += 1;
                rows[(down * 16.0) as usize] += 1;
            }
            assert_eq!((columns, rows), ([1; 16], [1; 16]));
        }
    }
}
