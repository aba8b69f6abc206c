//! The chart of `skycube stress`: small multiples, one panel a case, error against magnitude, both logarithmic.
//!
//! ```text
//!   check-noise
//!    % |            ,'
//!      |- - - - - ,'- - -      The dashed line is the bound; the promised range is shaded. Errors of 0 lie on the floor,
//!      |::::::__,'             what is beyond all measure on the ceiling.
//!      |______________
//!       noise, codes of 255
//! ```

use clap::ValueEnum;

use super::super::chart::{Axis, Chart, Line, Panel, Style, draw_multiples};
use crate::stress::{Case, Group};

/// Labels of an axis of a small panel.
const MOST_LABELS: usize = 5;

/// The chart of cases.
pub fn draw_stress(cases: &[Case]) -> Chart {
    let members = |group: Group| cases.iter().filter(move |case| case.subject.group == group).map(panel).collect();
    let groups = Group::value_variants().iter().map(|&group| (group.title(), members(group)));
    let groups: Vec<(String, Vec<Panel>)> = groups.filter(|(_, panels): &(_, Vec<Panel>)| !panels.is_empty()).collect();
    let note = "dashed: the bound; shaded: where it is promised; on the floor: no error";
    draw_multiples("Errors and their bounds", note, &groups)
}

fn panel(case: &Case) -> Panel {
    let subject = &case.subject;
    let measured = || case.measurements.iter();
    let promised = [subject.promised.least, subject.promised.most];
    let x = Axis::around(subject.swept, measured().map(|step| step.magnitude)).thinned(MOST_LABELS);
    let errors = measured().map(|step| step.error).chain([subject.bound]);
    let y = Axis::around(subject.unit, errors).thinned(MOST_LABELS);
    let within = |error: f64| error.clamp(y.range[0], y.range[1]);
    let points = measured().map(|step| (step.magnitude, within(step.error))).collect();
    let mut lines = vec![Line { label: String::new(), style: Style::Series(0), points }];
    if subject.bound > 0.0 {
        let points = x.range.map(|end| (end, subject.bound)).to_vec();
        lines.push(Line { label: String::new(), style: Style::Bound, points });
    }
    Panel { title: subject.name.to_owned(), x, y, lines, shaded: Some(promised) }
}
