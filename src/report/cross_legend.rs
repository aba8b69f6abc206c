//! The words beside the unfolded cross.

use super::canvas::{Canvas, dark};
use super::cross_drawing::{CELL, CrossInput, MARGIN, draw_letter, note, u_colour, v_colour};
use super::seam_mark::{SeamMark, verdict_colour};
use crate::envmap::{Face, Lookup};
use crate::render::front;
use crate::validate::Verdict;

/// Left border of the two empty fields at the right of top and bottom.
const LEFT: f32 = MARGIN + 2.0 * CELL + 32.0;

/// Left border of the words beside a sample.
const WORDS: f32 = LEFT + 50.0;

/// Heading at the upper right, legend at the lower right.
pub(super) fn draw_legend(canvas: &mut Canvas, input: &CrossInput) {
    let top = MARGIN;
    note(canvas, input.heading, 24.0, (LEFT, top + 26.0));
    let up = input.world_up;
    note(canvas, &format!("{up} up, front {}; seen from inside", front(up)), 17.0, (LEFT, top + 56.0));
    note(canvas, &mirrored(input.map.lookup()), 17.0, (LEFT, top + 82.0));
    let bottom = MARGIN + 2.0 * CELL + 44.0;
    let rows = [Verdict::Fits, Verdict::Broken, Verdict::Undecidable];
    let shown = rows.into_iter().filter(|row| input.marks.iter().any(|mark| mark.verdict == *row));
    let mut y = bottom;
    for verdict in shown {
        let ends = [(LEFT, y - 6.0), (LEFT + 40.0, y - 6.0)];
        canvas.line(&ends, 8.0, dark());
        canvas.line(&ends, 6.0, verdict_colour(verdict));
        let edges = edges(input.marks, verdict);
        note(canvas, &format!("seam {}: {edges}", verdict.name()), 17.0, (WORDS, y));
        y += 26.0;
    }
    note(canvas, "the wider, the larger the step across against the steps beside it", 15.0, (LEFT, y));
    y += 30.0;
    draw_letter(canvas, 'A', (LEFT + 14.0, y - 6.0));
    note(canvas, "sides with one letter are the same edge of the cube", 17.0, (WORDS, y));
    y += 30.0;
    canvas.arrow((LEFT, y - 6.0), (LEFT + 18.0, y - 6.0), 0.35, u_colour());
    canvas.arrow((LEFT + 24.0, y - 6.0), (LEFT + 42.0, y - 6.0), 0.35, v_colour());
    note(canvas, "growing u and v, from the corner u = v = 0", 17.0, (WORDS, y));
}

/// A sentence on handedness.
fn mirrored(lookup: &Lookup) -> String {
    let mirrored: Vec<&str> =
        Face::ALL.into_iter().filter(|&face| lookup.mirrors(face)).map(Face::signed_name).collect();
    match mirrored.len() {
        0 => "the lookup mirrors no face".to_owned(),
        6 => "the lookup mirrors all six faces".to_owned(),
        _ => format!("the lookup mirrors {}", mirrored.join(" ")),
    }
}

/// `all twelve`, or their names.
fn edges(marks: &[SeamMark], verdict: Verdict) -> String {
    let alike: Vec<String> = marks
        .iter()
        .filter(|mark| mark.verdict == verdict)
        .map(|mark| mark.edge.map(Face::signed_name).concat())
        .collect();
    if alike.len() == 12 { "all twelve".to_owned() } else { alike.join(" ") }
}
