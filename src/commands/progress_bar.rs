//! The progress bar: on stderr, and only on a terminal.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::interrupt;
use crate::render::Progress;

/// Shows what is done, rays per second and the time left.
pub struct RenderBar {
    bar: ProgressBar,
    samples: AtomicU64,
    rays: AtomicU64,
    started: Instant,
    /// Milliseconds from the start after which the next rate is shown.
    next_rate: AtomicU64,
    /// Nobody sees it.
    hidden: bool,
    /// When the bar is full, if that is a matter of time.
    limit: Option<Duration>,
}

/// Milliseconds between two rates: nobody reads more, and to write one takes as long as to trace hundreds of rays.
const PAUSE: u64 = 50;

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
        let [samples, rays, next_rate] = [0; 3].map(AtomicU64::new);
        let hidden = bar.is_hidden();
        Self { bar, samples, rays, started: Instant::now(), next_rate, hidden, limit: None }
    }

    /// True if a new rate is to be shown now: for one of the threads that ask.
    fn is_due(&self, elapsed: Duration) -> bool {
        let now = elapsed.as_millis() as u64;
        let due = self.next_rate.load(Ordering::Relaxed);
        let claim = || self.next_rate.compare_exchange(due, now + PAUSE, Ordering::Relaxed, Ordering::Relaxed);
        now >= due && claim().is_ok()
    }

    /// One step of work that is not counted in rays.
    #[cfg(feature = "stress")]
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
        let samples = self.samples.fetch_add(samples, Ordering::Relaxed) + samples;
        let rays = self.rays.fetch_add(rays, Ordering::Relaxed) + rays;
        if self.hidden {
            return;
        }
        let elapsed = self.started.elapsed();
        self.bar.set_position(self.limit.map_or(samples, |limit| elapsed.min(limit).as_millis() as u64));
        if self.is_due(elapsed) {
            let rate = rays as f64 / elapsed.as_secs_f64().max(1e-9) / 1e6;
            self.bar.set_message(format!("{rate:.1} million rays/s"));
        }
    }

    fn cancelled(&self) -> bool {
        interrupt::requested()
    }

    fn presentable(&self) {
        interrupt::watch();
    }
}
