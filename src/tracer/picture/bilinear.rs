//! Bilinear interpolation: which four texels a point lies between, and their mean.

use super::{Picture, Texels};
use crate::colour::decode_srgb8;
use crate::math::Vec3;
use crate::math::functions::clamp_number;

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
/// Half a texel from the border and beyond, the border texel counts alone: the share is 0 at the left and top, 1 at the
/// right and bottom. The two columns are always neighbours, unless there is only one; so are the rows.
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
    #[inline(always)]
    pub fn new(x: f32, y: f32, width: usize, height: usize) -> Self {
        let (columns, horizontal) = neighbours(x, width);
        let (rows, vertical) = neighbours(y, height);
        Self { columns, rows, horizontal, vertical }
    }

    /// What the top left, top right, bottom left and bottom right texels count. The weights add up to 1; at a border some
    /// of them are 0.
    #[inline(always)]
    pub fn weights(&self) -> [f32; 4] {
        let (h, v) = (self.horizontal, self.vertical);
        [(1.0 - h) * (1.0 - v), h * (1.0 - v), (1.0 - h) * v, h * v]
    }

    /// Column, row and weight of the four texels, in the order of [`Footprint::weights`].
    #[inline(always)]
    pub fn weighted_texels(&self) -> [(usize, usize, f32); 4] {
        let ([left, right], [top, bottom]) = (self.columns, self.rows);
        let [top_left, top_right, bottom_left, bottom_right] = self.weights();
        [(left, top, top_left), (right, top, top_right), (left, bottom, bottom_left), (right, bottom, bottom_right)]
    }

    /// Interpolates the colours that `texel(column, row)` tells.
    #[inline(always)]
    pub fn interpolate(&self, texel: impl Fn(usize, usize) -> Vec3) -> Vec3 {
        let [a, b, c, d] = self.weighted_texels();
        texel(a.0, a.1) * a.2 + texel(b.0, b.1) * b.2 + texel(c.0, c.1) * c.2 + texel(d.0, d.1) * d.2
    }
}

/// The texels before and after a point on one axis of `count` texels, and the share of the second: half a texel from the
/// far end the last pair serves, with a share of 1.
#[inline(always)]
pub fn neighbours(position: f32, count: usize) -> ([usize; 2], f32) {
    if count == 1 {
        return ([0, 0], 0.0);
    }
    debug_assert!((2..1 << 30).contains(&count));
    let last = (count as i32 - 1) as f32;
    let centred = clamp_number(position - 0.5, 0.0, last);
    let within = clamp_number(centred, 0.0, last - 1.0);
    // SAFETY: `clamp_number` yields a number from 0 to last - 1 < 2^30 for any input, NaN included (tested there), so
    // it fits an i32. The checked conversion would cost as much as all the rest of this function.
    let first: i32 = unsafe { within.to_int_unchecked() };
    let first = first as usize;
    ([first, first + 1], centred - first as f32)
}

impl Picture {
    /// The linear colour under a footprint within the picture.
    #[inline]
    pub fn interpolated(&self, footprint: &Footprint) -> Vec3 {
        let index = |column: usize, row: usize| row * self.width() + column;
        // The kind of texels is matched once, not for each of the four.
        match self.texels() {
            Texels::Srgb8(bytes) => footprint.interpolate(|column, row| {
                let start = 3 * index(column, row);
                decode_srgb8([bytes[start], bytes[start + 1], bytes[start + 2]])
            }),
            Texels::Linear(colours) => footprint.interpolate(|column, row| colours[index(column, row)]),
        }
    }

    /// The linear colour at the point `(x, y)` in texels from the top left corner, interpolated between the four texels
    /// around it and clamped at the border. Texel centres are at half integers. Any `x`, `y` are allowed.
    #[inline(always)]
    pub fn bilinear(&self, x: f32, y: f32) -> Vec3 {
        self.interpolated(&Footprint::new(x, y, self.width(), self.height()))
    }

    /// The linear colour of the texel that the point `(x, y)` lies in, clamped at the border; NaN counts as 0.
    #[inline]
    pub fn nearest(&self, x: f32, y: f32) -> Vec3 {
        let index = |position: f32, count: usize| (position as i32).clamp(0, count as i32 - 1) as usize;
        self.texel(index(x, self.width()), index(y, self.height()))
    }
}
