//! The limits within which the bounds of all cases are promised. `skycube stress` measures that the bounds hold, and
//! `skycube render` warns of scenes outside the limits.

/// From the least to the most, both included.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Range {
    /// The least value inside.
    pub least: f64,
    /// The greatest value inside.
    pub most: f64,
}

/// One limit and the cases that measure it.
#[derive(Debug, Clone, Copy)]
pub struct Limit {
    /// What is limited.
    pub figure: &'static str,
    /// Where the promised accuracy holds.
    pub range: Range,
    /// The case that promises its bound over the whole range.
    pub case: &'static str,
}

impl Range {
    pub(crate) const fn new(least: f64, most: f64) -> Self {
        Self { least, most }
    }

    /// True if the number lies inside; false if it is not a number.
    pub fn holds(self, number: f64) -> bool {
        (self.least..=self.most).contains(&number)
    }
}

/// Radius of a sphere, in units of the scene.
pub const RADIUS: Limit = Limit { figure: "the radius", range: Range::new(1e-6, 1e6), case: "sphere-radius" };

/// Distance of a shape from the world's origin.
pub const COORDINATE: Limit = Limit { figure: "the coordinate", range: Range::new(0.0, 1e7), case: "coordinates" };

/// Distance of a shape from the world's origin, over its size.
pub const REMOTENESS: Limit =
    Limit { figure: "the coordinate over the size", range: Range::new(0.0, 1e6), case: "self-sphere" };

/// Scale of a transform along an axis.
pub const SCALE: Limit = Limit { figure: "the scale", range: Range::new(1e-4, 1e4), case: "transforms" };

/// Largest coordinate of a mesh's vertices over the mesh's size, in its own space: vertices are `f32`.
pub const VERTEX_REMOTENESS: Limit = Limit {
    figure: "the coordinate of vertices over the size of the mesh",
    range: Range::new(0.0, 1e4),
    case: "mesh-vertices",
};

/// Index of refraction.
pub const INDEX: Limit =
    Limit { figure: "the index of refraction", range: Range::new(1e-6, 1e6), case: "fresnel-index" };

/// Roughness of metals, coats and glass.
pub const ROUGHNESS: Limit = Limit { figure: "the roughness", range: Range::new(1e-4, 1.0), case: "furnace" };

/// Area of a light source over the square of its distance.
pub const LIGHT_AREA: Limit =
    Limit { figure: "the area of the light", range: Range::new(1e-6, f64::INFINITY), case: "small-light" };

/// Texels along the side of a face.
pub const FACE_SIZE: Limit = Limit { figure: "the side of a face", range: Range::new(1.0, 16_384.0), case: "texels" };

/// Glasses inside of one another.
pub const NESTING: Limit = Limit { figure: "the count of nested glasses", range: Range::new(1.0, 7.0), case: "nested" };

/// All of them.
pub const LIMITS: [Limit; 10] =
    [RADIUS, COORDINATE, REMOTENESS, SCALE, VERTEX_REMOTENESS, INDEX, ROUGHNESS, LIGHT_AREA, FACE_SIZE, NESTING];
