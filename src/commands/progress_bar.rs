//! The progress bar: on stderr, and only on a terminal.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::interrupt;
use crate::render::Progress;

/// Shows what is done, rays a second and the time left.
pub struct RenderBar {
    bar: ProgressBar,
    rays: AtomicU64,
    started: Instant,
    /// When the bar is full, if that is a matter of time.
    limit: Option<Duration>,
}

impl RenderBar {
    /// A bar for a count of samples. `indicatif` hides it where stderr is not a terminal.
    pub fn new(samples: u64, what: &str) -> Self {
        Self::of_length(samples, what)
    }

    /// A bar that is full after a time.
    pub fn until(limit: Duration, what: &str) -> Self {
        Self { limit: Some(limit), ..Self::of_length(limit.as_millis() as u64, what) }
    }

    fn of_length(length: u64, what: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template("{prefix} [{bar:30}] {percent}%  {msg}  {eta} left")
            .expect("the template is valid")
            .progress_chars("=> ");
        bar.set_style(style);
        bar.set_prefix(what.to_owned());
        Self { bar, rays: AtomicU64::new(0), started: Instant::now(), limit: None }
    }

    /// One step of work that is not counted in rays.
    pub fn step(&self) {
        self.bar.inc(1);
    }

    /// Removes the bar from the terminal.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for RenderBar {
    fn advance(&self, samples: u64, rays: u64) {
        let rays = self.rays.fetch_add(rays, Ordering::Relaxed) + rays;
        let seconds = self.started.elapsed().as_secs_f64().max(1e-9);
        self.bar.set_message(format!("{:.1} million rays/s", rays as f64 / seconds / 1e6));
        match self.limit {
            Some(limit) => self.bar.set_position(self.started.elapsed().min(limit).as_millis() as u64),
            None => self.bar.inc(samples),
        }
    }

    fn cancelled(&self) -> bool {
        interrupt::requested()
    }
}
