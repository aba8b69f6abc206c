//! The memory that a thread takes, counted.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    /// Bytes in use since the count began, and the most there were.
    static IN_USE: Cell<[isize; 2]> = const { Cell::new([0; 2]) };
}

struct Counted;

#[global_allocator]
static ALLOCATOR: Counted = Counted;

fn count(bytes: isize) {
    let [used, most] = IN_USE.get();
    IN_USE.set([used + bytes, most.max(used + bytes)]);
}

// SAFETY: every request goes on to the system's allocator as it is.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size as isize - layout.size() as isize);
        unsafe { System.realloc(memory, layout, size) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        unsafe { System.dealloc(memory, layout) }
    }
}

/// What the work gives, and the most memory that it had taken in this thread at one time.
pub fn peak_of<T>(work: impl FnOnce() -> T) -> (T, usize) {
    IN_USE.set([0; 2]);
    let result = work();
    (result, IN_USE.get()[1] as usize)
}
