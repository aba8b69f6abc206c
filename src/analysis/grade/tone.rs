//! Compensation of gamma and exposure: the monotonic curve that brings one picture nearest to another.
//!
//! Isotonic regression over bins of equal count (Ayer et al., An Empirical Distribution Function for Sampling with
//! Incomplete Information, 1955: pool adjacent violators), interpolated linearly between the bins' means. All channels
//! share one curve. Clipped values lie on a flat end of it.

/// Bins of a curve.
const BINS: usize = 24;

/// The values of a picture sorted into bins.
#[derive(Debug, Clone)]
pub(super) struct Levels {
    values: Vec<f32>,
    /// The bin of each value.
    bins: Vec<u8>,
    /// Mean value and count of each bin.
    means: Vec<(f32, f32)>,
}

impl Levels {
    pub fn new(values: &[f32]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_unstable_by(f32::total_cmp);
        let mut edges: Vec<f32> = (1..BINS).map(|bin| sorted[bin * sorted.len() / BINS]).collect();
        edges.dedup();
        let bins: Vec<u8> = values.iter().map(|&value| edges.partition_point(|&edge| edge <= value) as u8).collect();
        let mut sums = vec![(0.0_f64, 0.0_f64); edges.len() + 1];
        for (&bin, &value) in bins.iter().zip(values) {
            sums[usize::from(bin)].0 += f64::from(value);
            sums[usize::from(bin)].1 += 1.0;
        }
        let means = sums.iter().map(|&(sum, count)| ((sum / count.max(1.0)) as f32, count as f32)).collect();
        Self { values: values.to_vec(), bins, means }
    }

    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// The picture brought nearest to `target` by a curve: what `target` would be. `source[i]` is the cell of this picture
    /// that stands where the cell `i` of `target` does.
    pub fn fitted(&self, source: &[u32], target: &[f32]) -> Vec<f32> {
        let mut sums = vec![0.0_f64; self.means.len()];
        for (cell, &from) in source.iter().enumerate() {
            for channel in 0..3 {
                sums[usize::from(self.bins[3 * from as usize + channel])] += f64::from(target[3 * cell + channel]);
            }
        }
        let knots = self.knots(&sums);
        let mut fitted = Vec::with_capacity(target.len());
        for &from in source {
            for index in 3 * from as usize..3 * from as usize + 3 {
                fitted.push(self.on_curve(&knots, usize::from(self.bins[index]), self.values[index]));
            }
        }
        fitted
    }

    /// The curve's value at each bin's mean, from the sums of the target over the bins.
    fn knots(&self, sums: &[f64]) -> Vec<f32> {
        // Blocks of neighbouring bins: sum, count, bins.
        let mut blocks: Vec<(f64, f64, usize)> = Vec::with_capacity(sums.len());
        for (&sum, &(_, count)) in sums.iter().zip(&self.means) {
            let mut block = (sum, f64::from(count).max(1e-9), 1);
            while let Some(&(before, weight, bins)) = blocks.last() {
                if before * block.1 <= block.0 * weight {
                    break;
                }
                blocks.pop();
                block = (before + block.0, weight + block.1, bins + block.2);
            }
            blocks.push(block);
        }
        blocks.iter().flat_map(|&(sum, count, bins)| std::iter::repeat_n((sum / count) as f32, bins)).collect()
    }

    fn on_curve(&self, knots: &[f32], bin: usize, value: f32) -> f32 {
        let above = value >= self.means[bin].0;
        let (low, high) = if above { (bin, bin + 1) } else { (bin.wrapping_sub(1), bin) };
        if high >= knots.len() || low >= knots.len() {
            return knots[bin];
        }
        let (from, to) = (self.means[low].0, self.means[high].0);
        let share = if to > from { ((value - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        knots[low] + share * (knots[high] - knots[low])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_rising_curve_is_taken_out_and_a_falling_one_is_not() {
        let values: Vec<f32> = (0..3000).map(|k| ((k * 37) % 3000) as f32 / 3000.0).collect();
        let source: Vec<u32> = (0..1000).collect();
        let error = |curve: fn(f32) -> f32| {
            let target: Vec<f32> = values.iter().map(|&value| curve(value)).collect();
            let fitted = Levels::new(&values).fitted(&source, &target);
            fitted.iter().zip(&target).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
        };
        assert!(error(|x| x) < 0.03);
        assert!(error(|x| x * x) < 0.05);
        assert!(error(|x| (1.5 * x).min(1.0)) < 0.05);
        assert!(error(|x| 1.0 - x) > 0.4);
    }
}
