//! Output and exit status of a command.

use std::borrow::Cow;
use std::path::Path;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use skycube_tracer::picture::is_standard_stream;

/// The outcome of a command, for its exit code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Done, without faults.
    Clean,
    /// Done, and faults were found.
    Faults,
    /// Stopped by Ctrl-C; what there was by then is written and marked.
    Interrupted,
}

/// What was to be printed and could not be.
static LOST_OUTPUT: OnceLock<std::io::Error> = OnceLock::new();

/// True once standard output is for a picture.
static PICTURE_ON_STDOUT: AtomicBool = AtomicBool::new(false);

/// Leaves standard output to the picture if that is where it goes: reports then go to standard error.
pub(super) fn leave_stdout_to(picture: &Path) {
    PICTURE_ON_STDOUT.store(is_standard_stream(picture), Ordering::Relaxed);
}

/// Why a report was lost; `None` if none was.
pub(super) fn lost_output() -> Option<&'static std::io::Error> {
    LOST_OUTPUT.get()
}

/// Prints to stdout. A reader that has gone (`skycube check MAP | head`) is not our fault; what is lost otherwise, on a
/// full disk, makes the command fail in the end.
pub(super) fn print(text: impl std::fmt::Display) {
    use std::io::Write;
    let text = text.to_string();
    let clean = text.split_inclusive('\n').map(printable_line).collect::<String>();
    if PICTURE_ON_STDOUT.load(Ordering::Relaxed) {
        return remark(clean);
    }
    let mut stdout = std::io::stdout().lock();
    if let Err(error) = stdout.write_all(clean.as_bytes()).and_then(|()| stdout.flush())
        && error.kind() != std::io::ErrorKind::BrokenPipe
    {
        let _ = LOST_OUTPUT.set(error);
    }
}

/// A line without control characters, which names of files may hold.
fn printable_line(line: &str) -> Cow<'_, str> {
    let harmful = |letter: char| letter.is_control() && !matches!(letter, '\n' | '\t');
    if !line.contains(harmful) {
        return Cow::Borrowed(line);
    }
    Cow::Owned(line.replace(harmful, "\u{fffd}"))
}

/// Writes to standard error, and ignores failures.
pub(super) fn remark(text: impl std::fmt::Display) {
    use std::io::Write;
    let _ = write!(std::io::stderr().lock(), "{text}");
}
