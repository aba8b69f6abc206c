//! A table that fits the terminal: the columns that matter least are left out first.

use super::look::{Look, Meaning, Span};

/// A column of a table.
#[derive(Debug, Clone)]
pub struct Column {
    /// The heading.
    pub heading: &'static str,
    /// True for figures, which stand to the right.
    pub to_the_right: bool,
    /// The lower, the sooner it is left out; columns of equal weight go together.
    pub weight: usize,
}

/// Rows under headings.
#[derive(Debug, Clone)]
pub struct Table {
    /// Blanks before the first column.
    pub indent: usize,
    /// From left to right.
    pub columns: Vec<Column>,
    /// A cell for each column.
    pub rows: Vec<Vec<Span>>,
}

/// Blanks between two columns.
const GAP: usize = 2;

impl Table {
    /// The table without the columns for which there is no room, and a line that says so.
    pub(super) fn shown(&self, look: Look) -> String {
        let widths: Vec<usize> = (0..self.columns.len()).map(|column| self.width(column)).collect();
        let mut weights: Vec<usize> = self.columns.iter().map(|column| column.weight).collect();
        weights.sort_unstable();
        weights.dedup();
        let room = look.width.unwrap_or(usize::MAX);
        let shown_from = |least: usize| (0..self.columns.len()).filter(move |&at| self.columns[at].weight >= least);
        let needed = |least: usize| self.indent + shown_from(least).map(|at| widths[at] + GAP).sum::<usize>() - GAP;
        let least =
            weights.iter().copied().find(|&least| needed(least) <= room).or(weights.last().copied()).unwrap_or(0);
        let shown: Vec<usize> = shown_from(least).collect();

        let headings = self.columns.iter().map(|column| (Meaning::Plain, column.heading.to_owned())).collect();
        let lines = std::iter::once(&headings).chain(&self.rows);
        let mut text: String = lines.map(|row: &Vec<Span>| self.line(row, &shown, &widths, look)).collect();
        if shown.len() < self.columns.len() {
            text += &format!("{}… a wider terminal shows more columns\n", " ".repeat(self.indent));
        }
        text
    }

    fn width(&self, column: usize) -> usize {
        let cells = self.rows.iter().map(|row| row[column].1.chars().count());
        cells.max().unwrap_or(0).max(self.columns[column].heading.chars().count())
    }

    fn line(&self, row: &[Span], shown: &[usize], widths: &[usize], look: Look) -> String {
        let mut line = String::new();
        // Blanks are written before the next word, so that none end a line.
        let mut owed = self.indent;
        for &column in shown {
            let (meaning, word) = &row[column];
            let padding = widths[column] - word.chars().count();
            let (before, after) = if self.columns[column].to_the_right { (padding, 0) } else { (0, padding) };
            if word.is_empty() {
                owed += padding + GAP;
            } else {
                line += &" ".repeat(owed + before);
                line += &look.painted(*meaning, word);
                owed = after + GAP;
            }
        }
        line + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let column = |heading, to_the_right, weight| Column { heading, to_the_right, weight };
        let cell = |word: &str| (Meaning::Plain, word.to_owned());
        Table {
            indent: 2,
            columns: vec![column("seam", false, 9), column("step", true, 1), column("verdict", false, 9)],
            rows: vec![vec![cell("+x+y"), cell("0.5"), cell("fits")], vec![cell("+x-y"), cell("12.25"), cell("")]],
        }
    }

    #[test]
    fn figures_stand_to_the_right_and_lines_have_no_ends_of_blanks() {
        let expected = "  seam   step  verdict\n  +x+y    0.5  fits\n  +x-y  12.25\n";
        assert_eq!(table().shown(Look { width: Some(22), colour: false }), expected);
    }

    #[test]
    fn the_column_of_least_weight_goes_first() {
        let narrow = table().shown(Look { width: Some(21), colour: false });
        assert_eq!(narrow, "  seam  verdict\n  +x+y  fits\n  +x-y\n  … a wider terminal shows more columns\n");
    }
}
