//! A switch that ends rendering wherever it is: every ray asks it.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};

/// Off until rendering is to end; then on for good.
#[derive(Debug, Default)]
pub struct StopSwitch(AtomicBool);

/// What unwinds the stack of a sample that is given up.
struct GivenUp;

impl StopSwitch {
    /// Ends all samples at their next ray.
    pub fn turn_on(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// True once rendering is to end.
    pub fn is_on(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Returns to the caller of [`finished`] if rendering is to end: a sample may trace rays for years.
    #[inline(always)]
    pub fn check(&self) {
        if self.is_on() {
            give_up();
        }
    }
}

/// Unwinds the stack up to the caller of [`finished`]; a panic without a message.
#[cold]
pub fn give_up() -> ! {
    resume_unwind(Box::new(GivenUp))
}

/// What `work` returns; `None` if it was given up.
pub fn finished<T>(work: impl FnOnce() -> T) -> Option<T> {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(value) => Some(value),
        Err(payload) if payload.is::<GivenUp>() => None,
        Err(payload) => resume_unwind(payload),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_ends_where_the_switch_is_found_on() {
        let switch = StopSwitch::default();
        let mut steps = 0;
        let result = finished(|| {
            loop {
                switch.check();
                steps += 1;
                if steps == 3 {
                    switch.turn_on();
                }
            }
        });
        assert_eq!((result, steps), (None::<()>, 3));
        assert_eq!(finished(|| 4), Some(4));
    }

    #[test]
    fn other_panics_pass() {
        let panic = catch_unwind(|| finished(|| resume_unwind(Box::new(5)))).unwrap_err();
        assert_eq!(panic.downcast_ref(), Some(&5));
    }
}
