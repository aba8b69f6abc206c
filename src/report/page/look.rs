//! What words stand for, and how they are shown.

use anstyle::{AnsiColor, Style};

/// What a word stands for, and so its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    /// Text.
    Plain,
    /// What to do.
    Action,
    /// A line of code or a command.
    Code,
    /// A right map or seam.
    Fits,
    /// A broken one.
    Broken,
    /// One that the pixels cannot decide.
    Undecidable,
}

impl Meaning {
    fn style(self) -> Style {
        let bold = Style::new().bold();
        match self {
            Self::Plain => Style::new(),
            Self::Action => bold,
            Self::Code => AnsiColor::Cyan.on_default(),
            Self::Fits => bold.fg_color(Some(AnsiColor::Green.into())),
            Self::Broken => bold.fg_color(Some(AnsiColor::Red.into())),
            Self::Undecidable => bold.fg_color(Some(AnsiColor::Yellow.into())),
        }
    }
}

/// How a report is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Look {
    /// Columns of the terminal; `None` for a file or a pipe, where nothing is wrapped.
    pub width: Option<usize>,
    /// Whether meanings are coloured.
    pub colour: bool,
}

impl Look {
    /// A word in the colour of its meaning, without control characters, which names of files may hold.
    pub(super) fn painted(self, meaning: Meaning, word: &str) -> String {
        let word = word.replace(|letter: char| letter.is_control() && letter != '\t', "\u{fffd}");
        let style = meaning.style();
        if self.colour && style != Style::new() { format!("{style}{word}{style:#}") } else { word }
    }
}

/// A word or a sentence, and what it stands for.
pub type Span = (Meaning, String);
