//! A ray, and the surface it starts on.

use super::DVec3;

/// A half line from `origin` along `direction` (unit length up to rounding), world space.
#[derive(Debug, Clone, Copy, serde::Serialize)]
pub struct Ray {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes: a unit vector up to rounding.
    pub direction: DVec3,
    /// The surface the ray leaves; `None` for camera rays.
    ///
    /// Self-intersection is excluded by construction with it: a flat surface cannot be hit again by a ray that
    /// leaves it, and a sphere only at the other end of the chord, which has a closed form.
    #[serde(skip)]
    pub departure: Option<Departure>,
}

impl Ray {
    /// A ray that starts in free space.
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction, departure: None }
    }

    /// The point at distance `t`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }

    /// How far rounding may have put the origin from the surface it should lie on, for surfaces that the ray does not know
    /// it leaves: 8 roundoffs of the largest coordinate.
    #[inline(always)]
    pub fn origin_error(&self) -> f64 {
        self.origin.abs().max_element() * (1.0 / (1u64 << 50) as f64)
    }

    /// The departure, if it is from shape number `shape`.
    pub fn leaves(&self, shape: u32) -> Option<Departure> {
        self.departure.filter(|departure| departure.surface.shape == shape)
    }
}

/// The surface that a ray leaves, and to which side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Departure {
    /// Which surface.
    pub surface: SurfaceId,
    /// The side on which the ray goes away.
    pub side: Side,
}

/// A smooth piece of surface: the number of the shape in the scene and of the part in the shape
/// (triangle of a mesh, face of a box, 0 for shapes of one piece).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SurfaceId {
    /// Number of the shape in the scene, from 0.
    pub shape: u32,
    /// Number of the part in the shape, from 0.
    pub part: u32,
}

/// A side of a surface: where its geometric normal points, or the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The side the normal points to: outside of a closed shape.
    Front,
    /// The side the normal points away from: inside of a closed shape.
    Back,
}

impl Side {
    /// The side a direction points to, given the normal. A tangential direction counts as front.
    pub fn of(direction: DVec3, normal: DVec3) -> Self {
        if direction.dot(normal) < 0.0 { Side::Back } else { Side::Front }
    }

    /// The other side.
    pub fn opposite(self) -> Self {
        match self {
            Side::Front => Side::Back,
            Side::Back => Side::Front,
        }
    }
}
