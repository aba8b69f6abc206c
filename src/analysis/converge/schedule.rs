//! When a rendering is measured.

use std::time::Duration;

/// The steps of a rendering.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Schedule {
    /// At these counts of samples per pixel, ascending.
    Samples(Vec<u32>),
    /// At 1, 4, 16, ... samples as long as they fit into the time, and when it is over.
    Time(Duration),
}

/// The largest number of samples per pixel, even if time is left.
const MOST_SAMPLES: f64 = (1 << 24) as f64;

/// A step that adds less than this share is not worth a point in a plot.
const LEAST_GROWTH: f64 = 1.25;

impl Schedule {
    /// The number of samples at the next step of a rendering, from its present samples and time; `None` if it is
    /// finished.
    pub fn next(&self, samples: u32, elapsed: Duration) -> Option<u32> {
        match self {
            Schedule::Samples(steps) => steps.iter().copied().find(|&step| step > samples),
            Schedule::Time(_) if samples == 0 => Some(1),
            Schedule::Time(limit) => {
                // What fits at the speed so far, which is too slow if anything: it includes the preparation.
                let growth = limit.as_secs_f64() / elapsed.as_secs_f64().max(1e-9);
                let fitting = (f64::from(samples) * growth).min(MOST_SAMPLES);
                let next = fitting.min(4.0 * f64::from(samples));
                (fitting >= LEAST_GROWTH * f64::from(samples)).then_some(next as u32).filter(|&next| next > samples)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_followed_and_a_time_is_filled() {
        let list = Schedule::Samples(vec![1, 5, 9]);
        assert_eq!([0, 1, 5, 9].map(|samples| list.next(samples, Duration::ZERO)), [Some(1), Some(5), Some(9), None]);
        let time = Schedule::Time(Duration::from_secs(10));
        let next = |samples, seconds| time.next(samples, Duration::from_secs_f64(seconds));
        assert_eq!(next(0, 99.0), Some(1), "one sample is always taken");
        assert_eq!(next(16, 2.0), Some(64));
        assert_eq!(next(64, 8.0), Some(80));
        assert_eq!(next(64, 9.0), None);
        assert_eq!(next(1, 0.0), Some(4));
    }
}
