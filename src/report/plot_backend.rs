//! Plots as pictures: what `plotters` asks for, drawn by `tiny-skia`, text in the font that is built in.

use std::convert::Infallible;

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontTransform,
};
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Path, PathBuilder, Pixmap, Rect, Stroke, Transform};

use super::canvas::{paint, quarter_turn};
use super::text_drawing::{Anchor, text_path, text_width};

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

/// A pixmap that `plotters` draws on.
pub(super) struct PlotBackend<'a>(pub &'a mut Pixmap);

/// What `plotters` calls the size of a font, over the length of an em.
pub(super) const SIZE_OVER_EM: f64 = 1.24;

/// Height of a small letter without ascender in Noto Sans, in ems.
const X_HEIGHT: f32 = 0.536;

impl PlotBackend<'_> {
    fn fill(&mut self, path: Option<Path>, colour: BackendColor) -> Drawn {
        if let Some(path) = path {
            self.0.fill_path(&path, &paint(to_skia(colour)), FillRule::Winding, Transform::identity(), None);
        }
        Ok(())
    }

    fn stroke(&mut self, path: Option<Path>, style: &impl BackendStyle) -> Drawn {
        if let Some(path) = path {
            let stroke = Stroke {
                width: style.stroke_width() as f32,
                line_join: LineJoin::Round,
                line_cap: LineCap::Butt,
                ..Stroke::default()
            };
            // Lines run through the middles of pixels: those along the axes are sharp.
            let middle = Transform::from_translate(0.5, 0.5);
            self.0.stroke_path(&path, &paint(to_skia(style.color())), &stroke, middle, None);
        }
        Ok(())
    }
}

impl DrawingBackend for PlotBackend<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (self.0.width(), self.0.height())
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Drawn {
        let square = Rect::from_xywh(x as f32, y as f32, 1.0, 1.0).map(PathBuilder::from_rect);
        self.fill(square, colour)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let rect = Rect::from_ltrb(left as f32, top as f32, right as f32, bottom as f32).map(PathBuilder::from_rect);
        if fill { self.fill(rect, style.color()) } else { self.stroke(rect, style) }
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, points: I, style: &S) -> Drawn {
        self.stroke(polygon(points, false), style)
    }

    fn draw_circle<S: BackendStyle>(&mut self, (x, y): BackendCoord, radius: u32, style: &S, fill: bool) -> Drawn {
        let middle = if fill { 0.5 } else { 0.0 };
        let circle = PathBuilder::from_circle(x as f32 + middle, y as f32 + middle, radius as f32);
        if fill { self.fill(circle, style.color()) } else { self.stroke(circle, style) }
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, points: I, style: &S) -> Drawn {
        self.fill(polygon(points, true), style.color())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, (x, y): BackendCoord) -> Drawn {
        let em = (style.size() / SIZE_OVER_EM) as f32;
        let anchor = match style.anchor().h_pos {
            HPos::Left => Anchor::Start,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::End,
        };
        // The same distances as in the SVG of `plotters`.
        let down = match style.anchor().v_pos {
            VPos::Top => 0.76 * em,
            VPos::Center => 0.5 * X_HEIGHT * em,
            VPos::Bottom => -0.5 * X_HEIGHT * em,
        };
        let turn = quarter_turn(match style.transform() {
            FontTransform::None => 0.0,
            FontTransform::Rotate90 => 90.0,
            FontTransform::Rotate180 => 180.0,
            FontTransform::Rotate270 => 270.0,
        });
        let place = turn.pre_translate(0.0, down).post_translate(x as f32, y as f32);
        self.fill(text_path(text, em, anchor).and_then(|path| path.transform(place)), style.color())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let em = (style.size() / SIZE_OVER_EM) as f32;
        Ok((text_width(text, em).ceil() as u32, em.ceil() as u32))
    }
}

fn polygon(points: impl IntoIterator<Item = BackendCoord>, closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for (index, (x, y)) in points.into_iter().enumerate() {
        let (x, y) = (x as f32, y as f32);
        if index == 0 { builder.move_to(x, y) } else { builder.line_to(x, y) }
    }
    if closed {
        builder.close();
    }
    builder.finish()
}

fn to_skia(colour: BackendColor) -> Color {
    let (red, green, blue) = colour.rgb;
    Color::from_rgba8(red, green, blue, (colour.alpha * 255.0).round() as u8)
}
