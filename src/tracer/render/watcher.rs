//! A thread that looks, while the others trace rays, whether the picture is still wanted.

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread::{Builder, scope};
use std::time::Duration;

use super::progress::Progress;
use crate::scene::StopSwitch;

/// Time between two looks.
const PAUSE: Duration = Duration::from_millis(20);

/// Does `work`, whose rays ask the switch; it is turned on once `progress` cancels the work.
pub fn watched<T>(switch: &StopSwitch, progress: &dyn Progress, work: impl FnOnce() -> T) -> T {
    scope(|scope| {
        let (working, finished) = channel::<()>();
        let watcher = move || {
            while finished.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
                if progress.cancelled() {
                    return switch.turn_on();
                }
            }
        };
        // Where the system starts no thread, `progress` is asked between pixels only.
        let _ = Builder::new().spawn_scoped(scope, watcher);
        let result = work();
        drop(working);
        result
    })
}
