//! A dark plate with a few words, in a corner of a picture where it hides least.

use tiny_skia::Color;

use super::canvas::Canvas;
use super::text_drawing::{Anchor, text_width};

/// What a plate says.
#[derive(Debug, Clone)]
pub struct PlateLine<'a> {
    pub text: &'a str,
    /// Of the letters, in units.
    pub size: f32,
    pub colour: Color,
}

/// Blank around the text in units.
const BORDER: f32 = 5.0;

/// A plate as wide as `width` at most, with a corner at `(x, y)`, from where it grows by the signs of `towards`: to the right
/// if the first is positive, downwards if the second is. Long lines are broken at blanks,
/// long words are smaller.
pub fn draw_plate(canvas: &mut Canvas, lines: &[PlateLine], (x, y): (f32, f32), towards: (f32, f32), width: f32) {
    let room = width - 2.0 * BORDER;
    let broken = lines.iter().flat_map(|line| {
        let longest = line.text.split_whitespace().map(|word| text_width(word, line.size)).fold(room, f32::max);
        let size = canvas.readable(line.size * room / longest);
        canvas.broken_text(line.text, size, room).into_iter().map(move |text| (text, size, line.colour))
    });
    let rows: Vec<(String, f32, Color)> = broken.collect();
    let widest = rows.iter().map(|(text, size, _)| text_width(text, *size)).fold(0.0, f32::max);
    let height = rows.iter().map(|(_, size, _)| line_height(*size)).sum::<f32>() + BORDER;
    let (right, down) = (widest.min(room) + 2.0 * BORDER, height + BORDER);
    let left = if towards.0 > 0.0 { x } else { x - right };
    let top = if towards.1 > 0.0 { y } else { y - down };
    if rows.is_empty() {
        return;
    }
    canvas.plate([left, top, left + right, top + down], Color::from_rgba8(24, 22, 34, 215));
    let mut baseline = top + BORDER;
    for (text, size, colour) in &rows {
        baseline += line_height(*size);
        canvas.plain_text(text, *size, (left + right / 2.0, baseline - 0.2 * size), Anchor::Middle, *colour);
    }
}

fn line_height(size: f32) -> f32 {
    1.2 * size
}
