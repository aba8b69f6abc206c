//! A finished drawing.

use std::path::Path;

use tiny_skia::{Color, Pixmap};

use super::canvas::{Canvas, blank};
use crate::error::Result;
use crate::picture::{Samples, encode_png, without_opacity, write_png};

/// A finished drawing: opaque, sRGB-encoded.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing(pub(in crate::report) Pixmap);

impl Drawing {
    /// Width in pixels.
    pub fn width(&self) -> usize {
        self.0.width() as usize
    }

    /// Height in pixels.
    pub fn height(&self) -> usize {
        self.0.height() as usize
    }

    /// Three bytes per pixel, row by row from the top left.
    pub fn bytes(&self) -> Vec<u8> {
        without_opacity(self.0.data())
    }

    /// Writes a PNG file.
    pub fn write(&self, path: &Path) -> Result<()> {
        write_png(path, self.width(), self.height(), Samples::Rgb8(&self.bytes()))
    }

    /// The bytes of a PNG file of the drawing.
    pub fn encode(&self) -> Result<Vec<u8>> {
        encode_png(self.width(), self.height(), Samples::Rgb8(&self.bytes()))
    }

    /// Two drawings beside each other: before and after.
    pub fn beside(&self, right: &Self) -> Self {
        self.joined(right, [self.width() + right.width(), self.height().max(right.height())], [self.width(), 0])
    }

    /// Two drawings, one below the other.
    pub fn above(&self, below: &Self) -> Self {
        self.joined(below, [self.width().max(below.width()), self.height() + below.height()], [0, self.height()])
    }

    fn joined(&self, other: &Self, [width, height]: [usize; 2], place: [usize; 2]) -> Self {
        let mut pixmap = blank(width, height, Color::WHITE);
        let mut canvas = Canvas::new(pixmap.as_mut(), 1.0);
        canvas.picture(&self.0, [0, 0]);
        canvas.picture(&other.0, place);
        Self(pixmap)
    }
}
