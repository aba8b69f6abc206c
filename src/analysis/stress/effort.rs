//! The effort of a case, and parallel trials with the same result on any number of threads.

use crate::parallel;
use crate::random::{Random, power_of_ten};

/// Inputs that share a generator of random numbers.
const CHUNK: usize = 1 << 12;

/// How many rays are spent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Rays spawned on surfaces in all cases of self-intersection together; the other cases take their share of it.
    pub rays: usize,
}

impl Effort {
    /// What is spent if nobody says otherwise.
    pub const FULL: Self = Self { rays: 10_000_000 };

    /// A share of the rays, but at least 32.
    pub fn share(self, share: f64) -> usize {
        ((self.rays as f64 * share) as usize).max(32)
    }
}

/// The worst of `count` inputs: its error and its description. An error that is not a number counts as infinite.
pub fn worst_of<T>(count: usize, seed: u64, measure: impl Fn(&mut Random) -> (f64, T) + Sync) -> (f64, T) {
    let chunks = of_chunks(count, seed, &|size, random| {
        let mut worst = (f64::NEG_INFINITY, random.clone());
        for _ in 0..size {
            let before = random.clone();
            let error = number_or_infinite(measure(random).0);
            if error > worst.0 {
                worst = (error, before);
            }
        }
        worst
    });
    let worst = chunks.into_iter().reduce(|one, other| if other.0 > one.0 { other } else { one });
    // The generator is where it was before that input, which is made once more.
    let (error, mut random) = worst.expect("at least one input");
    (error, measure(&mut random).1)
}

/// How many of a million inputs are at fault, and the first that is. `try_one` tells the input if it is.
pub fn faults_of<T>(count: usize, seed: u64, try_one: impl Fn(&mut Random) -> Option<T> + Sync) -> (f64, Option<T>) {
    let chunks = of_chunks(count, seed, &|size, random| {
        let (mut faults, mut first) = (0.0, random.clone());
        for _ in 0..size {
            let before = random.clone();
            if try_one(random).is_some() {
                if faults == 0.0 {
                    first = before;
                }
                faults += 1.0;
            }
        }
        (faults, first)
    });
    let faults: f64 = chunks.iter().map(|(faults, _)| faults).sum();
    let first = chunks.into_iter().find(|(faults, _)| *faults > 0.0);
    (faults * 1e6 / count as f64, first.and_then(|(_, mut random)| try_one(&mut random)))
}

/// A figure of several inputs in a row, and the state of the random numbers before the decisive input.
type OfChunk<'a> = dyn Fn(usize, &mut Random) -> (f64, Random) + Sync + 'a;

/// The figures of all inputs, chunk by chunk: the same for every chunk whichever thread does it.
fn of_chunks(count: usize, seed: u64, of_chunk: &OfChunk) -> Vec<(f64, Random)> {
    parallel::map(0..count.div_ceil(CHUNK), |chunk| {
        let size = CHUNK.min(count - chunk * CHUNK);
        of_chunk(size, &mut generator(seed, chunk))
    })
}

/// The generator that starts a chunk.
fn generator(seed: u64, chunk: usize) -> Random {
    let mut random = Random(seed.wrapping_mul(0x2545_F491_4F6C_DD1D) ^ chunk as u64);
    Random(random.bits())
}

fn number_or_infinite(error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The powers of ten from `10^first` to `10^last`, upwards.
pub fn decades(first: i32, last: i32) -> impl Iterator<Item = f64> {
    (first..=last).map(power_of_ten)
}
