//! The elements of drawings: text, arrows, lines, plates, pictures.

use tiny_skia::{
    Color, FillRule, IntSize, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapMut, PixmapPaint, Rect,
    Stroke, StrokeDash, Transform,
};

use super::text_drawing::{Anchor, text_path, text_width};
use crate::colour::ToneMap;
use crate::picture::{Raster, display_bytes};

/// The dark that rims and plates are made of.
pub(in crate::report) fn dark() -> Color {
    Color::from_rgba8(24, 22, 34, 255)
}

/// The smallest letters that can be read, in pixels an em.
const SMALLEST: f32 = 11.0;

/// Draws on a pixmap in layout units: a scale makes one layout serve all sizes. Y points down.
pub(in crate::report) struct Canvas<'a> {
    pixmap: PixmapMut<'a>,
    scale: Transform,
}

impl<'a> Canvas<'a> {
    /// A canvas whose unit is `scale` pixels.
    pub fn new(pixmap: PixmapMut<'a>, scale: f32) -> Self {
        Self { pixmap, scale: Transform::from_scale(scale, scale) }
    }

    /// A line of text, white with a dark rim, readable on every colour; turned clockwise by `turn` degrees (multiples
    /// of 90) about its anchor.
    pub fn text(&mut self, text: &str, size: f32, position: (f32, f32), turn: f32, anchor: Anchor) {
        if let Some(path) = placed_text(text, size, position, turn, anchor) {
            self.rimmed(&path, 2.0 + size / 24.0, Color::WHITE);
        }
    }

    /// A line of text without a rim, for a ground of one colour.
    pub fn plain_text(&mut self, text: &str, size: f32, position: (f32, f32), anchor: Anchor, colour: Color) {
        self.turned_text(text, size, position, 0.0, anchor, colour);
    }

    /// The same, turned clockwise by `turn` degrees (multiples of 90) about its anchor.
    pub fn turned_text(&mut self, text: &str, size: f32, place: (f32, f32), turn: f32, anchor: Anchor, colour: Color) {
        if let Some(path) = placed_text(text, size, place, turn, anchor) {
            self.pixmap.fill_path(&path, &paint(colour), FillRule::Winding, self.scale, None);
        }
    }

    /// A size in units at which letters can be read.
    pub fn readable(&self, size: f32) -> f32 {
        size.max(SMALLEST / self.scale.sx)
    }

    /// Dark text, smaller where it is too long for its place, and with an ellipsis where it would be too small to be read.
    pub fn fitted_text(&mut self, text: &str, size: f32, position: (f32, f32), width: f32) {
        let size = self.readable(size.min(size * width / text_width(text, size).max(1.0)));
        let text = shortened(text, size, width);
        self.plain_text(&text, size, position, Anchor::Start, dark());
    }

    /// The lines of a text broken at its blanks; words that are too long have an ellipsis.
    pub fn broken_text(&self, text: &str, size: f32, width: f32) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace().map(|word| shortened(word, size, width)) {
            match lines.last_mut() {
                Some(line) if text_width(&format!("{line} {word}"), size) <= width => *line += &format!(" {word}"),
                _ => lines.push(word),
            }
        }
        lines
    }

    /// A straight arrow with a filled head; `weight` 1 is a shaft 8 units thick.
    pub fn arrow(&mut self, tail: (f32, f32), head: (f32, f32), weight: f32, colour: Color) {
        let (half_shaft, half_head, head_length) = (4.0 * weight, 13.0 * weight, 30.0 * weight);
        let (dx, dy) = (head.0 - tail.0, head.1 - tail.1);
        let length = (dx * dx + dy * dy).sqrt();
        let (dx, dy) = (dx / length, dy / length);
        // Outline in coordinates along and to the side of the arrow.
        let neck = length - head_length;
        let outline = [
            (0.0, -half_shaft),
            (neck, -half_shaft),
            (neck, -half_head),
            (length, 0.0),
            (neck, half_head),
            (neck, half_shaft),
            (0.0, half_shaft),
        ];
        let place = |(along, side): (f32, f32)| (tail.0 + along * dx - side * dy, tail.1 + along * dy + side * dx);
        self.rimmed(&polygon(&outline.map(place), true), 4.0 * weight, colour);
    }

    /// Fills a shape over a dark rim `rim` wide.
    pub fn rimmed(&mut self, path: &Path, rim: f32, colour: Color) {
        let stroke =
            Stroke { width: 2.0 * rim, line_join: LineJoin::Round, line_cap: LineCap::Round, ..Stroke::default() };
        self.pixmap.stroke_path(path, &paint(dark()), &stroke, self.scale, None);
        self.pixmap.fill_path(path, &paint(colour), FillRule::Winding, self.scale, None);
    }

    pub fn line(&mut self, points: &[(f32, f32)], width: f32, colour: Color) {
        self.stroke(points, width, None, colour);
    }

    /// A line, dashed if asked for.
    pub fn stroke(&mut self, points: &[(f32, f32)], width: f32, dash: Option<StrokeDash>, colour: Color) {
        let stroke = Stroke { width, dash, ..Stroke::default() };
        self.pixmap.stroke_path(&polygon(points, false), &paint(colour), &stroke, self.scale, None);
    }

    /// A filled polygon.
    pub fn area(&mut self, corners: &[(f32, f32)], colour: Color) {
        self.pixmap.fill_path(&polygon(corners, true), &paint(colour), FillRule::Winding, self.scale, None);
    }

    /// A filled rectangle.
    pub fn plate(&mut self, [left, top, right, bottom]: [f32; 4], colour: Color) {
        if let Some(rect) = Rect::from_ltrb(left, top, right, bottom) {
            self.pixmap.fill_rect(rect, &paint(colour), self.scale, None);
        }
    }

    /// A filled circle with a dark rim.
    pub fn disc(&mut self, (x, y): (f32, f32), radius: f32, colour: Color) {
        if let Some(path) = PathBuilder::from_circle(x, y, radius) {
            self.rimmed(&path, 2.0, colour);
        }
    }

    /// A picture with its top left corner at a place in pixels, texel for pixel.
    pub fn picture(&mut self, picture: &Pixmap, [x, y]: [usize; 2]) {
        let paint = PixmapPaint::default();
        self.pixmap.draw_pixmap(x as i32, y as i32, picture.as_ref(), &paint, Transform::identity(), None);
    }
}

