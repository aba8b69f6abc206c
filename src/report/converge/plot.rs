//! The convergence chart: error against samples and against time, all axes logarithmic.
//!
//! ```text
//!   +------------------+  +------------------+
//!   | error            |  | error            |
//!   |   \_             |  |  \               |
//!   |     \__ samples  |  |   \__ seconds    |
//!   +------------------+  +------------------+
//!     -- variant   -- variant   - - reference
//! ```

use super::super::chart::{Axis, Chart, Line, Panel, Style, draw_panels};
use super::report::ConvergeReport;
use super::series::{Cost, Measure, Series, floors, series};
use crate::math::functions::power_f64;

/// The chart of a report.
pub fn draw_convergence(report: &ConvergeReport, measure: Measure) -> Chart {
    let names: Vec<&str> = report.scenes.iter().map(|scene| scene.name.as_str()).collect();
    let title = format!("Error against cost: {}", names.join(", "));
    let (series, floors) = (series(report, measure), floors(report, measure));
    let panels = [Cost::Samples, Cost::Seconds].map(|cost| panel(&series, &floors, measure, cost));
    draw_panels(&title, &panels, true)
}

fn panel(series: &[Series], floors: &[f64], measure: Measure, cost: Cost) -> Panel {
    let points: Vec<(f64, f64)> = series.iter().flat_map(|line| line.points(cost)).collect();
    let x = Axis::around(cost.title(), points.iter().map(|point| point.0));
    let x = if cost == Cost::Samples { labelled_at_steps(x, &points) } else { x };
    let y = Axis::around(measure.title(), points.iter().map(|point| point.1).chain(floors.iter().copied()));
    let numbered = series.iter().enumerate();
    let measured = numbered.map(|(index, line)| Line {
        label: line.label.clone(),
        style: Style::Series(index),
        points: line.points(cost),
    });
    let mut lines: Vec<Line> = measured.collect();
    let first = series.iter().filter_map(|line| line.points(cost).first().copied());
    let worst = first.max_by(|one, other| one.1.total_cmp(&other.1));
    lines.extend(worst.map(|start| law(start, measure, &x, &y)));
    for (index, &floor) in floors.iter().enumerate() {
        let label = if index == 0 { "error of the reference" } else { "" };
        let points = x.range.map(|end| (end, floor)).to_vec();
        lines.push(Line { label: label.to_owned(), style: Style::Floor, points });
    }
    Panel { title: String::new(), x, y, lines }
}

/// How an error falls with independent samples, from a point as far as the right or the lower border.
fn law((x, y): (f64, f64), measure: Measure, across: &Axis, up: &Axis) -> Line {
    let (exponent, label) = measure.law();
    let lowest = x * power_f64(up.range[0] / y, 1.0 / exponent);
    let end = across.range[1].min(lowest);
    let points = vec![(x, y), (end, y * power_f64(end / x, exponent))];
    Line { label: label.to_owned(), style: Style::Law, points }
}

/// The samples axis is labelled where it was measured, if all steps find room.
fn labelled_at_steps(axis: Axis, points: &[(f64, f64)]) -> Axis {
    let mut steps: Vec<f64> = points.iter().map(|point| point.0).collect();
    steps.sort_by(f64::total_cmp);
    steps.dedup();
    let spread = steps.windows(2).all(|pair| pair[1] >= 2.0 * pair[0]);
    if spread && (1..=8).contains(&steps.len()) { axis.labelled_at(steps) } else { axis }
}
