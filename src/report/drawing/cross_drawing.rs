//! The drawing of the unfolded cross: every cell seen through the lookup, seams, names, arrows of u and v.

use tiny_skia::{Color, StrokeDash};

use super::canvas::{Canvas, blank, broken_text, dark, displayed, ground};
use super::cross_layout::{CrossCell, CrossLayout};
use super::finished::Drawing;
use super::plate::{PlateLine, draw_plate};
use super::text_drawing::Anchor;
use super::verdict_colour::{repair_colour, verdict_colour};
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
    /// What to do about the picture that each face shows, in the order of [`Face::ALL`].
    pub repairs: &'a [Option<String>; 6],
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
        draw_labels(&mut canvas, input, cell);
    }
    for (edge, letter) in layout.torn() {
        for (cell, (x, y)) in layout.sides(edge) {
            // Beside the labels, where the side runs below them.
            let corner = free_corner(input, cell);
            let along = if y * corner.1 > 0.0 { -0.5 * corner.0 } else { 0.0 };
            draw_letter(&mut canvas, letter, place(cell, 0.82 * x + along, 0.82 * y));
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

/// The line along a side of a cell. Broken seams are hatched, and the wider, the larger the step: up to 14 units at ten times
/// the detail and more.
fn draw_seam(canvas: &mut Canvas, cell: &CrossCell, (x, y): (f32, f32), seam: &Seam) {
    let excess = (seam.score - 1.0).clamp(0.0, 9.0) as f32;
    let width = match seam.verdict {
        Verdict::Fits => 2.0,
        Verdict::Undecidable => 4.0,
        Verdict::Broken => 6.0 + 8.0 * excess / 9.0,
    };
    // Not quite to the corners, where other seams arrive.
    let ends = [-0.96, 0.96].map(|along| place(cell, x + along * y.abs(), y + along * x.abs()));
    draw_sample(canvas, ends, width, seam.verdict);
}

/// A line in the colours of a verdict.
fn draw_sample(canvas: &mut Canvas, ends: [(f32, f32); 2], width: f32, verdict: Verdict) {
    canvas.line(&ends, width + 2.0, Color::WHITE);
    canvas.line(&ends, width, verdict_colour(verdict));
    if verdict == Verdict::Broken {
        canvas.stroke(&ends, width, StrokeDash::new(vec![3.0, 7.0], 0.0), dark());
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
    let size = canvas.readable(18.0);
    canvas.disc((x, y), 0.67 * size, Color::from_rgba8(red, green, blue, 255));
    canvas.plain_text(&letter.to_string(), size, (x, y + 0.36 * size), Anchor::Middle, Color::WHITE);
}

/// Arrows along growing u and v from the corner where both are 0.
fn draw_axes(canvas: &mut Canvas, input: &CrossInput, cell: &CrossCell) {
    const INSET: f32 = 0.76;
    const LENGTH: f32 = 0.42;
    let (u, v) = axes(input, cell);
    let origin = (-INSET * (u.0 + v.0), -INSET * (u.1 + v.1));
    let along = |axis: (f32, f32), length: f32| place(cell, origin.0 + length * axis.0, origin.1 + length * axis.1);
    for (axis, name, colour) in [(u, "u", u_colour()), (v, "v", v_colour())] {
        canvas.arrow(along(axis, 0.0), along(axis, LENGTH), 0.5, colour);
        let (x, y) = along(axis, LENGTH + 0.09);
        let size = canvas.readable(20.0);
        canvas.text(name, size, (x, y + 0.27 * size), 0.0, Anchor::Middle);
    }
    canvas.disc(along(u, 0.0), 4.0, Color::WHITE);
}

/// Where u and v grow in a cell.
fn axes(input: &CrossInput, cell: &CrossCell) -> ((f32, f32), (f32, f32)) {
    let row = input.map.lookup().row(cell.shot.direction);
    (cell.on_screen(row.u), cell.on_screen(row.v))
}

fn u_colour() -> Color {
    Color::from_rgba8(255, 200, 120, 255)
}

fn v_colour() -> Color {
    Color::from_rgba8(150, 215, 255, 255)
}

/// Name, file and repair of a face in the corner that the axes leave free, off the horizon; a face to be repaired is framed.
fn draw_labels(canvas: &mut Canvas, input: &CrossInput, cell: &CrossCell) {
    let face = cell.shot.direction;
    let repair = &input.repairs[face.index()];
    if repair.is_some() {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
        let frame = corners.map(|(x, y)| place(cell, 0.9 * x, 0.9 * y));
        canvas.line(&frame, 5.0, Color::WHITE);
        canvas.line(&frame, 3.0, verdict_colour(Verdict::Broken));
    }
    let name = face.signed_name().to_uppercase();
    let mut lines = vec![PlateLine { text: &name, size: 20.0, colour: Color::WHITE }];
    // On the smallest drawings readable words would hide the picture.
    if canvas.readable(13.0) < 20.0 {
        lines.push(PlateLine { text: &input.files[face.index()], size: 13.0, colour: Color::WHITE });
        let repair = repair.as_deref().unwrap_or_default();
        lines.push(PlateLine { text: repair, size: 15.0, colour: repair_colour() });
    }
    let (x, y) = free_corner(input, cell);
    draw_plate(canvas, &lines, place(cell, 0.88 * x, 0.88 * y), (-x, -y), 0.58 * CELL);
}

/// The corner across from that where u and v are 0: its signs, to the right and down.
fn free_corner(input: &CrossInput, cell: &CrossCell) -> (f32, f32) {
    let (u, v) = axes(input, cell);
    (u.0 + v.0, u.1 + v.1)
}

/// Left border of the two empty fields at the right of top and bottom.
const LEFT: f32 = MARGIN + 2.0 * CELL + 32.0;

/// Left border of the words beside a sample.
const WORDS: f32 = LEFT + 50.0;

/// Draws what a sentence of the legend is about, at a height.
type Sample<'a> = &'a dyn Fn(&mut Canvas, f32);

/// Sentences in dark text on the ground of the drawing, from top to bottom; what has no room as a whole is left out.
struct Legend<'a, 'b> {
    canvas: &'a mut Canvas<'b>,
    /// Where the next line begins.
    y: f32,
    /// Where the field ends.
    bottom: f32,
}

impl Legend<'_, '_> {
    /// Writes a sentence beside the sample that `draw` puts at a height, if there is one.
    fn line(&mut self, text: &str, size: f32, draw: Option<Sample>) {
        let left = if draw.is_some() { WORDS } else { LEFT };
        let letters = self.canvas.readable(size);
        let lines = broken_text(text, letters, MARGIN + 4.0 * CELL - left);
        let first = self.y + 1.6 * letters;
        self.y += (0.3 + 1.3 * lines.len() as f32) * letters;
        if self.y > self.bottom {
            return;
        }
        for (index, line) in lines.iter().enumerate() {
            let y = first + 1.3 * letters * index as f32;
            self.canvas.plain_text(line, letters, (left, y), Anchor::Start, dark());
        }
        if let Some(draw) = draw {
            draw(self.canvas, first - 0.35 * letters);
        }
    }
}

/// Heading at the upper right, legend at the lower right.
fn draw_legend(canvas: &mut Canvas, input: &CrossInput) {
    let World { up, handedness } = input.world();
    let hand = if handedness == Handedness::Left { ", left-handed" } else { "" };
    let mut top = Legend { canvas, y: 12.0, bottom: MARGIN + CELL };
    top.line(input.heading, 24.0, None);
    top.line(&format!("{up} up, front {}{hand}; seen from inside", input.world().front()), 17.0, None);
    top.line(&mirrored(input.map.lookup()), 17.0, None);

    let mut bottom = Legend { canvas, y: MARGIN + 2.0 * CELL + 14.0, bottom: 2.0 * MARGIN + 3.0 * CELL };
    for verdict in [Verdict::Fits, Verdict::Broken, Verdict::Undecidable] {
        let alike = input.seams.iter().filter(|seam| seam.verdict == verdict);
        let names: Vec<String> = alike.map(|seam| seam.edge.name()).collect();
        if names.is_empty() {
            continue;
        }
        let names = if names.len() == 12 { "all twelve".to_owned() } else { names.join(" ") };
        let sample = |canvas: &mut Canvas, y: f32| draw_sample(canvas, [(LEFT, y), (LEFT + 40.0, y)], 6.0, verdict);
        bottom.line(&format!("seam {}: {names}", verdict.name()), 17.0, Some(&sample));
    }
    if input.seams.iter().any(|seam| seam.verdict == Verdict::Broken) {
        bottom.line("the wider, the larger the step across the seam", 15.0, None);
    }
    let letter = |canvas: &mut Canvas, y: f32| draw_letter(canvas, 'A', (LEFT + 14.0, y));
    bottom.line("sides with one letter are the same edge of the cube", 17.0, Some(&letter));
    let arrows = |canvas: &mut Canvas, y: f32| {
        canvas.arrow((LEFT, y), (LEFT + 18.0, y), 0.35, u_colour());
        canvas.arrow((LEFT + 24.0, y), (LEFT + 42.0, y), 0.35, v_colour());
    };
    bottom.line("growing u and v, from the corner u = v = 0", 17.0, Some(&arrows));
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
