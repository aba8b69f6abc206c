//! The marks on a face of the compass: grid, name, arrows, names of the neighbours.

use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, PixmapMut, Stroke, Transform};

use super::compass::{FaceFrame, STRIP, opposite};
use super::text_drawing::{Anchor, text_path};

/// Marks are laid out on a square of this many units and scaled to the face.
const LAYOUT: f32 = 512.0;

/// Draws all marks of a face over its background. None touches the outer half of the border strip.
pub(super) fn draw_marks(pixmap: &mut PixmapMut, frame: &FaceFrame) {
    let scale = pixmap.width() as f32 / LAYOUT;
    let mut canvas = Canvas { pixmap, scale: Transform::from_scale(scale, scale) };
    draw_grid(&mut canvas);
    draw_grid_numbers(&mut canvas);
    draw_names(&mut canvas, frame);
    draw_neighbours(&mut canvas, frame);
    draw_arrows(&mut canvas);
}

/// Lines at the tenths and, fainter, the twentieths of u and v. Inside the borders only: a border texel shows the
/// strip alone.
fn draw_grid(canvas: &mut Canvas) {
    let margin = 0.5 * STRIP * 0.5 * LAYOUT;
    for line in 1..20 {
        let position = LAYOUT * line as f32 / 20.0;
        let opacity = if line % 2 == 0 { 0.55 } else { 0.2 };
        if position > margin && position < LAYOUT - margin {
            for ends in
                [[(position, margin), (position, LAYOUT - margin)], [(margin, position), (LAYOUT - margin, position)]]
            {
                canvas.line(&ends, 1.0, Color::from_rgba(1.0, 1.0, 1.0, opacity).expect("in range"));
            }
        }
    }
}

/// The values of u above the first line and of v to the left of it.
fn draw_grid_numbers(canvas: &mut Canvas) {
    for tenth in 1..10 {
        let position = LAYOUT * tenth as f32 / 10.0;
        let number = format!(".{tenth}");
        canvas.text(&number, 15.0, (position + 2.0, 48.0), 0.0, Anchor::Start);
        canvas.text(&number, 15.0, (49.0, position + 15.0), 0.0, Anchor::End);
    }
}

/// The axis and the file name in the middle.
fn draw_names(canvas: &mut Canvas, frame: &FaceFrame) {
    canvas.text(&frame.face.signed_name().to_uppercase(), 150.0, (266.0, 268.0), 0.0, Anchor::Middle);
    canvas.text(frame.face.name(), 62.0, (266.0, 326.0), 0.0, Anchor::Middle);
}

/// At each border the name of the face across it, its head towards the border.
fn draw_neighbours(canvas: &mut Canvas, frame: &FaceFrame) {
    let sides =
        [(opposite(frame.below), 0.0), (frame.right, 90.0), (frame.below, 180.0), (opposite(frame.right), 270.0)];
    for (neighbour, turn) in sides {
        let label = format!("{} {}", neighbour.signed_name().to_uppercase(), neighbour.name());
        canvas.text_towards_border(&label, 26.0, 92.0, turn);
    }
}

/// Arrows along growing u (to the right) and growing v (down), with their names.
fn draw_arrows(canvas: &mut Canvas) {
    canvas.arrow((150.0, 378.0), (362.0, 378.0));
    canvas.text("u", 44.0, (376.0, 389.0), 0.0, Anchor::Start);
    canvas.arrow((134.0, 150.0), (134.0, 336.0));
    canvas.text("v", 44.0, (134.0, 372.0), 0.0, Anchor::Middle);
}

/// Draws in layout units: white with a dark rim, readable on every colour.
struct Canvas<'a, 'b> {
    pixmap: &'a mut PixmapMut<'b>,
    scale: Transform,
}

impl Canvas<'_, '_> {
    /// A line of text turned clockwise by `turn` degrees (multiples of 90) about its anchor.
    fn text(&mut self, text: &str, size: f32, position: (f32, f32), turn: f32, anchor: Anchor) {
        let place = quarter_turn(turn).post_translate(position.0, position.1);
        if let Some(path) = text_path(text, size, anchor).and_then(|path| path.transform(place)) {
            self.rimmed(&path, 2.0 + size / 24.0);
        }
    }

    /// Text along the upper border, its baseline `depth` below it, turned with the whole face to another border.
    fn text_towards_border(&mut self, text: &str, size: f32, depth: f32, turn: f32) {
        let middle = 0.5 * LAYOUT;
        let from_middle = quarter_turn(turn).post_translate(middle, middle);
        let place = Transform::from_translate(0.0, depth - middle).post_concat(from_middle);
        if let Some(path) = text_path(text, size, Anchor::Middle).and_then(|path| path.transform(place)) {
            self.rimmed(&path, 2.0 + size / 24.0);
        }
    }

    /// A straight arrow with a filled head.
    fn arrow(&mut self, tail: (f32, f32), head: (f32, f32)) {
        const HALF_SHAFT: f32 = 4.0;
        const HALF_HEAD: f32 = 13.0;
        const HEAD_LENGTH: f32 = 30.0;
        let (dx, dy) = (head.0 - tail.0, head.1 - tail.1);
        let length = (dx * dx + dy * dy).sqrt();
        let (dx, dy) = (dx / length, dy / length);
        // Outline in coordinates along and to the side of the arrow.
        let neck = length - HEAD_LENGTH;
        let outline = [
            (0.0, -HALF_SHAFT),
            (neck, -HALF_SHAFT),
            (neck, -HALF_HEAD),
            (length, 0.0),
            (neck, HALF_HEAD),
            (neck, HALF_SHAFT),
            (0.0, HALF_SHAFT),
        ];
        let place = |(along, side): (f32, f32)| (tail.0 + along * dx - side * dy, tail.1 + along * dy + side * dx);
        let path = polygon(&outline.map(place), true);
        self.rimmed(&path, 4.0);
    }

    /// Fills a shape in white over a dark rim `rim` wide.
    fn rimmed(&mut self, path: &Path, rim: f32) {
        let stroke =
            Stroke { width: 2.0 * rim, line_join: LineJoin::Round, line_cap: LineCap::Round, ..Stroke::default() };
        self.pixmap.stroke_path(path, &paint(Color::from_rgba8(24, 22, 34, 255)), &stroke, self.scale, None);
        self.pixmap.fill_path(path, &paint(Color::WHITE), FillRule::Winding, self.scale, None);
    }

    fn line(&mut self, points: &[(f32, f32)], width: f32, colour: Color) {
        let stroke = Stroke { width, ..Stroke::default() };
        self.pixmap.stroke_path(&polygon(points, false), &paint(colour), &stroke, self.scale, None);
    }
}

/// A turn clockwise by a multiple of 90 degrees about the origin, exact (y points down).
fn quarter_turn(degrees: f32) -> Transform {
    match degrees {
        90.0 => Transform::from_row(0.0, 1.0, -1.0, 0.0, 0.0, 0.0),
        180.0 => Transform::from_row(-1.0, 0.0, 0.0, -1.0, 0.0, 0.0),
        270.0 => Transform::from_row(0.0, -1.0, 1.0, 0.0, 0.0, 0.0),
        _ => Transform::identity(),
    }
}

fn polygon(points: &[(f32, f32)], closed: bool) -> Path {
    let mut builder = PathBuilder::new();
    builder.move_to(points[0].0, points[0].1);
    for point in &points[1..] {
        builder.line_to(point.0, point.1);
    }
    if closed {
        builder.close();
    }
    builder.finish().expect("a polygon has points")
}

fn paint(colour: Color) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(colour);
    paint
}
