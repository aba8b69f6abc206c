//! The world that a lookup is used in: which axis points up, and on which side the right lies.

use super::axis::SignedAxis;

/// On which side of the front the right lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Handedness {
    /// right = forward x up. The tracer's world, and the usual one in mathematics.
    #[default]
    Right,
    /// right = up x forward. The world of Direct3D, Unity, Unreal and Babylon.
    Left,
}

/// The axes of a world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct World {
    /// The axis that points upwards.
    pub up: SignedAxis,
    /// Where the right lies.
    pub handedness: Handedness,
}

impl Handedness {
    /// `right` or `left`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Left => "left",
        }
    }

    /// The right of a viewer, as a product of two other axes.
    pub fn right(self) -> &'static str {
        match self {
            Self::Right => "forward x up",
            Self::Left => "up x forward",
        }
    }
}

/// A right-handed world.
impl From<SignedAxis> for World {
    fn from(up: SignedAxis) -> Self {
        Self { up, handedness: Handedness::Right }
    }
}

impl World {
    /// The horizontal axis that a viewer looks along at the start: +y where z is the vertical axis, else -z; in left-handed
    /// worlds +x and +z.
    pub fn front(self) -> SignedAxis {
        match (self.handedness, self.up.axis == 2) {
            (Handedness::Right, true) => SignedAxis::POS_Y,
            (Handedness::Right, false) => SignedAxis::NEG_Z,
            (Handedness::Left, true) => SignedAxis::POS_X,
            (Handedness::Left, false) => SignedAxis::POS_Z,
        }
    }
}
