//! Boxes in single precision.

use crate::math::{Bounds, DVec3, Vec3};

/// An axis-aligned box in `f32`, half the size of [`Bounds`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatBox {
    /// The corner with the smallest coordinates.
    pub minimum: Vec3,
    /// The corner with the largest coordinates.
    pub maximum: Vec3,
}

impl FloatBox {
    /// The box of no points: the neutral element of [`FloatBox::union`].
    pub const EMPTY: Self = Self { minimum: Vec3::INFINITY, maximum: Vec3::NEG_INFINITY };

    /// The smallest box around points, which it holds exactly.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |bounds, point| Self {
            minimum: bounds.minimum.min(point),
            maximum: bounds.maximum.max(point),
        })
    }

    /// The smallest box in `f32` that holds all of `bounds`: rounded outwards.
    pub fn containing(bounds: &Bounds) -> Self {
        Self {
            minimum: bounds.minimum.to_array().map(round_down).into(),
            maximum: bounds.maximum.to_array().map(round_up).into(),
        }
    }

    /// The smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self { minimum: self.minimum.min(other.minimum), maximum: self.maximum.max(other.maximum) }
    }

    /// Half the area of the six sides, which is proportional to the chance that a random ray hits the box.
    pub(super) fn half_area(&self) -> f64 {
        let extent = self.maximum.as_dvec3() - self.minimum.as_dvec3();
        (extent.x + extent.y) * extent.z + extent.x * extent.y
    }

    /// The same box in `f64`.
    pub fn to_bounds(self) -> Bounds {
        Bounds { minimum: self.minimum.as_dvec3(), maximum: self.maximum.as_dvec3() }
    }

    /// The largest distance from `point` to a point of the box along any one axis.
    pub(super) fn reach(&self, point: DVec3) -> f64 {
        let below = (point - self.minimum.as_dvec3()).abs();
        let above = (self.maximum.as_dvec3() - point).abs();
        below.max(above).max_element()
    }
}

/// The largest `f32` that is not above `value`.
fn round_down(value: f64) -> f32 {
    let nearest = value as f32;
    if f64::from(nearest) > value { nearest.next_down() } else { nearest }
}

/// The smallest `f32` that is not below `value`.
fn round_up(value: f64) -> f32 {
    let nearest = value as f32;
    if f64::from(nearest) < value { nearest.next_up() } else { nearest }
}
