//! Text on drawings: outlines of Noto Sans, filled by `tiny-skia`.

use std::sync::LazyLock;

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, OutlineBuilder};

/// Noto Sans Regular, Apache License 2.0, built into the binary. It holds Latin, Greek and Cyrillic.
static FONT: LazyLock<Face<'static>> =
    LazyLock::new(|| Face::parse(ttf_noto_sans::REGULAR, 0).expect("the built-in font is well formed"));

/// Which point of the line of text lies at the given position, horizontally. Vertically it is the baseline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The left end.
    Start,
    /// The middle.
    Middle,
    /// The right end.
    End,
}

/// Width of a line of text in pixels at font size `size` (pixels an em).
pub fn text_width(text: &str, size: f32) -> f32 {
    text.chars().map(advance).sum::<f32>() * scale(size)
}

/// Outline of a line of text: its anchor at the origin, the baseline along x, y downwards, in pixels.
///
/// None if there is nothing to fill (an empty or blank text). A character the font does not hold gives its empty box.
pub fn text_path(text: &str, size: f32, anchor: Anchor) -> Option<Path> {
    let width = text_width(text, size);
    let start = match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * width,
        Anchor::End => -width,
    };
    let mut pen = Pen { builder: PathBuilder::new(), x: start, scale: scale(size) };
    for character in text.chars() {
        FONT.outline_glyph(FONT.glyph_index(character).unwrap_or_default(), &mut pen);
        pen.x += advance(character) * pen.scale;
    }
    pen.builder.finish()
}

/// Pixels a font unit.
fn scale(size: f32) -> f32 {
    size / f32::from(FONT.units_per_em())
}

/// How far the next glyph lies, in font units.
fn advance(character: char) -> f32 {
    let glyph = FONT.glyph_index(character).unwrap_or_default();
    f32::from(FONT.glyph_hor_advance(glyph).unwrap_or(0))
}

/// Takes outlines in font units (y upwards) and draws them at `x` in pixels (y downwards).
struct Pen {
    builder: PathBuilder,
    x: f32,
    scale: f32,
}

impl Pen {
    fn place(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + self.scale * x, -self.scale * y)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.builder.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.builder.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.place(x1, y1), self.place(x, y));
        self.builder.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        self.builder.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}