/// A text with an ellipsis in its middle, where the names of files say least; its first letter stays.
fn shortened(text: &str, size: f32, width: f32) -> String {
    let letters: Vec<char> = text.chars().collect();
    let kept = |count: usize| -> String {
        let (head, tail) = (count.div_ceil(2), count / 2);
        letters[..head].iter().chain(&['…']).chain(&letters[letters.len() - tail..]).collect()
    };
    if text_width(text, size) <= width {
        return text.to_owned();
    }
    let fits = (1..letters.len()).rev().map(kept).find(|short| text_width(short, size) <= width);
    fits.unwrap_or_else(|| kept(letters.len().min(1)))
}

/// The outline of a text, turned about its anchor.
fn placed_text(text: &str, size: f32, (x, y): (f32, f32), turn: f32, anchor: Anchor) -> Option<Path> {
    text_path(text, size, anchor)?.transform(quarter_turn(turn).post_translate(x, y))
}

/// The light ground of drawings.
pub(in crate::report) fn ground() -> Color {
    Color::from_rgba8(246, 245, 242, 255)
}

/// A pixmap of one colour.
pub(in crate::report) fn blank(width: usize, height: usize, colour: Color) -> Pixmap {
    let mut pixmap = Pixmap::new(width as u32, height as u32).expect("a drawing has pixels");
    pixmap.fill(colour);
    pixmap
}

/// A raster as it is displayed.
pub(in crate::report) fn displayed(raster: &Raster, tone_map: ToneMap) -> Pixmap {
    pixmap_of(display_bytes(raster, tone_map), [raster.width(), raster.height()])
}

/// A pixmap of this width and height, from four bytes per pixel.
pub(in crate::report) fn pixmap_of(bytes: Vec<u8>, [width, height]: [usize; 2]) -> Pixmap {
    let size = IntSize::from_wh(width as u32, height as u32).expect("a picture has pixels");
    Pixmap::from_vec(bytes, size).expect("four bytes per pixel")
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

/// Smooth edges, one colour.
pub(in crate::report) fn paint(colour: Color) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(colour);
    paint
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_keeps_to_its_place_and_says_where_it_is_cut() {
        let mut pixmap = blank(8, 8, ground());
        let canvas = Canvas::new(pixmap.as_mut(), 0.25);
        assert_eq!(canvas.readable(17.0), 44.0, "11 pixels");
        assert_eq!(canvas.readable(60.0), 60.0);
        let width = text_width("turn 90° clockwise", 16.0);
        assert_eq!(canvas.broken_text("turn 90° clockwise", 16.0, width + 1.0), ["turn 90° clockwise"]);
        assert_eq!(canvas.broken_text("turn 90° clockwise", 16.0, width - 1.0), ["turn 90°", "clockwise"]);
        for size in [16.0, 30.0] {
            let short = shortened("a-long-name-of-a-sky_posx.jpg", size, 120.0);
            assert!(text_width(&short, size) <= 120.0 && short.contains('…'), "{short}");
            assert!(short.starts_with('a') && short.ends_with('g'), "{short}");
        }
        assert_eq!(shortened("posx.jpg", 16.0, 120.0), "posx.jpg");
    }
}
