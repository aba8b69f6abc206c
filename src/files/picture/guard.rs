//! Guards against decoders that panic on a file.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use crate::error::{Error, Result};

thread_local! {
    /// True while a panic of this thread is an answer and not a message on the terminal.
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// What the work gives; an error if it panics. The file is to blame: decoders are written for files that others wrote, and some
/// have cases that nobody thought of.
pub fn guarded<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |panic| {
            if !GUARDED.get() {
                usual(panic);
            }
        }));
    });
    let before = GUARDED.replace(true);
    let result = catch_unwind(AssertUnwindSafe(work));
    GUARDED.set(before);
    result.unwrap_or_else(|_| {
        Err(Error::new("this file cannot be decoded: its variant is unknown to the decoder, or it is damaged")
            .help("save it again as PNG with an image editor, or download it again")
            .of_damage())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_an_error() {
        assert_eq!(guarded(|| Ok(1)), Ok(1));
        let nested = guarded(|| {
            assert!(guarded(|| -> Result<()> { panic!("inner") }).is_err());
            assert!(GUARDED.get(), "the outer work is still guarded");
            Ok([1, 2, 3].get(7).copied().expect("outer"))
        });
        assert!(nested.unwrap_err().problem().contains("cannot be decoded"));
        assert!(!GUARDED.get());
    }
}
