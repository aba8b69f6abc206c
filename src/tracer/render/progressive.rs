//! Progressive rendering: the whole picture early, then more samples.

use std::time::{Duration, Instant};

use super::progress::{Progress, Until};
use super::renderer::Renderer;
use super::rendering::Rendering;
use crate::error::{Error, Result};

/// When a progressive rendering is finished.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Budget {
    /// The number of samples per pixel.
    Samples(u32),
    /// After so much time.
    Time(Duration),
}

/// The largest number of samples per pixel, even if time is left.
const MOST_SAMPLES: u32 = 1 << 24;

/// Sides of the squares that a picture has a sample in before every pixel has one: a large picture is soon there as a whole.
const COARSE: [usize; 2] = [64, 16];

/// Renders in passes until the budget is spent. Asked to stop by `progress`, gives the picture so far, marked as
/// stopped; before it is there at least coarsely, an error.
pub fn render_progressively(mut renderer: Renderer, budget: Budget, progress: &dyn Progress) -> Result<Rendering> {
    let started = Instant::now();
    let end = match budget {
        Budget::Samples(_) => None,
        Budget::Time(limit) => Some(started + limit),
    };
    let until = Until { progress, end };
    let mut rendered = COARSE.into_iter().try_for_each(|side| renderer.add_coarse_sample(side, &until));
    while let (Ok(()), Some(count)) = (&rendered, next_pass(renderer.samples(), budget, started.elapsed())) {
        rendered = renderer.add_samples(count, &until);
    }
    match rendered {
        Ok(()) => Ok(renderer.rendering(false)),
        // Pictures that cannot be decoded are errors whether time is left or not.
        Err(error) if !until.cancelled() || error.file().is_some() => Err(error),
        // A pass that was begun leaves every row right by itself.
        Err(_) if renderer.is_presentable() => Ok(renderer.rendering(progress.cancelled())),
        Err(_) => Err(Error::new("stopped before there was even a coarse picture: nothing was written")),
    }
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
