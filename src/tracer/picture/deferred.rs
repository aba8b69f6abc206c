//! Colours that are known by their place in a picture, not yet read.
//!
//! Memory is far away: a texel that no cache holds takes as long as several hundred instructions. Whoever needs many
//! colours asks for the places first and reads them later; meanwhile all of them are on their way.
//!
//! ```text
//!     one by one     place  . . . . . . . . colour  place  . . . . . . . . colour        . waiting for memory
//!     deferred       place  place  place  . . colour  colour  colour
//! ```

use super::{Picture, TexelSquare};
use crate::math::Vec3;

/// A linear colour and where it is to be read, if anywhere.
#[derive(Debug, Clone, Copy)]
pub enum DeferredColour<'a> {
    /// There is nothing to read, or it was read already.
    Known(Vec3),
    /// The colour of a texel, by its number counted row by row from the top.
    Texel { picture: &'a Picture, index: usize },
    /// The weighted mean of four texels.
    Square { picture: &'a Picture, square: TexelSquare },
}

impl DeferredColour<'_> {
    /// Tells the processor that the colour will be read soon.
    #[inline(always)]
    pub fn prefetch(&self) {
        match self {
            Self::Known(_) => (),
            Self::Texel { picture, index } => picture.prefetch(*index),
            Self::Square { picture, square } => {
                picture.prefetch(square.first);
                picture.prefetch(square.first + picture.width());
            }
        }
    }

    /// Reads it.
    #[inline(always)]
    pub fn colour(&self) -> Vec3 {
        match self {
            Self::Known(colour) => *colour,
            Self::Texel { picture, index } => picture.texel_at(*index),
            Self::Square { picture, square } => picture.blended(square),
        }
    }
}

impl Picture {
    /// The colour that [`Picture::bilinear`] gives.
    #[inline(always)]
    pub fn deferred_bilinear(&self, x: f32, y: f32) -> DeferredColour<'_> {
        match self.square_around(x, y) {
            Some(square) => DeferredColour::Square { picture: self, square },
            None => DeferredColour::Known(self.bilinear_in_one_line(x, y)),
        }
    }

    /// The colour that [`Picture::nearest`] gives.
    #[inline(always)]
    pub fn deferred_nearest(&self, x: f32, y: f32) -> DeferredColour<'_> {
        let index = |position: f32, count: usize| (position as i32).clamp(0, count as i32 - 1) as usize;
        let (column, row) = (index(x, self.width()), index(y, self.height()));
        DeferredColour::Texel { picture: self, index: row * self.width() + column }
    }
}
