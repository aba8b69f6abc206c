//! The error type of skycube: the message to the user when a command cannot run.

use std::borrow::Cow;
use std::fmt;
use std::path::{Path, PathBuf};

/// Shorthand for results of this crate.
pub type Result<T> = std::result::Result<T, Error>;

/// One clear message: where (file, line, key), what is wrong, what was expected, what to do.
///
/// Printed as
///
/// ```text
/// scene.toml:12: materials.ball.ior: found "glass"
///   expected: a number of at least 1
///   help: 1.5 is common window glass
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error(Box<Message>);

/// The parts of an error, boxed so that results stay small.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Message {
    problem: String,
    file: Option<PathBuf>,
    line: Option<usize>,
    key: Option<String>,
    expected: Option<String>,
    help: Option<String>,
    damaged: bool,
}

impl Error {
    /// An error that says what is wrong; the place and the advice are added by the methods below.
    pub fn new(problem: impl Into<String>) -> Self {
        Self(Box::new(Message {
            problem: problem.into(),
            file: None,
            line: None,
            key: None,
            expected: None,
            help: None,
            damaged: false,
        }))
    }

    /// The file the error is in. A file that is already named stays: the innermost one is the most exact.
    pub fn in_file(mut self, file: impl AsRef<Path>) -> Self {
        self.0.file.get_or_insert_with(|| file.as_ref().to_path_buf());
        self
    }

    /// The line in the file, counted from 1.
    pub fn at_line(mut self, line: usize) -> Self {
        self.0.line.get_or_insert(line);
        self
    }

    /// The key of a scene or table, dotted (`materials.ball.ior`).
    pub fn at_key(mut self, key: impl Into<String>) -> Self {
        self.0.key.get_or_insert_with(|| key.into());
        self
    }

    /// What would have been right.
    pub fn expected(mut self, expected: impl Into<String>) -> Self {
        self.0.expected.get_or_insert_with(|| expected.into());
        self
    }

    /// What the user can do about it.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.0.help.get_or_insert_with(|| help.into());
        self
    }

    /// Says that the file itself is at fault: it is damaged or incomplete.
    pub fn of_damage(mut self) -> Self {
        self.0.damaged = true;
        self
    }

    /// True if the file itself is at fault.
    pub fn is_damage(&self) -> bool {
        self.0.damaged
    }

    /// The file the error is in.
    pub fn file(&self) -> Option<&Path> {
        self.0.file.as_deref()
    }

    /// What is wrong, without place or advice.
    pub fn problem(&self) -> &str {
        &self.0.problem
    }
}

/// A text from a file as a terminal may show it: control characters are written out, and what is longer than a screen is cut.
pub fn printable(text: &str) -> Cow<'_, str> {
    const MOST: usize = 2000;
    let harmless = |letter: char| !letter.is_control() || matches!(letter, '\n' | '\t');
    if text.len() <= MOST && text.chars().all(harmless) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::new();
    for letter in text.chars() {
        if shown.len() > MOST {
            shown.push_str("...");
            break;
        }
        if harmless(letter) { shown.push(letter) } else { shown.extend(letter.escape_default()) }
    }
    Cow::Owned(shown)
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let message = self.0.as_ref();
        let cleaned = |text: &Option<String>| text.as_ref().map(|text| printable(text).into_owned());
        let (problem, line) = (printable(&message.problem), message.line);
        let (key, expected, help) = (cleaned(&message.key), cleaned(&message.expected), cleaned(&message.help));
        if let Some(file) = &message.file {
            // A line of its own could be taken for a command, by GitHub Actions say.
            write!(formatter, "{}:", printable(&file.to_string_lossy()).replace('\n', "\\n"))?;
            if let Some(line) = line {
                write!(formatter, "{line}:")?;
            }
            write!(formatter, " ")?;
        }
        if let Some(key) = key {
            write!(formatter, "{key}: ")?;
        }
        write!(formatter, "{problem}")?;
        if let Some(expected) = expected {
            write!(formatter, "\n  expected: {expected}")?;
        }
        if let Some(help) = help {
            write!(formatter, "\n  help: {help}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prints_place_problem_expectation_and_help() {
        let error = Error::new("found \"glass\"")
            .in_file("scene.toml")
            .at_line(12)
            .at_key("materials.ball.ior")
            .expected("a number of at least 1")
            .help("1.5 is common window glass");
        insta::assert_snapshot!(error, @r#"
        scene.toml:12: materials.ball.ior: found "glass"
          expected: a number of at least 1
          help: 1.5 is common window glass
        "#);
    }

    #[test]
    fn no_text_of_a_file_commands_the_terminal() {
        let error = Error::new(format!("found \x1b[31m{}", "x".repeat(5000))).in_file("a\x07b");
        let text = error.to_string();
        assert!(text.starts_with("a\\u{7}b: found \\u{1b}[31mxxx") && text.ends_with("..."), "{text}");
        assert!(text.len() < 2100);
    }

    #[test]
    fn keeps_the_innermost_file() {
        let error = Error::new("truncated").in_file("posx.jpg").in_file("scene.toml");
        assert_eq!(error.to_string(), "posx.jpg: truncated");
    }
}
