//! A report as paragraphs and tables of words with meanings. Width and colours are applied when it is shown.

mod look;
mod table;

pub use look::{Look, Meaning, Span};
pub use table::{Column, Table};

/// Words at the beginning of a line that say what it is.
const LABELS: [(&str, Meaning); 5] = [
    ("error:", Meaning::Broken),
    ("warning:", Meaning::Undecidable),
    ("note:", Meaning::Action),
    ("expected:", Meaning::Action),
    ("help:", Meaning::Action),
];

/// Paragraphs and tables, from top to bottom.
#[derive(Debug, Clone, Default)]
pub struct Page(Vec<Block>);

#[derive(Debug, Clone)]
enum Block {
    /// Wrapped to the width; all lines but the first are indented by two columns more.
    Paragraph { indent: usize, spans: Vec<Span> },
    /// Loses columns where the width does not hold all.
    Table(Table),
}

impl Page {
    /// A page of plain lines; each begins with its own indentation.
    pub fn of_text(text: &str) -> Self {
        let mut page = Self::default();
        for line in text.lines() {
            let words = line.trim_start_matches(' ');
            let label = LABELS.iter().find(|(label, _)| words.starts_with(label));
            let (label, meaning) = label.copied().unwrap_or(("", Meaning::Plain));
            let spans = [(meaning, label.to_owned()), (Meaning::Plain, words[label.len()..].to_owned())];
            page.add(line.len() - words.len(), spans);
        }
        page
    }

    /// Adds a paragraph.
    pub fn add(&mut self, indent: usize, spans: impl IntoIterator<Item = Span>) {
        self.0.push(Block::Paragraph { indent, spans: spans.into_iter().collect() });
    }

    /// Adds a paragraph without colours.
    pub fn say(&mut self, indent: usize, text: impl Into<String>) {
        self.add(indent, [(Meaning::Plain, text.into())]);
    }

    /// Adds an empty line.
    pub fn gap(&mut self) {
        self.say(0, "");
    }

    /// Adds a table.
    pub fn table(&mut self, table: Table) {
        self.0.push(Block::Table(table));
    }

    /// Adds another page below.
    pub fn append(&mut self, other: Self) {
        self.0.extend(other.0);
    }

    /// The page as it is printed.
    pub fn shown(&self, look: Look) -> String {
        self.0.iter().map(|block| block.shown(look)).collect()
    }
}

impl Block {
    fn shown(&self, look: Look) -> String {
        let (indent, spans) = match self {
            Self::Paragraph { indent, spans } => (*indent, spans),
            Self::Table(table) => return table.shown(look),
        };
        let text: String = spans.iter().map(|(meaning, word)| look.painted(*meaning, word)).collect();
        if text.is_empty() {
            return "\n".to_owned();
        }
        let (first, next) = (" ".repeat(indent), " ".repeat(indent + 2));
        let Some(width) = look.width else { return format!("{first}{text}\n") };
        let options = textwrap::Options::new(width).initial_indent(&first).subsequent_indent(&next).break_words(false);
        textwrap::wrap(&text, options).iter().map(|line| format!("{line}\n")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page() -> Page {
        let mut page = Page::default();
        page.add(0, [(Meaning::Action, "posx.jpg: turn".to_owned()), (Meaning::Plain, " it round".to_owned())]);
        page
    }

    #[test]
    fn a_terminal_wraps_and_a_file_does_not() {
        assert_eq!(page().shown(Look::default()), "posx.jpg: turn it round\n");
        assert_eq!(page().shown(Look { width: Some(16), colour: false }), "posx.jpg: turn\n  it round\n");
    }

    #[test]
    fn colours_take_no_room() {
        let coloured = page().shown(Look { width: Some(16), colour: true });
        assert_eq!(coloured, "\u{1b}[1mposx.jpg: turn\u{1b}[0m\n  it round\n");
        assert_eq!(
            anstream::adapter::strip_str(&coloured).to_string(),
            page().shown(Look { width: Some(16), colour: false })
        );
    }

    #[test]
    fn names_of_files_do_not_reach_the_terminal_as_commands() {
        let mut page = Page::default();
        page.say(0, "\u{1b}[2Jposx.jpg");
        assert_eq!(page.shown(Look { width: None, colour: true }), "\u{fffd}[2Jposx.jpg\n");
    }
}
