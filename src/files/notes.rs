//! Notes about files, reported once the work is done: pictures are decoded when a ray needs them, in any thread.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Mutex;

static NOTES: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Remembers a note on a file; the same note is said once.
pub fn note(file: &Path, text: &str) {
    NOTES.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).insert(format!("{}: {text}", file.display()));
}

/// Takes the notes out, sorted.
pub fn take_notes() -> Vec<String> {
    std::mem::take(&mut *NOTES.lock().unwrap_or_else(|poisoned| poisoned.into_inner())).into_iter().collect()
}
