//! The drawing of the unfolded cross: every cell seen through the lookup, seams, names, arrows of u and v.

use tiny_skia::Color;

use super::canvas::{Canvas, blank, dark, displayed, ground};
use super::cross_layout::{CrossCell, CrossLayout};
use super::finished::Drawing;
use super::text_drawing::{Anchor, text_width};
use crate::colour::ToneMap;
use crate::envmap::{CubeMap, Face, Handedness, Lookup, SignedAxis, World};
use crate::parallel;
use crate::validate::{Seam, Verdict};

/// Side of a cell in the units of the drawing.
const CELL: f32 = 256.0;
const MARGIN: f32 = 24.0;

/// What the cross of a map is drawn from.
#[derive(Debug, Clone, Copy)]
pub struct CrossInput<'a> {
    pub map: &'a CubeMap,
    pub world_up: SignedAxis,
    /// The file that each face reads, in the order of [`Face::ALL`].
    pub files: &'a [String; 6],
    /// Under the lookup of the map, in any order.
    pub seams: &'a [Seam],
    pub heading: &'a str,
    /// Side of a cell in pixels.
    pub cell: usize,
    pub tone_map: ToneMap,
}

impl CrossInput<'_> {
    /// The world that the lookup is for.
    fn world(&self) -> World {
        World { up: self.world_up, handedness: self.map.lookup().handedness() }
    }
}

/// Draws the cross. Pictures that cannot be decoded are black; [`CubeMap::errors`] tells.
pub fn draw_cross(input: &CrossInput) -> Drawing {
    let layout = CrossLayout::new(input.world());
    let scale = input.cell as f32 / CELL;
    let margin = (MARGIN * scale).round() as usize;
    let [width, height] = [4, 3].map(|cells| cells * input.cell + 2 * margin);
    let mut pixmap = blank(width, height, ground());
    let mut canvas = Canvas::new(pixmap.as_mut(), scale);
    let views = parallel::map(&layout.cells, |cell| cell.shot.of_map(input.map, input.cell));
    for (cell, view) in layout.cells.iter().zip(&views) {
        let place = [cell.column, cell.row].map(|index| margin + index * input.cell);
        canvas.picture(&displayed(view, input.tone_map), place);
    }
    for seam in input.seams {
        // At both its sides where the cross tears it apart.
        let drawn = if layout.joins(seam.edge) { 1 } else { 2 };
        for (cell, side) in layout.sides(seam.edge).into_iter().take(drawn) {
            draw_seam(&mut canvas, cell, side, seam);
        }
    }
    for cell in &layout.cells {
        draw_axes(&mut canvas, input, cell);
        draw_name(&mut canvas, cell, &input.files[cell.shot.direction.index()]);
    }
    for (edge, letter) in layout.torn() {
        for (cell, (x, y)) in layout.sides(edge) {
            draw_letter(&mut canvas, letter, place(cell, 0.82 * x, 0.82 * y));
        }
    }
    draw_legend(&mut canvas, input);
    Drawing(pixmap)
}

/// The top left corner of a cell in units.
fn corner(cell: &CrossCell) -> (f32, f32) {
    (MARGIN + CELL * cell.column as f32, MARGIN + CELL * cell.row as f32)
}

/// A place in a cell from its middle: `right` and `down` in half cells.
fn place(cell: &CrossCell, right: f32, down: f32) -> (f32, f32) {
    let (x, y) = corner(cell);
    (x + CELL * (1.0 + right) / 2.0, y + CELL * (1.0 + down) / 2.0)
}

/// The line along a side of a cell: the wider, the worse; from 2 units up to 14 at ten times the detail and more.
fn draw_seam(canvas: &mut Canvas, cell: &CrossCell, (x, y): (f32, f32), seam: &Seam) {
    let excess = (seam.score - 1.0).clamp(0.0, 9.0) as f32;
    let width = 2.0 + 12.0 * excess / 9.0;
    // Not quite to the corners, where other seams arrive.
    let ends = [-0.96, 0.96].map(|along| place(cell, x + along * y.abs(), y + along * x.abs()));
    canvas.line(&ends, width + 2.0, dark());
    canvas.line(&ends, width, verdict_colour(seam.verdict));
}

/// Green, red, amber.
fn verdict_colour(verdict: Verdict) -> Color {
    match verdict {
        Verdict::Fits => Color::from_rgba8(60, 200, 90, 255),
        Verdict::Broken => Color::from_rgba8(240, 50, 40, 255),
        Verdict::Undecidable => Color::from_rgba8(250, 190, 30, 255),
    }
}

