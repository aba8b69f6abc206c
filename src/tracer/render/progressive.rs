//! Progressive rendering: the whole picture early, then more samples.

use std::time::{Duration, Instant};

use super::progress::Progress;
use super::renderer::Renderer;
use super::rendering::Rendering;
use crate::error::{Error, Result};

/// When a progressive rendering is finished.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Budget {
    /// The number of samples per pixel.
    Samples(u32),
    /// After so much time, with at least one sample.
    Time(Duration),
}

/// The largest number of samples per pixel, even if time is left.
const MOST_SAMPLES: u32 = 1 << 24;

/// Renders in passes until the budget is spent. Asked to stop by `progress`, gives the picture so far, marked as
/// stopped; before the first sample of every pixel is there, an error.
pub fn render_progressively(mut renderer: Renderer, budget: Budget, progress: &dyn Progress) -> Result<Rendering> {
    let started = Instant::now();
    while let Some(count) = next_pass(renderer.samples(), budget, started.elapsed()) {
        if let Err(error) = renderer.add_samples(count, progress) {
            // A pass that was begun leaves every row right by itself.
            let shown = renderer.rendering(true);
            return match progress.cancelled() {
                true if shown.samples > 0 => Ok(shown),
                true => Err(Error::new("cancelled before every pixel had a sample: nothing was written")),
                false => Err(error),
            };
        }
    }
    Ok(renderer.rendering(false))
}

/// Samples of the next pass; `None` if the budget is spent. Passes grow with the picture, so that their number stays small.
fn next_pass(samples: u32, budget: Budget, elapsed: Duration) -> Option<u32> {
    let doubling = samples.clamp(1, 64);
    match budget {
        Budget::Samples(wanted) => Some(doubling.min(wanted - samples)).filter(|&count| count > 0),
        Budget::Time(_) if samples == 0 => Some(1),
        Budget::Time(limit) => {
            // As many as fit into the time that is left, at the speed so far.
            let left = limit.saturating_sub(elapsed).as_secs_f64();
            let fitting = left / elapsed.as_secs_f64().max(1e-9) * f64::from(samples);
            Some((fitting as u32).min(doubling).min(MOST_SAMPLES - samples)).filter(|&count| count > 0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_add_up_to_the_samples_asked_for() {
        for wanted in [1, 2, 3, 37, 64, 200] {
            let mut samples = 0;
            while let Some(count) = next_pass(samples, Budget::Samples(wanted), Duration::ZERO) {
                samples += count;
            }
            assert_eq!(samples, wanted);
        }
    }

    #[test]
    fn a_pass_that_would_not_fit_is_not_begun() {
        let pass = |samples, elapsed| {
            next_pass(samples, Budget::Time(Duration::from_secs(10)), Duration::from_secs_f64(elapsed))
        };
        assert_eq!(pass(0, 30.0), Some(1), "one sample is always taken");
        assert_eq!(pass(8, 4.0), Some(8));
        assert_eq!(pass(16, 8.0), Some(4));
        assert_eq!(pass(16, 9.9), None);
    }
}
