//! Axis-aligned bounding boxes.

use super::{DAffine3, DVec3};

/// An axis-aligned box, `minimum <= maximum` in each component; [`Bounds::EMPTY`] contains nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The corner with the smallest coordinates.
    pub minimum: DVec3,
    /// The corner with the largest coordinates.
    pub maximum: DVec3,
}

impl Bounds {
    /// The box of no points: the neutral element of [`Bounds::union`].
    pub const EMPTY: Self = Self { minimum: DVec3::INFINITY, maximum: DVec3::NEG_INFINITY };

    /// The smallest box around the points.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |bounds, point| Self {
            minimum: bounds.minimum.min(point),
            maximum: bounds.maximum.max(point),
        })
    }

    /// The smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self { minimum: self.minimum.min(other.minimum), maximum: self.maximum.max(other.maximum) }
    }

    /// Edge lengths; negative for the empty box.
    pub fn extent(self) -> DVec3 {
        self.maximum - self.minimum
    }

    /// The eight corners.
    pub fn corners(self) -> [DVec3; 8] {
        std::array::from_fn(|corner| {
            let pick = |bit: usize, low: f64, high: f64| if corner >> bit & 1 == 0 { low } else { high };
            DVec3::new(
                pick(0, self.minimum.x, self.maximum.x),
                pick(1, self.minimum.y, self.maximum.y),
                pick(2, self.minimum.z, self.maximum.z),
            )
        })
    }

    /// The box around the transformed box.
    pub fn transformed(self, transform: &DAffine3) -> Self {
        Self::around(self.corners().map(|corner| transform.transform_point3(corner)))
    }
}
