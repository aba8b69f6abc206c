//! The compass: a cube map that shows a wrong face at a glance.
//!
//! Every face has its own colour, its name in the middle, arrows along growing u and v, a grid in tenths, and at each
//! border the name of the neighbour. Along each of the twelve seams runs a border strip that is a function of the point
//! on the cube alone, so it continues across the seam: a colour gradient with bent bars, which give the number of the
//! seam in binary. Positions along a seam are never symmetric, so the map closes in one orientation only.
//!
//! ```text
//!   +---------------------------+    s, t: coordinates on the face, -1 to 1,
//!   |\ /  / /  border strip  / /|          along growing u and v
//!   | +---------------------+ / |
//!   |/|  +Y   0.2 0.4 ...   | - |
//!   |-| v|      +X          |+Z |
//!   | |  v     posx    ---> |   |
//!   | +--------------- u ---+ / |
//!   |/  /  / / /   /  / /  / \  |
//!   +---------------------------+
//! ```

use tiny_skia::{Color, Pixmap, PixmapMut};

use super::canvas::{Canvas, pixmap_of};
use super::text_drawing::Anchor;
use crate::envmap::{Face, Preset, SignedAxis};
use crate::math::Vec3;
use crate::picture::{Format, Header, Picture, Texels, without_opacity};

/// Width of the border strip in units of the face coordinates (the face is 2 wide).
const STRIP: f32 = 0.16;

/// Half the width of a bar across a seam.
const HALF_BAR: f32 = 0.035;

/// Rise of a channel of the strip's colour along its axis, from the middle of the cube to a face.
pub(super) const GRADIENT: f32 = 0.25;

/// Samples a texel and axis where the border strip is drawn.
const SAMPLES: usize = 3;

/// Draws one face of the compass, `size` texels wide and high, for the `opengl` lookup (y up, v = 0 at the top).
pub fn draw_compass_face(face: Face, size: usize) -> Picture {
    let frame = FaceFrame::opengl(face);
    let mut pixmap = draw_background(&frame, size);
    draw_marks(pixmap.as_mut(), &frame);
    let texels = without_opacity(pixmap.data());
    let header = Header { width: size, height: size, format: Format::Png, bit_depth: 8, alpha: false };
    Picture::new(header, Texels::Srgb8(texels))
}

/// Where a face lies on the cube `[-1, 1]^3`, and the axes along which its picture grows.
struct FaceFrame {
    face: Face,
    /// Growing u: through the neighbour at the right border.
    right: SignedAxis,
    /// Growing v: through the neighbour at the lower border.
    below: SignedAxis,
}

impl FaceFrame {
    /// The row of the `opengl` table for this face, where v = 0 is the top row.
    fn opengl(face: Face) -> Self {
        let row = Preset::Opengl.lookup().row(face);
        Self { face, right: row.u, below: row.v }
    }

    /// The point of the cube's surface at face coordinates `s` (growing u) and `t` (growing v), -1 to 1.
    fn point(&self, s: f32, t: f32) -> Vec3 {
        self.face.normal() + s * self.right.direction() + t * self.below.direction()
    }

    /// The neighbour across the border nearest to the face coordinates `s`, `t`.
    fn nearest_neighbour(&self, s: f32, t: f32) -> Face {
        let (axis, positive) = if s.abs() > t.abs() { (self.right, s > 0.0) } else { (self.below, t > 0.0) };
        if positive { axis.face() } else { (-axis).face() }
    }
}

/// The colour of a face, sRGB-encoded, 0 to 1.
fn face_colour(face: Face) -> Vec3 {
    let codes = match face {
        Face::PosX => [206, 62, 52],
        Face::NegX => [44, 164, 178],
        Face::PosY => [86, 170, 66],
        Face::NegY => [160, 72, 172],
        Face::PosZ => [58, 98, 208],
        Face::NegZ => [222, 176, 40],
    };
    Vec3::from_array(codes.map(|code| code as f32 / 255.0))
}

/// The face colour inside, the border strip at the borders, averaged over the samples of each texel.
fn draw_background(frame: &FaceFrame, size: usize) -> Pixmap {
    let mut bytes = Vec::with_capacity(4 * size * size);
    // Face coordinate of a sample: samples lie at the middles of a texel's thirds.
    let coordinate = |sample: usize| (2 * sample + 1) as f32 / (SAMPLES * size) as f32 - 1.0;
    for row in 0..size {
        for column in 0..size {
            let samples = (0..SAMPLES * SAMPLES).map(|sample| {
                let s = coordinate(SAMPLES * column + sample % SAMPLES);
                let t = coordinate(SAMPLES * row + sample / SAMPLES);
                background_colour(frame, s, t)
            });
            let colour = samples.sum::<Vec3>() / (SAMPLES * SAMPLES) as f32;
            bytes.extend(colour.to_array().map(|channel| (255.0 * channel + 0.5) as u8));
            bytes.push(255);
        }
    }
    pixmap_of(bytes, [size, size])
}

