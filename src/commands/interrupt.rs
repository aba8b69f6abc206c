//! Signals: Ctrl-C asks the running command to stop or ends it, and no file is ever half-written.
//!
//! A command that watches for Ctrl-C stops cleanly at the first one. Any other command, or a second Ctrl-C, ends the process at
//! once, but for a file that is just being written: that is finished first.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::picture::between_writes;

static WATCHED: AtomicBool = AtomicBool::new(false);
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// Sets up the signals; `tidy` is done before the process ends. Without the handlers, which a system may refuse, they end the
/// process as usual.
pub fn handle(tidy: fn()) {
    let _ = ctrlc::set_handler(move || {
        let is_first = !REQUESTED.swap(true, Ordering::Relaxed);
        if !(is_first && WATCHED.load(Ordering::Relaxed)) {
            between_writes(|| {
                tidy();
                std::process::exit(130)
            });
        }
    });
    #[cfg(unix)]
    {
        use signal_hook::consts::{SIGABRT, SIGXFSZ};
        // A file over the limit that the shell sets is then an error of the write that meets it.
        let _ = signal_hook::flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)));
        // Where the system refuses memory, the standard library says how much it was and aborts: exit code 2, as for any
        // command that cannot run.
        // SAFETY: to exit in this way is allowed wherever a signal arrives.
        let _ = unsafe { signal_hook::low_level::register(SIGABRT, || signal_hook::low_level::exit(2)) };
    }
}

/// From now on the first Ctrl-C is noted instead of ending the process.
pub fn watch() {
    WATCHED.store(true, Ordering::Relaxed);
}

/// True once Ctrl-C was pressed.
pub fn requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}
