//! A finished chart: lines, areas and text, for output as SVG or as a picture.

use std::fmt::Write;

use tiny_skia::{Color, StrokeDash};

use super::super::drawing::{Anchor, Canvas, Drawing, blank};

/// A colour of three bytes.
pub(super) type Rgb = [u8; 3];

/// Lengths of dashes and gaps.
const DASH: [f32; 2] = [10.0, 8.0];

/// Something on a chart; pixels from the top left.
pub(super) enum Mark {
    Line {
        points: Vec<(f32, f32)>,
        width: f32,
        dashed: bool,
        colour: Rgb,
    },
    Area {
        points: Vec<(f32, f32)>,
        colour: Rgb,
    },
    /// `turn` is 0, or 270 for text that reads upwards.
    Text {
        text: String,
        size: f32,
        place: (f32, f32),
        turn: f32,
        anchor: Anchor,
    },
}

/// The colour of text.
const INK: Rgb = [30, 30, 36];

/// A chart on white, in pixels.
pub struct Chart {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) marks: Vec<Mark>,
}

impl Chart {
    /// The chart as an SVG file; its text takes the viewer's sans-serif font.
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
        let opaque = |[red, green, blue]: Rgb| Color::from_rgba8(red, green, blue, 255);
        for mark in &self.marks {
            match mark {
                Mark::Line { points, width, dashed, colour } => {
                    let dash = dashed.then(|| StrokeDash::new(DASH.to_vec(), 0.0)).flatten();
                    canvas.stroke(points, *width, dash, opaque(*colour));
                }
                Mark::Area { points, colour } => canvas.area(points, opaque(*colour)),
                Mark::Text { text, size, place, turn, anchor } => {
                    canvas.turned_text(text, *size, *place, *turn, *anchor, opaque(INK));
                }
            }
        }
        Drawing(pixmap)
    }
}

fn element(mark: &Mark) -> String {
    let hex = |[red, green, blue]: Rgb| format!("#{red:02x}{green:02x}{blue:02x}");
    let list =
        |points: &[(f32, f32)]| points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect::<Vec<_>>().join(" ");
    match mark {
        Mark::Line { points, width, dashed, colour } => {
            let (points, colour, [dash, gap]) = (list(points), hex(*colour), DASH);
            let dash = if *dashed { format!(" stroke-dasharray=\"{dash} {gap}\"") } else { String::new() };
            format!("<polyline points=\"{points}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"{dash}/>")
        }
        Mark::Area { points, colour } => format!("<polygon points=\"{}\" fill=\"{}\"/>", list(points), hex(*colour)),
        Mark::Text { text, size, place: (x, y), turn, anchor } => {
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            let (text, colour) = (text.replace('&', "&amp;").replace('<', "&lt;"), hex(INK));
            format!(
                "<text transform=\"translate({x:.1} {y:.1}) rotate({turn})\" font-size=\"{size}\" \
                 text-anchor=\"{anchor}\" fill=\"{colour}\">{text}</text>"
            )
        }
    }
}
