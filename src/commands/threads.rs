//! The threads of a command.

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Does work on all processors. Where the system starts no threads, the calling one does it.
pub fn on_all<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match ThreadPoolBuilder::new().build() {
        Ok(pool) => pool.install(work),
        Err(_) => {
            let _ = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
            work()
        }
    }
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
