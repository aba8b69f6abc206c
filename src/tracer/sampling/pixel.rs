//! Samples of one pixel.

use super::PixelFilter;

/// The sampler: the source of the numbers that drive a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum SamplerKind {
    /// Owen-scrambled Sobol points: evenly spread, so that the error falls faster than that of random numbers.
    #[default]
    Sobol,
    /// Random numbers, each independent of all others.
    Independent,
}

/// How the samples of a picture are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sampling {
    /// Where the random numbers of a sample come from.
    pub sampler: SamplerKind,
    /// How samples near a pixel count for it.
    pub filter: PixelFilter,
    /// Another seed gives another, independent picture of the same scene.
    pub seed: u32,
}

/// The samples of one pixel: Owen-scrambled Sobol points (Burley, Practical Hash-based Owen Scrambling, JCGT 2020),
/// a different scramble for every pixel, or independent numbers.
///
/// Numbers are handed out one by one or four at a time; four at a time are the coordinates of one well-spread point in
/// four dimensions and cost little more than one.
#[derive(Debug, Clone, Copy)]
pub struct PixelSampler {
    kind: SamplerKind,
    seed: u32,
    index: u32,
    dimension: u32,
}

impl PixelSampler {
    /// Sample number `index` of the pixel in column `x` and row `y`, by Sobol points of seed 0.
    #[inline]
    pub fn new(x: usize, y: usize, index: u32) -> Self {
        Self::chosen(Sampling::default(), x, y, index)
    }

    /// Sample number `index` of the pixel in column `x` and row `y`.
    #[inline]
    pub fn chosen(sampling: Sampling, x: usize, y: usize, index: u32) -> Self {
        sampling.row(y, index).pixel(x)
    }

    /// The next coordinate of the sample, uniform in `[0, 1)`.
    #[inline]
    pub fn uniform(&mut self) -> f32 {
        let dimension = self.dimension;
        self.dimension += 1;
        if self.kind == SamplerKind::Independent {
            return self.independent(dimension);
        }
        // The crate has 256 dimensions; beyond them the seed changes, which leaves plain random numbers.
        let block = dimension / sobol_burley::NUM_DIMENSIONS;
        sobol_burley::sample(self.index, dimension % sobol_burley::NUM_DIMENSIONS, self.seed_of(block))
    }

    /// The next four coordinates, from the next whole set of four: the rest of a set already begun is skipped.
    #[inline]
    pub fn four(&mut self) -> [f32; 4] {
        let set = self.dimension.div_ceil(4);
        self.dimension = 4 * set + 4;
        if self.kind == SamplerKind::Independent {
            return std::array::from_fn(|k| self.independent(4 * set + k as u32));
        }
        let (block, set) = (set / sobol_burley::NUM_DIMENSION_SETS_4D, set % sobol_burley::NUM_DIMENSION_SETS_4D);
        sobol_burley::sample_4d(self.index, set, self.seed_of(block))
    }

    fn seed_of(&self, block: u32) -> u32 {
        if block == 0 { self.seed } else { hash(self.seed ^ block) }
    }

    /// A number that depends on pixel, sample and dimension without pattern, in steps of 2^-24.
    fn independent(&self, dimension: u32) -> f32 {
        let bits = hash(hash(self.seed ^ hash(self.index.wrapping_add(0x9e37_79b9))) ^ hash(dimension ^ 0x85eb_ca6b));
        (bits >> 8) as f32 / (1 << 24) as f32
    }
}

/// The same sample of all pixels in a row.
#[derive(Debug, Clone, Copy)]
pub struct RowSampler {
    kind: SamplerKind,
    seed: u32,
    index: u32,
}

impl Sampling {
    /// Sample number `index` of the pixels in row `y`.
    pub fn row(&self, y: usize, index: u32) -> RowSampler {
        // The crate has 2^16 points; each further block of 2^16 gets another scramble.
        let (block, index) = (index >> 16, index & 0xffff);
        let picture = hash(block ^ hash(self.seed));
        RowSampler { kind: self.sampler, seed: hash(y as u32 ^ picture), index }
    }
}

impl RowSampler {
    /// The sample of the pixel in column `x`.
    #[inline]
    pub fn pixel(&self, x: usize) -> PixelSampler {
        PixelSampler { kind: self.kind, seed: hash(x as u32 ^ self.seed), index: self.index, dimension: 0 }
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
                let [across, down, ..] = PixelSampler::new(x, y, index).four();
                columns[(across * 16.0) as usize] += 1;
                rows[(down * 16.0) as usize] += 1;
            }
            assert_eq!((columns, rows), ([1; 16], [1; 16]));
        }
    }

    #[test]
    fn one_by_one_and_four_at_a_time_are_the_same_numbers() {
        for sampler in [SamplerKind::Sobol, SamplerKind::Independent] {
            let sampling = Sampling { sampler, ..Sampling::default() };
            let mut singly = PixelSampler::chosen(sampling, 3, 4, 5);
            let mut by_four = singly;
            for _ in 0..100 {
                assert_eq!(by_four.four(), std::array::from_fn(|_| singly.uniform()));
            }
        }
    }

    #[test]
    fn seeds_give_different_numbers_and_independent_ones_are_uniform() {
        let first = |seed| PixelSampler::chosen(Sampling { seed, ..Sampling::default() }, 1, 2, 3).uniform();
        assert_ne!(first(0), first(1));
        let sampling = Sampling { sampler: SamplerKind::Independent, ..Sampling::default() };
        let count = 100_000;
        let (mut sum, mut products) = (0.0, 0.0);
        for index in 0..count {
            let mut sampler = PixelSampler::chosen(sampling, 7, 9, index);
            let (a, b) = (f64::from(sampler.uniform()), f64::from(sampler.uniform()));
            sum += a;
            products += (a - 0.5) * (b - 0.5);
        }
        let count = f64::from(count);
        // Standard deviations of the means: sqrt(1/12 / n), and 1/12 / sqrt(n).
        assert!((sum / count - 0.5).abs() < 4.0 * (1.0 / 12.0 / count).sqrt());
        assert!((products / count).abs() < 4.0 / 12.0 / count.sqrt());
    }
}
