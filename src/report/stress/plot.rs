//! The chart of `skycube stress`: error over bound against magnitude, both logarithmic, one panel per group, one line
//! per case.
//!
//! ```text
//!   1000 |            ,'
//!        |          ,'            Above the red line the error is beyond its bound. Where the bound is 0 faults of a
//!      1 |--------,'------        million rays are drawn instead: any fault is on the line or above.
//!        |  ___,-'
//!  1e-10 |_________________       Smaller errors and 0 lie on the floor.
//! ```

use clap::ValueEnum;

use super::super::chart::{Axis, Chart, Line, Panel, Style, draw_panels};
use crate::stress::{Case, Group};

/// Errors over their bounds that are drawn as they are.
const RANGE: [f64; 2] = [1e-10, 1e6];

/// The chart of cases.
pub fn draw_stress(cases: &[Case]) -> Chart {
    let members = |group: Group| cases.iter().filter(|case| case.subject.group == group).collect::<Vec<_>>();
    let groups = Group::value_variants().iter().map(|&group| (group, members(group)));
    let panels: Vec<Panel> =
        groups.filter(|(_, members)| !members.is_empty()).map(|(group, members)| panel(group, &members)).collect();
    draw_panels("Errors against their bounds", &panels, false)
}

fn panel(group: Group, cases: &[&Case]) -> Panel {
    let magnitudes = cases.iter().flat_map(|case| &case.measurements).map(|step| step.magnitude);
    let x = Axis::around("magnitude", magnitudes);
    let y = Axis::between("error / bound, or faults per million; 1e-10: or less", RANGE);
    let line = |(number, case): (usize, &&Case)| Line {
        label: case.subject.name.to_owned(),
        style: Style::Series(number),
        points: case
            .measurements
            .iter()
            .map(|step| (step.magnitude, over_bound(step.error, case.subject.bound)))
            .collect(),
    };
    let bound = Line { label: String::new(), style: Style::Bound, points: x.range.map(|end| (end, 1.0)).to_vec() };
    let lines = cases.iter().enumerate().map(line).chain([bound]).collect();
    Panel { title: group.title(), x, y, lines }
}

/// The error over the bound; faults of a million, if none are allowed.
fn over_bound(error: f64, bound: f64) -> f64 {
    let ratio = match bound {
        _ if error == 0.0 => 0.0,
        0.0 => error.max(1.0),
        _ => error / bound,
    };
    ratio.clamp(RANGE[0], RANGE[1])
}
