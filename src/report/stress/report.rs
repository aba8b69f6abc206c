//! The report of `skycube stress`, as text and as JSON.

use std::fmt::{self, Write};

use clap::ValueEnum;
use serde_json::{Value, json};

use super::super::json::to_json;
use crate::limits::Range;
use crate::stress::{Case, Effort, Group, Verdict};

/// Cases that were swept, to be printed.
pub struct StressReport<'a> {
    /// By subject, in the order of the table.
    pub cases: &'a [Case],
    /// How many inputs each step had.
    pub effort: Effort,
    /// Every step of the sweeps, too.
    pub steps: bool,
}

/// The text of a line, in columns.
type Row = [String; 7];

/// What the columns are called.
const HEADINGS: [&str; 7] = ["case", "what is swept", "within bound", "bound", "worst", "with", ""];

/// Longest text of the column of inputs.
const INPUT_WIDTH: usize = 24;

impl StressReport<'_> {
    /// The report for machines.
    pub fn to_json(&self) -> String {
        let cases: Vec<Value> = self.cases.iter().map(case_json).collect();
        to_json("stress", &json!({ "rays": self.effort.rays, "cases": cases }))
    }

    fn write_steps(&self, formatter: &mut fmt::Formatter<'_>, case: &Case) -> fmt::Result {
        let subject = &case.subject;
        writeln!(formatter, "\n{}: error of {}", subject.name, subject.error)?;
        writeln!(formatter, "  {:>12}  {:>10}  with", "at", "error")?;
        for step in &case.measurements {
            let mark = match (step.error <= subject.bound, subject.promised.holds(step.magnitude)) {
                (true, _) => "",
                (false, true) => "  beyond the bound",
                (false, false) => "  beyond the bound, and not promised",
            };
            let (at, error) = (short(step.magnitude), short(step.error));
            writeln!(formatter, "  {at:>12}  {error:>10}  {}{mark}", step.input)?;
        }
        Ok(())
    }
}

impl fmt::Display for StressReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows: Vec<Row> = self.cases.iter().map(row).collect();
        let headings = HEADINGS.map(str::to_owned);
        let width = |column: usize| rows.iter().chain([&headings]).map(|row| row[column].chars().count()).max();
        let widths: [usize; 7] = std::array::from_fn(|column| width(column).unwrap_or(0));
        formatter.write_str(&line("", &headings, &widths))?;
        for &group in Group::value_variants() {
            let mut members = self.cases.iter().zip(&rows).filter(|(case, _)| case.subject.group == group).peekable();
            if members.peek().is_some() {
                writeln!(formatter, "{}", group.title())?;
            }
            for (_, row) in members {
                formatter.write_str(&line("  ", row, &widths))?;
            }
        }
        if self.steps {
            self.cases.iter().try_for_each(|case| self.write_steps(formatter, case))?;
        }
        formatter.write_str(&summary(self.cases))
    }
}

fn line(indent: &str, row: &Row, widths: &[usize; 7]) -> String {
    let mut text = indent.to_owned();
    let first = widths[0] + 2 - indent.len();
    let _ = write!(text, "{:<first$}", row[0]);
    for (column, cell) in row.iter().enumerate().skip(1) {
        // Figures stand to the right of their column, words to the left.
        let width = widths[column];
        let _ = if column == 4 { write!(text, "  {cell:>width$}") } else { write!(text, "  {cell:<width$}") };
    }
    format!("{}\n", text.trim_end())
}

fn row(case: &Case) -> Row {
    let (subject, worst) = (&case.subject, case.worst());
    let bound = format!("{} {}", short(subject.bound), subject.unit);
    [
        subject.name.to_owned(),
        subject.swept.to_owned(),
        case.range().map_or("nowhere".to_owned(), range),
        bound.trim_end().to_owned(),
        short(worst.error),
        if worst.error == 0.0 { "-".to_owned() } else { worst.input.chars().take(INPUT_WIDTH).collect() },
        match case.verdict() {
            Verdict::Holds => "holds",
            Verdict::Ends => "ends",
            Verdict::Fails => "FAILS",
        }
        .to_owned(),
    ]
}

/// What the words mean, and how it ended.
fn summary(cases: &[Case]) -> String {
    let count = |verdict: Verdict| cases.iter().filter(|case| case.verdict() == verdict).count();
    let (holds, ends, fails) = (count(Verdict::Holds), count(Verdict::Ends), count(Verdict::Fails));
    let mut text = format!("\n{} cases: {holds} hold, {ends} end, {fails} fail\n", cases.len());
    text += "  holds  the error stays within the bound at every step\n";
    text += "  ends   the error stays within the bound in the promised range and exceeds it somewhere beyond\n";
    text += "  FAILS  the error exceeds the bound in the promised range\n";
    text += "  worst and with: the largest error in the promised range and the input that made it\n";
    text += "  ulp: units in the last place of f32 (1 is 5.4e8 of f64); ppm: per million rays\n";
    text
}

fn case_json(case: &Case) -> Value {
    let mut value = json!(case.subject);
    value["range"] = json!(case.range());
    value["worst"] = json!(case.worst());
    value["verdict"] = json!(case.verdict());
    value["sweep"] = json!(case.measurements);
    value
}

fn range(Range { least, most }: Range) -> String {
    format!("{} to {}", short(least), short(most))
}

/// Two digits, with an exponent where there would be many zeros.
fn short(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    if !number.is_finite() {
        return "infinite".to_owned();
    }
    if (10.0..100_000.0).contains(&number) {
        return format!("{number:.0}");
    }
    let text = format!("{number:.1e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = digits.trim_end_matches(".0");
    match exponent {
        "0" => digits.to_owned(),
        "-1" => format!("{:.2}", number).trim_end_matches('0').to_owned(),
        "-2" => format!("{:.3}", number).trim_end_matches('0').to_owned(),
        _ => format!("{digits}e{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn numbers_are_short() {
        let numbers = [0.0, 4.0, 0.25, 0.0039, 0.01, 1e-45, 65_504.0, 1e5, 9.96e-4, f64::INFINITY, 128.0];
        let expected = ["0", "4", "0.25", "3.9e-3", "0.01", "1e-45", "65504", "1e5", "1e-3", "infinite", "128"];
        assert_eq!(numbers.map(short), expected);
    }
}
