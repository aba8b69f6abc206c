//! Drawings: a canvas, text, and the drawings of maps.

mod canvas;
mod compass;
mod contact_sheet;
mod cross_drawing;
mod cross_layout;
mod finished;
mod map_sheet;
mod plate;
mod text_drawing;
mod verdict_colour;

pub(super) use canvas::{Canvas, blank, broken_text, dark, displayed, ground, pixmap_of};
pub use compass::draw_compass_face;
pub use contact_sheet::{CaptionedShot, draw_contact_sheet};
pub use cross_drawing::{CrossInput, draw_cross};
pub use finished::Drawing;
pub use map_sheet::{MapThumbnail, draw_map_sheet};
pub(super) use text_drawing::text_width;
pub use text_drawing::{Anchor, text_path};

#[cfg(test)]
mod tests;
