//! Progress reports of a rendering.

/// Told by the renderer how far it is; asked by it whether to stop.
pub trait Progress: Sync {
    /// Some samples of pixels are finished and some rays traced since the last call.
    fn advance(&self, samples: u64, rays: u64);

    /// True if the picture is not wanted any more.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Reports nothing and never stops.
pub struct Silent;

impl Progress for Silent {
    fn advance(&self, _samples: u64, _rays: u64) {}
}
