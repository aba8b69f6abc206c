//! The source of a material's colour.

use std::sync::Arc;

use crate::math::functions::floor;
use crate::math::{DVec2, Vec3};
use crate::picture::Texture;
use crate::shapes::TexturePoint;

/// A colour over a surface: one for all, two in a checker, a picture, or the colours of a mesh's vertices.
#[derive(Debug, Clone)]
pub enum ColourSource {
    /// One linear RGB colour.
    Uniform(Vec3),
    /// Two colours in squares.
    Checker(Checker),
    /// A picture over texture coordinates.
    Image(ImageTexture),
    /// The colours of the vertices, interpolated.
    Vertex,
}

/// Two colours in squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Checker {
    /// Linear RGB of the square at the origin of the texture coordinates, and of every second one.
    pub even: Vec3,
    /// Linear RGB of the squares beside them.
    pub odd: Vec3,
    /// Squares a unit of each texture coordinate.
    pub repeat: DVec2,
}

/// A picture over texture coordinates.
#[derive(Debug, Clone)]
pub struct ImageTexture {
    /// The picture, its filter, and what it shows outside `[0, 1]`.
    pub texture: Arc<Texture>,
    /// Pictures a unit of each texture coordinate.
    pub repeat: DVec2,
}

impl ColourSource {
    /// Linear colour at a point of a surface.
    #[inline]
    pub fn at(&self, point: TexturePoint) -> Vec3 {
        match self {
            ColourSource::Uniform(colour) => *colour,
            ColourSource::Checker(checker) => checker.at(point.coordinates),
            ColourSource::Image(image) => image.at(point.coordinates),
            ColourSource::Vertex => point.vertex_colour,
        }
    }
}

impl Checker {
    fn at(&self, texture_coordinates: DVec2) -> Vec3 {
        let place = texture_coordinates * self.repeat;
        if (floor(place.x) ^ floor(place.y)) & 1 == 0 { self.even } else { self.odd }
    }
}

impl ImageTexture {
    fn at(&self, texture_coordinates: DVec2) -> Vec3 {
        let place = texture_coordinates * self.repeat;
        // Whole repeats are taken off in f64, where far places still have their fraction.
        let fraction = place - place.floor();
        self.texture.sample(fraction.x as f32, (1.0 - fraction.y) as f32)
    }
}