/// A disc with a letter, in the letter's own colour.
fn draw_letter(canvas: &mut Canvas, letter: char, (x, y): (f32, f32)) {
    const COLOURS: [[u8; 3]; 7] = [
        [228, 90, 200],
        [70, 130, 240],
        [20, 160, 160],
        [150, 90, 220],
        [140, 100, 60],
        [90, 110, 130],
        [110, 130, 30],
    ];
    let [red, green, blue] = COLOURS[letter as usize - 'A' as usize];
    canvas.disc((x, y), 12.0, Color::from_rgba8(red, green, blue, 255));
    canvas.plain_text(&letter.to_string(), 18.0, (x, y + 6.5), Anchor::Middle, Color::WHITE);
}

/// Arrows along growing u and v from the corner where both are 0.
fn draw_axes(canvas: &mut Canvas, input: &CrossInput, cell: &CrossCell) {
    const INSET: f32 = 0.76;
    const LENGTH: f32 = 0.42;
    let row = input.map.lookup().row(cell.shot.direction);
    let (u, v) = (cell.on_screen(row.u), cell.on_screen(row.v));
    let origin = (-INSET * (u.0 + v.0), -INSET * (u.1 + v.1));
    let along = |axis: (f32, f32), length: f32| place(cell, origin.0 + length * axis.0, origin.1 + length * axis.1);
    for (axis, name, colour) in [(u, "u", u_colour()), (v, "v", v_colour())] {
        canvas.arrow(along(axis, 0.0), along(axis, LENGTH), 0.5, colour);
        let (x, y) = along(axis, LENGTH + 0.09);
        canvas.text(name, 20.0, (x, y + 5.5), 0.0, Anchor::Middle);
    }
    canvas.disc(along(u, 0.0), 4.0, Color::WHITE);
}

fn u_colour() -> Color {
    Color::from_rgba8(255, 200, 120, 255)
}

fn v_colour() -> Color {
    Color::from_rgba8(150, 215, 255, 255)
}

/// The face's name and file on a dark plate below the middle.
fn draw_name(canvas: &mut Canvas, cell: &CrossCell, file: &str) {
    let (x, y) = corner(cell);
    canvas.plate([x + 54.0, y + 160.0, x + 202.0, y + 210.0], Color::from_rgba8(24, 22, 34, 205));
    let name = cell.shot.direction.signed_name().to_uppercase();
    canvas.plain_text(&name, 26.0, (x + 128.0, y + 184.0), Anchor::Middle, Color::WHITE);
    let size = 14.0_f32.min(14.0 * 138.0 / text_width(file, 14.0).max(1.0));
    canvas.plain_text(file, size, (x + 128.0, y + 203.0), Anchor::Middle, Color::WHITE);
}

/// A line of dark text on the ground of the drawing.
fn note(canvas: &mut Canvas, text: &str, size: f32, position: (f32, f32)) {
    canvas.fitted_text(text, size, position, MARGIN + 4.0 * CELL - position.0);
}

/// Left border of the two empty fields at the right of top and bottom.
const LEFT: f32 = MARGIN + 2.0 * CELL + 32.0;

/// Left border of the words beside a sample.
const WORDS: f32 = LEFT + 50.0;

/// Heading at the upper right, legend at the lower right.
fn draw_legend(canvas: &mut Canvas, input: &CrossInput) {
    let top = MARGIN;
    note(canvas, input.heading, 24.0, (LEFT, top + 26.0));
    let World { up, handedness } = input.world();
    let hand = if handedness == Handedness::Left { ", left-handed" } else { "" };
    let view = format!("{up} up, front {}{hand}; seen from inside", input.world().front());
    note(canvas, &view, 17.0, (LEFT, top + 56.0));
    note(canvas, &mirrored(input.map.lookup()), 17.0, (LEFT, top + 82.0));
    let mut y = MARGIN + 2.0 * CELL + 44.0;
    for verdict in [Verdict::Fits, Verdict::Broken, Verdict::Undecidable] {
        let alike = input.seams.iter().filter(|seam| seam.verdict == verdict);
        let names: Vec<String> = alike.map(|seam| seam.edge.name()).collect();
        if names.is_empty() {
            continue;
        }
        let ends = [(LEFT, y - 6.0), (LEFT + 40.0, y - 6.0)];
        canvas.line(&ends, 8.0, dark());
        canvas.line(&ends, 6.0, verdict_colour(verdict));
        let names = if names.len() == 12 { "all twelve".to_owned() } else { names.join(" ") };
        note(canvas, &format!("seam {}: {names}", verdict.name()), 17.0, (WORDS, y));
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
