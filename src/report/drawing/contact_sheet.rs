//! The contact sheet of the six axis shots.

use tiny_skia::{Color, Pixmap};

use super::canvas::{Canvas, blank, displayed, ground};
use super::finished::Drawing;
use super::plate::{PlateLine, draw_plate};
use super::verdict_colour::{repair_colour, verdict_colour};
use crate::colour::ToneMap;
use crate::picture::Raster;
use crate::render::AxisShot;
use crate::validate::Verdict;

/// The layout is drawn for pictures of this many pixels and scaled to their size.
const PICTURE: f32 = 384.0;
const MARGIN: f32 = 24.0;
const HEADING: f32 = 64.0;
const CAPTION: f32 = 62.0;
const FOOT: f32 = 40.0;

/// A shot, and what it shows.
#[derive(Debug, Clone, Copy)]
pub struct CaptionedShot<'a> {
    pub shot: AxisShot,
    /// Linear radiance, square.
    pub raster: &'a Raster,
    /// The image that the face reads: `posz (Meadow.zip/posz.jpg)`.
    pub image: &'a str,
    /// What to do about that image.
    pub repair: Option<&'a str>,
}

/// Draws six shots, in the order of [`Face::ALL`](crate::envmap::Face::ALL): the positive axes above the negative ones.
///
/// ```text
///    heading
///    +x  +y  +z
///    -x  -y  -z
///    foot: how the camera stood
/// ```
pub fn draw_contact_sheet(shots: &[CaptionedShot; 6], heading: &str, foot: &str, tone_map: ToneMap) -> Drawing {
    let pictures = shots.map(|captioned| displayed(&fitted(captioned.raster), tone_map));
    let size = pictures[0].width() as usize;
    let scale = size as f32 / PICTURE;
    let pixels = |units: f32| (units * scale).round() as usize;
    let (step_x, step_y) = (PICTURE + MARGIN, PICTURE + CAPTION + MARGIN);
    let (width, height) = (MARGIN + 3.0 * step_x, HEADING + 2.0 * step_y + FOOT);
    let mut pixmap = blank(pixels(width), pixels(height), ground());
    let mut canvas = Canvas::new(pixmap.as_mut(), scale);
    canvas.fitted_text(heading, 26.0, (MARGIN, 42.0), width - 2.0 * MARGIN);
    canvas.fitted_text(foot, 18.0, (MARGIN, height - 24.0), width - 2.0 * MARGIN);
    for (index, (captioned, picture)) in shots.iter().zip(&pictures).enumerate() {
        let (column, row) = (index / 2, index % 2);
        let place = (MARGIN + column as f32 * step_x, HEADING + row as f32 * step_y);
        draw_shot(&mut canvas, captioned, picture, place, scale);
    }
    Drawing(pixmap)
}

fn draw_shot(canvas: &mut Canvas, captioned: &CaptionedShot, picture: &Pixmap, (x, y): (f32, f32), scale: f32) {
    canvas.picture(picture, [x, y].map(|units| (units * scale).round() as usize));
    if let Some(repair) = captioned.repair {
        let (right, bottom) = (x + PICTURE, y + PICTURE);
        let frame = [(x, y), (right, y), (right, bottom), (x, bottom), (x, y)];
        canvas.line(&frame, 8.0, Color::WHITE);
        canvas.line(&frame, 5.0, verdict_colour(Verdict::Broken));
        let line = PlateLine { text: repair, size: 26.0, colour: repair_colour() };
        draw_plate(canvas, &[line], (x + 14.0, bottom - 14.0), (1.0, -1.0), 0.8 * PICTURE);
    }
    let AxisShot { direction, up, .. } = captioned.shot;
    let view = format!("along {}   up {up}   right {}", direction.signed_name(), captioned.shot.right());
    canvas.fitted_text(&view, 22.0, (x, y + PICTURE + 26.0), PICTURE);
    let seen = format!("face {} reads {}", direction.signed_name(), captioned.image);
    canvas.fitted_text(&seen, 17.0, (x, y + PICTURE + 51.0), PICTURE);
}

/// The raster made smaller or larger by a whole factor, so that its side is 256 to 512 pixels.
fn fitted(raster: &Raster) -> Raster {
    let size = raster.width();
    if size < 256 {
        return raster.enlarged(256usize.div_ceil(size));
    }
    raster.reduced(size.div_ceil(512))
}
