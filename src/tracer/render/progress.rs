//! Progress reports of a rendering.

use std::time::Instant;

/// Told by the renderer how far it is; asked by it whether to stop.
pub trait Progress: Sync {
    /// Some samples of pixels are finished and some rays traced since the last call.
    fn advance(&self, samples: u64, rays: u64);

    /// True if the picture is not wanted any more.
    fn cancelled(&self) -> bool {
        false
    }

    /// From now on there is a picture to show if the rendering is cancelled.
    fn presentable(&self) {}
}

/// Reports nothing and never stops.
pub struct Silent;

impl Progress for Silent {
    fn advance(&self, _samples: u64, _rays: u64) {}
}

/// Stops at a time, too.
pub(super) struct Until<'a> {
    pub progress: &'a dyn Progress,
    /// `None`: never.
    pub end: Option<Instant>,
}

impl Progress for Until<'_> {
    fn advance(&self, samples: u64, rays: u64) {
        self.progress.advance(samples, rays);
    }

    fn cancelled(&self) -> bool {
        self.progress.cancelled() || self.end.is_some_and(|end| Instant::now() >= end)
    }

    fn presentable(&self) {
        self.progress.presentable();
    }
}

/// Reports nothing and stops as another one does.
pub(super) struct Uncounted<'a>(pub &'a dyn Progress);

impl Progress for Uncounted<'_> {
    fn advance(&self, _samples: u64, _rays: u64) {}

    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}
