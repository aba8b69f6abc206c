//! Memory for tables of many megabytes that are read at random places.
//!
//! The processor caches the addresses of a few thousand pages. With pages of 4 KB that covers a few megabytes; in a
//! larger table nearly every read first looks up its page, in memory as slow as the data.
//!
//! ```text
//!     table   |----------------------------------|
//!     4 KB    |....................................|   one address each
//!     2 MB     ::  |--------|--------|--------|  ::    one address each; what is left over keeps small pages
//! ```

pub use crate::memory_budget::{Claim, check_memory, claim_memory, set_memory_budget};

/// Size of a large page, of most processors.
const LARGE_PAGE: usize = 2 << 20;

/// Size of a small page, or a part of it.
const SMALL_PAGE: usize = 4 << 10;

/// An empty vector with room for `capacity` elements, on large pages where the system has them.
///
/// Measured with a million triangles in six runs each, side by side on a busy machine: 1.02 to 1.31 times as many random
/// rays per second, median 1.08; camera rays are the same within the noise.
pub fn on_large_pages<T>(capacity: usize) -> Vec<T> {
    let mut vector = Vec::with_capacity(capacity);
    let room = vector.spare_capacity_mut();
    ask_within(room.as_mut_ptr().cast(), size_of_val(room));
    vector
}

/// A vector of `length` times `zero`, on large pages where the system has them. If `zero` is a number or an array of numbers,
/// memory that is new to the process is not written to (today's standard library does so; only time depends on it).
///
/// Measured with bilinear lookups in six pictures of 2048 x 2048 texels in eleven runs each, side by side: 0.9 to 1.7 times
/// as many random ones per second, median 1.4; coherent ones are the same within the noise.
pub fn zeros_on_large_pages<T: Clone>(zero: T, length: usize) -> Vec<T> {
    let mut vector = vec![zero; length];
    ask_within(vector.as_mut_ptr().cast(), size_of_val(vector.as_slice()));
    vector
}

/// Bytes that come from memory at once.
const LINE: usize = 64;

/// Tells the processor that a value will be read soon, so that it may fetch it meanwhile.
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    let start = std::ptr::from_ref(value).cast::<u8>();
    for offset in (0..size_of::<T>()).step_by(LINE) {
        let address = start.wrapping_add(offset);
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
            // SAFETY: a hint, which reads nothing and changes nothing, whatever the address.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(address.cast()) };
        }
        #[cfg(not(target_arch = "x86_64"))]
        let _ = address;
    }
}

/// Asks for large pages for an allocation that has room for one. The small page that it starts in is asked for, too: a large
/// allocation often starts a few bytes behind the start of a large page.
fn ask_within(allocation: *mut u8, length: usize) {
    if length < LARGE_PAGE {
        return;
    }
    let before = allocation.addr() % SMALL_PAGE;
    if ask_for_large_pages(allocation.wrapping_sub(before), before + length) {
        return;
    }
    // Where even small pages are larger than that, they start elsewhere: large ones within the allocation.
    let skipped = allocation.addr().next_multiple_of(LARGE_PAGE) - allocation.addr();
    let whole = length.saturating_sub(skipped) / LARGE_PAGE * LARGE_PAGE;
    if whole > 0 {
        ask_for_large_pages(allocation.wrapping_add(skipped), whole);
    }
}

/// Asks Linux to back what was not touched yet of a piece of memory by large pages ("transparent huge pages"). False if it
/// refuses: where `start` is no start of a page, or where there are no large ones.
#[cfg(target_os = "linux")]
fn ask_for_large_pages(start: *mut u8, length: usize) -> bool {
    use std::ffi::{c_int, c_void};
    unsafe extern "C" {
        fn madvise(start: *mut c_void, length: usize, advice: c_int) -> c_int;
    }
    /// From `<linux/mman.h>`, the same for all processors.
    const MADV_HUGEPAGE: c_int = 14;
    // SAFETY: the pages hold an allocation of the caller, and the advice changes neither what memory holds nor how it may
    // be used (madvise(2)), not even that of others in the first and the last page. A system that does not know it
    // returns an error or does nothing: both leave small pages, which work as well.
    unsafe { madvise(start.cast(), length, MADV_HUGEPAGE) == 0 }
}

#[cfg(not(target_os = "linux"))]
fn ask_for_large_pages(_start: *mut u8, _length: usize) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_of_all_sizes_hold_what_is_put_in() {
        let pages = |count: usize| count * LARGE_PAGE / size_of::<u64>();
        for count in [0, 1, 1000, pages(1), pages(1) + 1, pages(2) - 1, pages(5) + 77] {
            let mut vector = on_large_pages::<u64>(count);
            assert!(vector.is_empty() && vector.capacity() >= count);
            let place = vector.as_ptr();
            vector.extend(0..count as u64);
            assert_eq!(vector.as_ptr(), place, "the room was there already");
            assert!(vector.iter().enumerate().all(|(index, &value)| value == index as u64));
        }
    }

    #[test]
    fn zeros_are_zero_whatever_was_there() {
        for length in [0, 1, LARGE_PAGE + 1, 3 * LARGE_PAGE] {
            drop(vec![1u8; length]);
            let zeros = zeros_on_large_pages(0u8, length);
            assert!(zeros.len() == length && zeros.iter().all(|&byte| byte == 0));
            drop(vec![1.0; length]);
            let zeros = zeros_on_large_pages([0.0; 3], length / 16);
            assert!(zeros.len() == length / 16 && zeros.iter().all(|sum| *sum == [0.0; 3]));
        }
    }

    #[test]
    fn elements_without_size_need_no_memory() {
        assert!(on_large_pages::<()>(1 << 30).is_empty());
    }
}
