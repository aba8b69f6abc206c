//! Bilinear interpolation: which four texels a point lies between, and their mean.

use super::{Picture, Texels};
use crate::colour::decode_srgb8;
use crate::math::Vec3;

/// The four texels around a point and what each counts.
///
/// ```text
///   left         right
///     o------------o  top        o texel centres
///     |     |      |             + the point
///     |- - -+      |             horizontal = distance from left to +, in texels
///     |            |             vertical   = distance from top to +, in texels
///     o------------o  bottom
/// ```
///
/// Half a texel from the border and beyond, the border texel counts alone (both columns or rows are clamped to it).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// Columns of the left and right texels.
    pub columns: [usize; 2],
    /// Rows of the top and bottom texels.
    pub rows: [usize; 2],
    /// Share of the right column, in `[0, 1]`.
    pub horizontal: f32,
    /// Share of the bottom row, in `[0, 1]`.
    pub vertical: f32,
}

impl Footprint {
    /// The footprint of the point `(x, y)` in texels from the top left corner of a picture: texel 0 covers `[0, 1]`,
    /// its centre is at 0.5. Points outside are clamped; NaN counts as 0.
    #[inline]
    pub fn new(x: f32, y: f32, width: usize, height: usize) -> Self {
        let (columns, horizontal) = neighbours(x, width);
        let (rows, vertical) = neighbours(y, height);
        Self { columns, rows, horizontal, vertical }
    }

    /// The footprint in a picture whose right border continues at its left one; rows are clamped.
    pub fn around(x: f32, y: f32, width: usize, height: usize) -> Self {
        let (rows, vertical) = neighbours(y, height);
        let centred = if x.is_finite() { x - 0.5 } else { 0.0 };
        let before = centred.floor();
        let first = before.rem_euclid(width as f32) as usize % width;
        Self { columns: [first, (first + 1) % width], rows, horizontal: centred - before, vertical }
    }

    /// Column, row and weight of the four texels: top left, top right, bottom left, bottom right. The weights add up
    /// to 1; at a border the same texel appears more than once.
    pub fn weighted_texels(&self) -> [(usize, usize, f32); 4] {
        let ([left, right], [top, bottom]) = (self.columns, self.rows);
        let (h, v) = (self.horizontal, self.vertical);
        [
            (left, top, (1.0 - h) * (1.0 - v)),
            (right, top, h * (1.0 - v)),
            (left, bottom, (1.0 - h) * v),
            (right, bottom, h * v),
        ]
    }

    /// Interpolates the colours that `texel(column, row)` tells.
    #[inline]
    pub fn interpolate(&self, texel: impl Fn(usize, usize) -> Vec3) -> Vec3 {
        let ([left, right], [top, bottom]) = (self.columns, self.rows);
        let upper = mix(texel(left, top), texel(right, top), self.horizontal);
        let lower = mix(texel(left, bottom), texel(right, bottom), self.horizontal);
        mix(upper, lower, self.vertical)
    }
}

/// The texels before and after a point on one axis of `count` texels, and the share of the second.
#[inline]
fn neighbours(position: f32, count: usize) -> ([usize; 2], f32) {
    let last = count - 1;
    // `max` turns NaN into 0.
    let centred = (position - 0.5).max(0.0).min(last as f32);
    let first = (centred as u32 as usize).min(last);
    ([first, (first + 1).min(last)], centred - first as f32)
}

#[inline]
fn mix(from: Vec3, to: Vec3, share: f32) -> Vec3 {
    from + (to - from) * share
}

impl Picture {
    /// The linear colour at the point `(x, y)` in texels from the top left corner, interpolated between the four texels
    /// around it and clamped at the border. Texel centres are at half integers. Any `x`, `y` are allowed.
    #[inline]
    pub fn bilinear(&self, x: f32, y: f32) -> Vec3 {
        self.interpolate(&Footprint::new(x, y, self.width(), self.height()))
    }

    /// The linear colour of a footprint.
    #[inline]
    pub fn interpolate(&self, footprint: &Footprint) -> Vec3 {
        let width = self.width();
        match self.texels() {
            Texels::Srgb8(bytes) => footprint.interpolate(|column, row| {
                let index = 3 * (row * width + column);
                let texel = &bytes[index..index + 3];
                decode_srgb8([texel[0], texel[1], texel[2]])
            }),
            Texels::Linear(colours) => footprint.interpolate(|column, row| colours[row * width + column]),
        }
    }

    /// The linear colour of the texel that the point `(x, y)` lies in, clamped at the border; NaN counts as 0.
    #[inline]
    pub fn nearest(&self, x: f32, y: f32) -> Vec3 {
        let index = |position: f32, count: usize| (position.max(0.0) as usize).min(count - 1);
        self.texel(index(x, self.width()), index(y, self.height()))
    }
}
