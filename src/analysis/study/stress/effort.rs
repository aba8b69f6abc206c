//! How much is tried, and trying much at once with the same outcome on any number of threads.

use crate::parallel;

use super::random::Random;

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

/// The worst of `count` inputs: its error and what it was. An error that is no number counts as infinite.
pub fn worst_of<T: Send>(count: usize, seed: u64, measure: impl Fn(&mut Random) -> (f64, T) + Sync) -> (f64, T) {
    let of_chunk = |chunk: usize| {
        let mut random = generator(seed, chunk);
        let size = CHUNK.min(count - chunk * CHUNK);
        (0..size).map(|_| measure(&mut random)).map(number_or_infinite).reduce(worse).expect("a chunk is not empty")
    };
    let chunks = parallel::map(0..count.div_ceil(CHUNK), of_chunk);
    chunks.into_iter().reduce(worse).expect("at least one input")
}

/// How many of a million inputs are at fault, and the first that is. `try_one` tells the input if it is.
pub fn faults_of<T: Send>(
    count: usize,
    seed: u64,
    try_one: impl Fn(&mut Random) -> Option<T> + Sync,
) -> (f64, Option<T>) {
    let of_chunk = |chunk: usize| {
        let mut random = generator(seed, chunk);
        let size = CHUNK.min(count - chunk * CHUNK);
        let mut faults = (0..size).filter_map(|_| try_one(&mut random));
        let first = faults.next();
        (usize::from(first.is_some()) + faults.count(), first)
    };
    let chunks = parallel::map(0..count.div_ceil(CHUNK), of_chunk);
    let faults: usize = chunks.iter().map(|(faults, _)| faults).sum();
    (faults as f64 * 1e6 / count as f64, chunks.into_iter().find_map(|(_, first)| first))
}

/// The same for every chunk whichever thread does it.
fn generator(seed: u64, chunk: usize) -> Random {
    let mut random = Random(seed.wrapping_mul(0x2545_F491_4F6C_DD1D) ^ chunk as u64);
    Random(random.bits())
}

fn number_or_infinite<T>((error, input): (f64, T)) -> (f64, T) {
    (if error.is_nan() { f64::INFINITY } else { error }, input)
}

/// The first of the two, unless the second is worse.
fn worse<T>(one: (f64, T), other: (f64, T)) -> (f64, T) {
    if other.0 > one.0 { other } else { one }
}

/// `10^exponent`, correctly rounded.
pub fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().expect("a number")
}

/// The powers of ten from `10^first` to `10^last`, upwards.
pub fn decades(first: i32, last: i32) -> impl Iterator<Item = f64> {
    (first..=last).map(power_of_ten)
}
