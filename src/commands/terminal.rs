//! Output and exit status of a command.

use std::borrow::Cow;
use std::path::Path;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use skycube_tracer::picture::is_standard_stream;

use terminal_size::{Height, Width, terminal_size_of};

use crate::report::{Look, Page};

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

/// Whether anything was printed.
static PRINTED: AtomicBool = AtomicBool::new(false);

/// True if a part of a report is out.
pub(super) fn has_printed() -> bool {
    PRINTED.load(Ordering::Relaxed)
}

/// Leaves standard output to the picture if that is where it goes: reports then go to standard error.
pub(super) fn leave_stdout_to(picture: &Path) {
    PICTURE_ON_STDOUT.store(is_standard_stream(picture), Ordering::Relaxed);
}

/// Why a report was lost; `None` if none was.
pub(super) fn lost_output() -> Option<&'static std::io::Error> {
    LOST_OUTPUT.get()
}

/// Colours where the user wants them: `--color`, else what `NO_COLOR`, `CLICOLOR_FORCE` and the terminal say.
pub(super) fn choose_colours(choice: clap::ColorChoice) {
    let choice = match choice {
        clap::ColorChoice::Auto => anstream::ColorChoice::Auto,
        clap::ColorChoice::Always => anstream::ColorChoice::Always,
        clap::ColorChoice::Never => anstream::ColorChoice::Never,
    };
    choice.write_global();
}

/// Longer lines are hard to read.
const WIDEST: usize = 120;

/// How reports look on a stream with this terminal: as wide, and coloured, which `anstream` undoes where colours are not wanted.
/// A file or a pipe gets the same bytes everywhere.
fn look(terminal: Option<(Width, Height)>) -> Look {
    let columns = terminal.map(|(width, _)| usize::from(width.0).min(WIDEST));
    Look { width: columns.filter(|&columns| columns > 0), colour: true }
}

/// Prints a report to stdout.
pub(super) fn show(page: &Page) {
    if PICTURE_ON_STDOUT.load(Ordering::Relaxed) {
        return show_on_stderr(page);
    }
    write(anstream::stdout().lock(), &page.shown(look(terminal_size_of(std::io::stdout()))));
}

/// Prints lines of text to stdout.
pub(super) fn tell(text: impl std::fmt::Display) {
    show(&Page::of_text(&text.to_string()));
}

/// Prints code or a report for programs to stdout, line by line as it is.
pub(super) fn print(text: impl std::fmt::Display) {
    let text = text.to_string();
    if PICTURE_ON_STDOUT.load(Ordering::Relaxed) {
        return remark(text);
    }
    write(std::io::stdout().lock(), &text.split_inclusive('\n').map(printable_line).collect::<String>());
}

/// A reader that has gone (`skycube check MAP | head`) is not our fault; what is lost otherwise, on a full disk, makes the
/// command fail in the end.
fn write(mut stdout: impl std::io::Write, text: &str) {
    PRINTED.store(true, Ordering::Relaxed);
    if let Err(error) = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush())
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

/// Writes lines to standard error, and ignores failures.
pub(super) fn remark(text: impl std::fmt::Display) {
    show_on_stderr(&Page::of_text(&text.to_string()));
}

fn show_on_stderr(page: &Page) {
    use std::io::Write;
    let text = page.shown(look(terminal_size_of(std::io::stderr())));
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
}
