//! A picture over the unit square of texture coordinates.

use std::sync::Arc;

use super::Picture;
use crate::math::Vec3;

/// How a colour between the texel centres is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Filter {
    /// The texel that the point lies in.
    Nearest,
    /// Interpolated between the four texels around the point.
    #[default]
    Bilinear,
}

/// What lies outside the unit square.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wrap {
    /// The border goes on.
    #[default]
    Clamp,
    /// The picture is repeated, and interpolated across its border.
    Repeat,
}

/// A picture to be sampled at `u`, `v`: `u` grows to the right, `v` downwards from the top left corner, the picture
/// covers `[0, 1]` of both. Clones share the picture.
#[derive(Debug, Clone)]
pub struct Texture {
    picture: Arc<Picture>,
    filter: Filter,
    wrap: Wrap,
}

impl Texture {
    /// A texture of a picture, owned or shared. Panics if the picture has no texels.
    pub fn new(picture: impl Into<Arc<Picture>>, filter: Filter, wrap: Wrap) -> Self {
        let picture = picture.into();
        assert!(picture.width() > 0 && picture.height() > 0, "a texture needs texels");
        Self { picture, filter, wrap }
    }

    /// The picture it reads.
    pub fn picture(&self) -> &Picture {
        &self.picture
    }

    /// How texels are blended.
    pub fn filter(&self) -> Filter {
        self.filter
    }

    /// What lies outside `[0, 1]`.
    pub fn wrap(&self) -> Wrap {
        self.wrap
    }

    /// The linear colour at `u`, `v`. Any value is allowed; NaN counts as 0.
    #[inline]
    pub fn sample(&self, u: f32, v: f32) -> Vec3 {
        let (width, height) = (self.picture.width(), self.picture.height());
        match (self.wrap, self.filter) {
            (Wrap::Clamp, Filter::Nearest) => self.picture.nearest(u * width as f32, v * height as f32),
            (Wrap::Clamp, Filter::Bilinear) => self.picture.bilinear(u * width as f32, v * height as f32),
            (Wrap::Repeat, Filter::Nearest) => {
                self.picture.nearest(fraction(u) * width as f32, fraction(v) * height as f32)
            }
            (Wrap::Repeat, Filter::Bilinear) => self.repeated(fraction(u), fraction(v)),
        }
    }

    /// Interpolates with the first column and row following the last.
    fn repeated(&self, u: f32, v: f32) -> Vec3 {
        let (columns, horizontal) = cyclic_neighbours(u, self.picture.width());
        let (rows, vertical) = cyclic_neighbours(v, self.picture.height());
        self.picture.interpolated(&super::Footprint { columns, rows, horizontal, vertical })
    }
}

/// The part of a coordinate behind the point, in `[0, 1]`; 0 for what is not finite.
fn fraction(coordinate: f32) -> f32 {
    let fraction = coordinate - coordinate.floor();
    if fraction.is_finite() { fraction } else { 0.0 }
}

/// The texels before and after a point of `[0, 1]` on a closed ring of `count` texels, and the share of the second.
fn cyclic_neighbours(coordinate: f32, count: usize) -> ([usize; 2], f32) {
    let centred = coordinate * count as f32 - 0.5;
    let floor = centred.floor();
    let first = if floor < 0.0 { count - 1 } else { (floor as usize).min(count - 1) };
    ([first, if first + 1 == count { 0 } else { first + 1 }], (centred - floor).clamp(0.0, 1.0))
}
