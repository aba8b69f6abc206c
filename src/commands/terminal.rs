//! Output and exit status of a command.

use std::borrow::Cow;
use std::sync::OnceLock;

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
    write(anstream::stdout().lock(), &page.shown(look(terminal_size_of(std::io::stdout()))));
}

/// Prints lines of text to stdout.
pub(super) fn tell(text: impl std::fmt::Display) {
    show(&Page::of_text(&text.to_string()));
}

/// Prints code or a report for programs to stdout, line by line as it is.
pub(super) fn print(text: impl std::fmt::Display) {
    let text = text.to_string();
    write(std::io::stdout().lock(), &text.split_inclusive('\n').map(printable_line).collect::<String>());
}

/// A reader that has gone (`skycube check MAP | head`) is not our fault; what is lost otherwise, on a full disk, makes the
/// command fail in the end.
fn write(mut stdout: impl std::io::Write, text: &str) {
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
    use std::io::Write;
    let text = Page::of_text(&text.to_string()).shown(look(terminal_size_of(std::io::stderr())));
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
}