fn background_colour(frame: &FaceFrame, s: f32, t: f32) -> Vec3 {
    let distance = 1.0 - s.abs().max(t.abs());
    let inside = face_colour(frame.face);
    if distance >= STRIP {
        return inside;
    }
    let border = border_colour(frame.face, frame.nearest_neighbour(s, t), frame.point(s, t));
    // The strip is itself for the outer half of its width and fades into the face on the inner half.
    let fade = smoothstep(0.5 * STRIP, STRIP, distance);
    border.lerp(inside, fade)
}

/// Colour of the strip on `face` towards `neighbour` at a point of the cube: the same from both sides of the seam.
fn border_colour(face: Face, neighbour: Face, point: Vec3) -> Vec3 {
    let gradient = Vec3::splat(0.55) + GRADIENT * point;
    let free_axis = 3 - face.axis() - neighbour.axis();
    let along = point[free_axis];
    // Bars cross the seam at a right angle and bend to opposite sides behind it, so the two border texels agree.
    let distance = 1.0 - point[neighbour.axis()].abs();
    let bend = distance * distance * distance / (STRIP * STRIP);
    let across = if face < neighbour { -bend } else { bend };
    match bar_at(seam_number(face, neighbour), along - across) {
        Some(colour) => colour,
        None => gradient,
    }
}

/// Number of the seam between two neighbours, 1 to 12, whichever comes first: four each between x and y, x and z,
/// y and z.
fn seam_number(face: Face, neighbour: Face) -> usize {
    let (first, second) = (face.min(neighbour), face.max(neighbour));
    let axes = first.axis() + second.axis() - 1;
    1 + 4 * axes + 2 * (first.index() % 2) + second.index() % 2
}

/// The bar at a position along the seam, if there is one: a black and a white bar where counting starts, then a
/// light bar for each binary digit 1 of the seam's number and a dark one for each 0, lowest digit first.
fn bar_at(seam: usize, position: f32) -> Option<Vec3> {
    const START: f32 = -0.66;
    const SPACING: f32 = 0.21;
    let slot = ((position - START) / SPACING).round();
    if !(0.0..=5.0).contains(&slot) || (position - START - slot * SPACING).abs() > HALF_BAR {
        return None;
    }
    Some(match slot as usize {
        0 => Vec3::ZERO,
        1 => Vec3::ONE,
        digit if seam >> (digit - 2) & 1 == 1 => Vec3::new(1.0, 0.95, 0.75),
        _ => Vec3::new(0.2, 0.16, 0.3),
    })
}

/// Cubic step from 0 at `start` to 1 at `end`.
fn smoothstep(start: f32, end: f32, value: f32) -> f32 {
    let x = ((value - start) / (end - start)).clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// The size of the square on which marks are designed, in units; they are scaled to the face.
const LAYOUT: f32 = 512.0;

/// Draws all marks of a face over its background. None touches the outer half of the border strip.
fn draw_marks(pixmap: PixmapMut, frame: &FaceFrame) {
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
    const DEPTH: f32 = 92.0;
    let (middle, far) = (0.5 * LAYOUT, LAYOUT - DEPTH);
    let sides = [
        (-frame.below, (middle, DEPTH), 0.0),
        (frame.right, (far, middle), 90.0),
        (frame.below, (middle, far), 180.0),
        (-frame.right, (DEPTH, middle), 270.0),
    ];
    for (axis, baseline, turn) in sides {
        let label = format!("{} {}", axis.to_string().to_uppercase(), axis.face().name());
        canvas.text(&label, 26.0, baseline, turn, Anchor::Middle);
    }
}

/// Arrows along growing u (to the right) and growing v (down), with their names.
fn draw_arrows(canvas: &mut Canvas) {
    canvas.arrow((150.0, 378.0), (362.0, 378.0), 1.0, Color::WHITE);
    canvas.text("u", 44.0, (376.0, 389.0), 0.0, Anchor::Start);
    canvas.arrow((134.0, 150.0), (134.0, 336.0), 1.0, Color::WHITE);
    canvas.text("v", 44.0, (134.0, 372.0), 0.0, Anchor::Middle);
}
