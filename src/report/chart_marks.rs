//! Lines and words of a chart, written as SVG or drawn as a picture.

use std::fmt::Write;

use tiny_skia::Color;

use super::canvas::{Canvas, blank};
use super::drawing::Drawing;
use super::text_drawing::Anchor;

/// A colour of three bytes.
pub(super) type Rgb = [u8; 3];

/// Something on a chart; pixels from the top left.
pub(super) enum Mark {
    Line { points: Vec<(f32, f32)>, width: f32, colour: Rgb },
    Text { text: String, size: f32, place: (f32, f32), anchor: Anchor, colour: Rgb },
}

/// A chart on white, in pixels.
pub(super) struct Marks {
    pub width: usize,
    pub height: usize,
    pub marks: Vec<Mark>,
}

impl Marks {
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, marks: Vec::new() }
    }

    pub fn line(&mut self, points: &[(f32, f32)], width: f32, colour: Rgb) {
        if points.len() > 1 {
            self.marks.push(Mark::Line { points: points.to_vec(), width, colour });
        }
    }

    pub fn text(&mut self, text: &str, size: f32, place: (f32, f32), anchor: Anchor, colour: Rgb) {
        self.marks.push(Mark::Text { text: text.to_owned(), size, place, anchor, colour });
    }

    /// The chart as an SVG file.
    pub fn to_svg(&self) -> String {
        let (width, height) = (self.width, self.height);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             font-family=\"Noto Sans, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        );
        for mark in &self.marks {
            let _ = writeln!(svg, "{}", element(mark));
        }
        svg + "</svg>\n"
    }

    /// The chart as a picture.
    pub fn to_drawing(&self) -> Drawing {
        let mut pixmap = blank(self.width, self.height, Color::WHITE);
        let mut canvas = Canvas::new(pixmap.as_mut(), 1.0);
        for mark in &self.marks {
            match mark {
                Mark::Line { points, width, colour } => canvas.line(points, *width, opaque(*colour)),
                Mark::Text { text, size, place, anchor, colour } => {
                    canvas.plain_text(text, *size, *place, *anchor, opaque(*colour));
                }
            }
        }
        Drawing(pixmap)
    }
}

fn opaque([red, green, blue]: Rgb) -> Color {
    Color::from_rgba8(red, green, blue, 255)
}

fn element(mark: &Mark) -> String {
    let hex = |[red, green, blue]: Rgb| format!("#{red:02x}{green:02x}{blue:02x}");
    match mark {
        Mark::Line { points, width, colour } => {
            let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
            let (points, colour) = (points.join(" "), hex(*colour));
            format!("<polyline points=\"{points}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>")
        }
        Mark::Text { text, size, place: (x, y), anchor, colour } => {
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            let text = text.replace('&', "&amp;").replace('<', "&lt;");
            let colour = hex(*colour);
            format!(
                "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{text}</text>"
            )
        }
    }
}
