//! Sampling of an index in proportion to weights, by inversion of their running sum.
//!
//! ```text
//!   start  0    s1      s2 s3            2^32 - 1      The point `place` of the line belongs to one part; the
//!          |-----|-------|--|---------------|          wider the part, the likelier it is. Neighbouring places
//!             0      1     2     ^  3                  stay neighbours: strata are kept, which an alias
//!                              place                   table would destroy.
//! ```
//!
//! The running sum consists of integers: the reported probability is then exactly the sampled one, on any machine, and
//! every part of positive weight is at least one unit wide, so that a bright cell is always reachable, even beside a
//! much brighter one.

/// Length of the line, in units.
const UNITS: u32 = u32::MAX;

/// The parts of a line, and where to start looking for the one a place is in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Inversion<'a> {
    /// Starts of the parts and the end of the last.
    starts: &'a [u32],
    /// For each of `2^k` equal stretches of the line the part that its first unit is in, and the number of the last
    /// part (Chen and Asau, On Generating Random Variates from an Empirical Distribution, 1974: "guide table").
    guide: &'a [u16],
}

/// How many starts `parts` parts have.
pub(super) fn starts_length(parts: usize) -> usize {
    parts + 1
}

/// How many entries the guide of `parts` parts has.
pub(super) fn guide_length(parts: usize) -> usize {
    parts.next_power_of_two() + 1
}

/// Computes starts and guide, of the lengths told above, and returns the sum of the weights. If that is 0 the line has
/// no parts and must not be drawn from. At most 65536 weights, none negative.
pub(super) fn prepare(weights: impl Iterator<Item = f64> + Clone, starts: &mut [u32], guide: &mut [u16]) -> f64 {
    let sum: f64 = weights.clone().sum();
    starts.fill(0);
    if sum <= 0.0 {
        return 0.0;
    }
    // One unit for each part of positive weight, the rest in proportion.
    let positive = weights.clone().filter(|&weight| weight > 0.0).count();
    let free = f64::from(UNITS) - positive as f64;
    let (mut so_far, mut given) = (0.0, 0);
    for (start, weight) in starts[1..].iter_mut().zip(weights) {
        so_far += weight;
        given += u32::from(weight > 0.0);
        *start = (so_far / sum * free) as u32 + given;
    }
    fill_guide(starts, guide);
    sum
}

fn fill_guide(starts: &[u32], guide: &mut [u16]) {
    let last = starts.len() - 2;
    let stretches = guide.len() - 1;
    let mut part = 0;
    for (stretch, entry) in guide[..stretches].iter_mut().enumerate() {
        let first = ((stretch as u64) << 32) / stretches as u64;
        while part < last && u64::from(starts[part + 1]) <= first {
            part += 1;
        }
        *entry = part as u16;
    }
    guide[stretches] = last as u16;
}

impl<'a> Inversion<'a> {
    pub(super) fn new(starts: &'a [u32], guide: &'a [u16]) -> Self {
        Self { starts, guide }
    }

    /// The part that a place in `[0, 1)` of the line is in, and where in the part, in `[0, 1)`.
    #[inline]
    pub(super) fn draw(&self, place: f64) -> (usize, f64) {
        let target = place * f64::from(UNITS);
        let unit = target as u32;
        let stretches = self.guide.len() - 1;
        let stretch = ((u64::from(unit) * stretches as u64) >> 32) as usize;
        let (mut low, mut high) = (usize::from(self.guide[stretch]), usize::from(self.guide[stretch + 1]));
        // The last part that starts at or before the unit: those without width are passed over.
        while low < high {
            let middle = (low + high).div_ceil(2);
            if self.starts[middle] <= unit {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        let (start, end) = (self.starts[low], self.starts[low + 1]);
        let within = (target - f64::from(start)) / f64::from(end - start);
        (low, within.min(1.0 - f64::EPSILON))
    }

    /// The probability of a part.
    #[inline]
    pub(super) fn probability(&self, part: usize) -> f64 {
        f64::from(self.starts[part + 1] - self.starts[part]) / f64::from(UNITS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn prepared(weights: &[f64]) -> (Vec<u32>, Vec<u16>, f64) {
        let (mut starts, mut guide) = (vec![0; starts_length(weights.len())], vec![0; guide_length(weights.len())]);
        let sum = prepare(weights.iter().copied(), &mut starts, &mut guide);
        (starts, guide, sum)
    }

    #[test]
    fn probabilities_are_the_weights() {
        let weights = [0.0, 3.0, 0.0, 0.0, 1.0, 4.0, 0.0];
        let (starts, guide, sum) = prepared(&weights);
        let line = Inversion::new(&starts, &guide);
        assert_eq!(sum, 8.0);
        for (part, weight) in weights.into_iter().enumerate() {
            assert!((line.probability(part) - weight / 8.0).abs() < 1e-8, "{part}");
        }
        let total: f64 = (0..7).map(|part| line.probability(part)).sum();
        assert_eq!(total, 1.0);
    }

    #[test]
    fn a_place_falls_into_the_part_that_holds_it() {
        for count in [1, 2, 3, 7, 64, 1000] {
            let weights: Vec<f64> = (0..count).map(|k| f64::from(k * 7919 % 13)).map(|w| w * w * w).collect();
            let (starts, guide, sum) = prepared(&weights);
            if sum == 0.0 {
                continue;
            }
            let line = Inversion::new(&starts, &guide);
            for step in 0..10_000 {
                let place = f64::from(step) / 10_000.0;
                let (part, within) = line.draw(place);
                let before: f64 = (0..part).map(|k| line.probability(k)).sum();
                assert!((before + within * line.probability(part) - place).abs() < 1e-9, "{count} {place}");
                assert!((0.0..1.0).contains(&within));
            }
        }
    }

    #[test]
    fn the_dimmest_part_stays_in_reach_of_the_brightest() {
        let (starts, guide, _) = prepared(&[1e-30, 1e30, 1e-30]);
        let line = Inversion::new(&starts, &guide);
        assert!((0..3).all(|part| line.probability(part) > 0.0));
        assert_eq!((line.draw(0.0).0, line.draw(0.5).0, line.draw(1.0 - 1e-12).0), (0, 1, 2));
    }
}
