//! What a command says to the shell.

/// How a command ended, for the shell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Done, and nothing to complain about.
    Clean,
    /// Done, and faults were found.
    Faults,
    /// Stopped by Ctrl-C; what there was by then is written and marked.
    Interrupted,
}

/// Prints to stdout. A reader that has gone (`skycube check MAP | head`) is no fault of ours.
pub(super) fn print(text: impl std::fmt::Display) {
    use std::io::Write;
    let _ = write!(std::io::stdout().lock(), "{text}");
}

/// Writes to standard error; that nobody reads it is no error.
pub(super) fn remark(text: impl std::fmt::Display) {
    use std::io::Write;
    let _ = write!(std::io::stderr().lock(), "{text}");
}
