//! Ctrl-C: asks the running command to stop; no target is ever half-written.
//!
//! A command that checks for Ctrl-C stops cleanly. Any other, or a second Ctrl-C, ends it at once: during a write,
//! `.skycube-*.partial` may stay beside a target, which is the old file or the new one.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);
static INSTALL: Once = Once::new();

/// From now on Ctrl-C is noted instead of ending the process.
pub fn watch() {
    INSTALL.call_once(|| {
        // Without a handler Ctrl-C ends the process at once, which breaks no target either: files are renamed into place.
        let _ = ctrlc::set_handler(|| {
            // Asked a second time, do not wait for the work in hand.
            if REQUESTED.swap(true, Ordering::Relaxed) {
                std::process::exit(130);
            }
        });
    });
}

/// True once Ctrl-C was pressed.
pub fn requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}
