//! The threads of a command.

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Starts the threads for all work. Where the system starts none, the calling one does it.
pub fn start() {
    let builder = ThreadPoolBuilder::new;
    // rayon tries only once to start its threads, and panics at the first work if that failed: they are tried before.
    let _ = match builder().build() {
        Ok(_) => builder().build_global(),
        Err(_) => builder().num_threads(1).use_current_thread().build_global(),
    };
}

/// Threads for a part of the work.
pub struct Threads(Option<ThreadPool>);

impl Threads {
    /// So many threads; those for all work if no number is given, or where the system does not start them.
    pub fn new(count: Option<u32>) -> Self {
        Self(count.and_then(|count| ThreadPoolBuilder::new().num_threads(count as usize).build().ok()))
    }

    /// Does work on these threads.
    pub fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}
