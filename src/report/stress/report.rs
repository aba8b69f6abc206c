//! The report of `skycube stress`, as text and as JSON.

use std::fmt::{self, Write};

use clap::ValueEnum;
use serde_json::{Value, json};

use super::super::json::to_json;
use super::super::page::{Column, Look, Meaning, Page, Span, Table};
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

/// The columns, and how much each matters where the terminal is narrow.
const COLUMNS: [Column; 7] = [
    Column { heading: "case", to_the_right: false, weight: 4 },
    Column { heading: "what is swept", to_the_right: false, weight: 2 },
    Column { heading: "within bound", to_the_right: false, weight: 3 },
    Column { heading: "bound", to_the_right: false, weight: 2 },
    Column { heading: "worst", to_the_right: true, weight: 3 },
    Column { heading: "with", to_the_right: false, weight: 1 },
    Column { heading: "", to_the_right: false, weight: 4 },
];

/// Longest text of the column of inputs.
const INPUT_WIDTH: usize = 24;

impl StressReport<'_> {
    /// The report for machines.
    pub fn to_json(&self) -> String {
        let cases: Vec<Value> = self.cases.iter().map(case_json).collect();
        to_json("stress", &json!({ "rays": self.effort.rays, "cases": cases }))
    }
}

impl StressReport<'_> {
    /// The report as it is printed.
    pub fn page(&self) -> Page {
        let mut page = Page::default();
        page.table(self.table());
        if self.steps {
            let mut steps = String::new();
            self.cases.iter().for_each(|case| write_steps(&mut steps, case));
            page.append(Page::of_text(&steps));
        }
        page.append(Page::of_text(&summary(self.cases)));
        page
    }

    /// A line for each case, under the title of its group.
    fn table(&self) -> Table {
        let mut rows = Vec::new();
        for &group in Group::value_variants() {
            let mut members = self.cases.iter().filter(|case| case.subject.group == group).peekable();
            if members.peek().is_some() {
                let title = std::iter::once(group.title()).chain(std::iter::repeat(String::new()));
                rows.push(title.take(COLUMNS.len()).map(|word| (Meaning::Plain, word)).collect());
            }
            rows.extend(members.map(row));
        }
        Table { indent: 0, columns: COLUMNS.to_vec(), rows }
    }
}

/// Without colours.
impl fmt::Display for StressReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.page().shown(Look::default()))
    }
}

fn row(case: &Case) -> Vec<Span> {
    let (subject, worst) = (&case.subject, case.worst());
    let bound = format!("{} {}", short(subject.bound), subject.unit);
    let (meaning, verdict) = match case.verdict() {
        Verdict::Holds => (Meaning::Fits, "holds"),
        Verdict::Ends => (Meaning::Undecidable, "ends"),
        Verdict::Fails => (Meaning::Broken, "FAILS"),
    };
    let words = [
        format!("  {}", subject.name),
        subject.swept.to_owned(),
        case.range().map_or("nowhere".to_owned(), range),
        bound.trim_end().to_owned(),
        short(worst.error),
        if worst.error == 0.0 { "-".to_owned() } else { shortened(&worst.input) },
    ];
    words.into_iter().map(|word| (Meaning::Plain, word)).chain([(meaning, verdict.to_owned())]).collect()
}

/// The beginning of a long text, with an ellipsis.
fn shortened(text: &str) -> String {
    if text.chars().count() <= INPUT_WIDTH {
        return text.to_owned();
    }
    text.chars().take(INPUT_WIDTH - 1).chain(['…']).collect()
}

/// Every step of a sweep.
fn write_steps(text: &mut String, case: &Case) {
    let subject = &case.subject;
    let _ = writeln!(text, "\n{}: error of {}", subject.name, subject.error);
    let _ = writeln!(text, "  {:>12}  {:>10}  with", "at", "error");
    for step in &case.measurements {
        let mark = match (step.error <= subject.bound, subject.promised.holds(step.magnitude)) {
            (true, _) => "",
            (false, true) => "  beyond the bound",
            (false, false) => "  beyond the bound, and not promised",
        };
        let (at, error) = (short(step.magnitude), short(step.error));
        let _ = writeln!(text, "  {at:>12}  {error:>10}  {}{mark}", step.input);
    }
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
