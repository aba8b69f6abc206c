//! The float raster of renderings and float files.

use crate::math::Vec3;

/// A rectangle of linear RGB pixels, rows from top to bottom, pixels from left to right.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    width: usize,
    height: usize,
    pixels: Vec<Vec3>,
}

impl Raster {
    /// A raster of one colour.
    pub fn filled(width: usize, height: usize, colour: Vec3) -> Self {
        Self { width, height, pixels: vec![colour; width * height] }
    }

    /// A raster from its pixels, row by row from the top. Panics if the count is not `width * height`.
    pub fn from_pixels(width: usize, height: usize, pixels: Vec<Vec3>) -> Self {
        assert_eq!(pixels.len(), width * height, "a raster needs width * height pixels");
        Self { width, height, pixels }
    }

    /// A raster computed pixel by pixel from column and row.
    pub fn from_function(width: usize, height: usize, mut colour: impl FnMut(usize, usize) -> Vec3) -> Self {
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| colour(x, y)).collect();
        Self { width, height, pixels }
    }

    /// Columns of pixels.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows of pixels.
    pub fn height(&self) -> usize {
        self.height
    }

    /// All pixels, row by row from the top.
    pub fn pixels(&self) -> &[Vec3] {
        &self.pixels
    }

    /// All pixels to write to, row by row from the top.
    pub fn pixels_mut(&mut self) -> &mut [Vec3] {
        &mut self.pixels
    }

    /// The pixel in column `x` and row `y`, both counted from the top left.
    pub fn pixel(&self, x: usize, y: usize) -> Vec3 {
        self.pixels[y * self.width + x]
    }

    /// Sets the pixel in column `x` and row `y`.
    pub fn set(&mut self, x: usize, y: usize, colour: Vec3) {
        self.pixels[y * self.width + x] = colour;
    }
}
