//! The marks on a face of the compass: grid, name, arrows, names of the neighbours.

use tiny_skia::{Color, PixmapMut, Transform};

use super::canvas::{Canvas, quarter_turn};
use super::compass::{FaceFrame, STRIP, opposite};
use super::text_drawing::Anchor;

/// Marks are laid out on a square of this many units and scaled to the face.
const LAYOUT: f32 = 512.0;

/// Draws all marks of a face over its background. None touches the outer half of the border strip.
pub(super) fn draw_marks(pixmap: PixmapMut, frame: &FaceFrame) {
    let scale = pixmap.width() as f32 / LAYOUT;
    let mut canvas = Canvas::new(pixmap, scale);
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
        draw_text_towards_border(canvas, &label, 26.0, 92.0, turn);
    }
}

/// Arrows along growing u (to the right) and growing v (down), with their names.
fn draw_arrows(canvas: &mut Canvas) {
    canvas.arrow((150.0, 378.0), (362.0, 378.0), 1.0, Color::WHITE);
    canvas.text("u", 44.0, (376.0, 389.0), 0.0, Anchor::Start);
    canvas.arrow((134.0, 150.0), (134.0, 336.0), 1.0, Color::WHITE);
    canvas.text("v", 44.0, (134.0, 372.0), 0.0, Anchor::Middle);
}

/// Text along the upper border, its baseline `depth` below it, turned with the whole face to another border.
fn draw_text_towards_border(canvas: &mut Canvas, text: &str, size: f32, depth: f32, turn: f32) {
    let middle = 0.5 * LAYOUT;
    let from_middle = quarter_turn(turn).post_translate(middle, middle);
    let place = Transform::from_translate(0.0, depth - middle).post_concat(from_middle);
    canvas.text_placed(text, size, Anchor::Middle, place);
}
