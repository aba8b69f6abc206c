//! The progress bar: on stderr, and only on a terminal.

use std::sync::Mutex;
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
    /// A bar for a count of samples.
    pub fn new(samples: u64, what: &str) -> Self {
        Self::of_length(samples, what)
    }

    /// A bar that is full after a time.
    pub fn until(limit: Duration, what: &str) -> Self {
        Self { limit: Some(limit), ..Self::of_length(limit.as_millis() as u64, what) }
    }

    fn of_length(length: u64, what: &str) -> Self {
        let bar = shown(Some(length), what, "{prefix} [{bar:30}] {percent}%  {msg}  {eta} left");
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

    /// The next step of work that is not counted in rays begins.
    #[cfg(feature = "stress")]
    pub fn begin(&self, step: &str) {
        self.bar.set_message(step.to_owned());
        keep_moving(&self.bar);
    }

    /// A step of such work is done.
    #[cfg(feature = "stress")]
    pub fn step(&self) {
        self.bar.inc(1);
    }

    /// Removes the bar from the terminal.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A line with the time spent, for work whose length is not known.
pub struct Spinner(ProgressBar);

impl Spinner {
    /// Says what goes on.
    pub fn new(what: &str) -> Self {
        let bar = shown(None, what, "{spinner} {prefix}  {elapsed}");
        keep_moving(&bar);
        Self(bar)
    }

    /// Removes the line from the terminal.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }
}

/// The bar that a Ctrl-C has to remove.
static SHOWN: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// A bar on stderr. `indicatif` hides it where stderr is not a terminal.
fn shown(length: Option<u64>, what: &str, template: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(length, ProgressDrawTarget::stderr());
    bar.set_style(ProgressStyle::with_template(template).expect("the template is valid").progress_chars("=> "));
    bar.set_prefix(what.to_owned());
    if let Ok(mut shown) = SHOWN.lock() {
        *shown = Some(bar.clone());
    }
    bar
}

/// Redraws a bar from time to time, so that the terminal shows it before the first step is done.
fn keep_moving(bar: &ProgressBar) {
    if !bar.is_hidden() {
        bar.enable_steady_tick(Duration::from_millis(200));
    }
}

/// Removes the bar from the terminal before the process ends in the middle of its work.
pub fn clear() {
    if let Ok(shown) = SHOWN.lock()
        && let Some(bar) = &*shown
    {
        bar.finish_and_clear();
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
