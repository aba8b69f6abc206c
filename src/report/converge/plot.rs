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
use super::measure::Measure;
use super::report::{ConvergeReport, ConvergedScene};
use crate::converge::{Curve, Step};
use crate::math::functions::power_f64;

/// The chart of a report.
pub fn draw_convergence(report: &ConvergeReport, measure: Measure) -> Chart {
    let names: Vec<&str> = report.scenes.iter().map(|scene| scene.name.as_str()).collect();
    let title = format!("Error against cost: {}", names.join(", "));
    let mut by_samples = panel(report, measure, "samples per pixel", |step| f64::from(step.samples));
    label_at_steps(&mut by_samples);
    let by_seconds = panel(report, measure, "seconds", |step| step.seconds);
    draw_panels(&title, &[by_samples, by_seconds], true)
}

fn panel(report: &ConvergeReport, measure: Measure, title: &'static str, cost: fn(&Step) -> f64) -> Panel {
    let point = |step: &Step| (cost(step), measure.of(&step.errors));
    // What a logarithmic axis can show.
    let shown = |(x, y): &(f64, f64)| [x, y].iter().all(|value| **value > 0.0 && value.is_finite());
    let scenes = report.scenes.iter();
    let curves = scenes.flat_map(|scene| scene.convergence.curves.iter().map(move |curve| (scene, curve)));
    let line = |(index, (scene, curve)): (usize, (&ConvergedScene, &Curve))| Line {
        label: label(report, measure, scene, curve),
        style: Style::Series(index),
        points: curve.steps.iter().map(point).filter(shown).collect(),
    };
    let mut lines: Vec<Line> = curves.enumerate().map(line).collect();
    let points = || lines.iter().flat_map(|line| &line.points);
    let floors = floors(report, measure);
    let x = Axis::around(title, points().map(|point| point.0));
    let y = Axis::around(measure.title(), points().map(|point| point.1).chain(floors.iter().copied()));
    let first = lines.iter().filter_map(|line| line.points.first().copied());
    let worst = first.max_by(|one, other| one.1.total_cmp(&other.1));
    lines.extend(worst.map(|start| law(start, measure, &x, &y)));
    for (index, floor) in floors.into_iter().enumerate() {
        let label = if index == 0 { "error of the reference" } else { "" };
        let points = x.range.map(|end| (end, floor)).to_vec();
        lines.push(Line { label: label.to_owned(), style: Style::Floor, points });
    }
    Panel { title: String::new(), x, y, lines, shaded: None }
}

/// What the legend calls a curve.
fn label(report: &ConvergeReport, measure: Measure, scene: &ConvergedScene, curve: &Curve) -> String {
    let slope = curve.fit.against_samples.filter(|_| measure == Measure::Rmse);
    let slope = slope.map_or_else(String::new, |slope| format!("  (slope {slope:.2})"));
    match (report.scenes.len(), curve.label.as_str()) {
        (1, _) => format!("{}{slope}", scene.label(curve)),
        (_, "") => format!("{}{slope}", scene.name),
        (_, label) => format!("{}: {label}{slope}", scene.name),
    }
}

/// The errors of the references themselves, each value once.
fn floors(report: &ConvergeReport, measure: Measure) -> Vec<f64> {
    let references = report.scenes.iter().flat_map(|scene| &scene.convergence.references);
    let mut floors: Vec<f64> = references.map(|reference| measure.of(&reference.errors)).collect();
    floors.retain(|floor| *floor > 0.0 && floor.is_finite());
    floors.dedup();
    floors
}

/// How an error falls with independent samples, from a point as far as the right or the lower border.
fn law((x, y): (f64, f64), measure: Measure, across: &Axis, up: &Axis) -> Line {
    let (exponent, label) = measure.law();
    let lowest = x * power_f64(up.range[0] / y, 1.0 / exponent);
    let end = across.range[1].min(lowest);
    let points = vec![(x, y), (end, y * power_f64(end / x, exponent))];
    Line { label: label.to_owned(), style: Style::Law, points }
}

/// Labels the horizontal axis where it was measured, if all steps find room.
fn label_at_steps(panel: &mut Panel) {
    let measured = panel.lines.iter().filter(|line| matches!(line.style, Style::Series(_)));
    let mut steps: Vec<f64> = measured.flat_map(|line| &line.points).map(|point| point.0).collect();
    steps.sort_by(f64::total_cmp);
    steps.dedup();
    let spread = steps.windows(2).all(|pair| pair[1] >= 2.0 * pair[0]);
    if spread && (1..=8).contains(&steps.len()) {
        panel.x.ticks = steps;
    }
}
