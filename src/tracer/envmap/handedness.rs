//! Handedness: whether a lookup mirrors its pictures. It follows from the table and from the world that it is used in.

use super::axis::SignedAxis;
use super::face::Face;
use super::lookup::{FaceLookup, Lookup};
use super::v_origin::VOrigin;

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

impl Lookup {
    /// True if the face shows its picture mirrored to an observer inside the cube.
    ///
    /// With r the direction of growing u and t the direction from the bottom to the top of the image, r x t points
    /// back at the viewer when a photograph taken looking outwards is seen right (`conventions.md`, "Handedness"). In a
    /// left-handed world it points outwards then.
    pub fn mirrors(&self, face: Face) -> bool {
        let row = self.row(face);
        let towards_top = match self.v_origin() {
            VOrigin::Top => -row.v,
            VOrigin::Bottom => row.v,
        };
        let outwards = row.u.direction().cross(towards_top.direction()).dot(face.normal()) > 0.0;
        outwards == (self.handedness() == Handedness::Right)
    }

    /// All rows with v counted from the top: the same for two tables that read alike.
    pub fn rows_from_top(&self) -> [FaceLookup; 6] {
        Face::ALL.map(|face| self.row_counted_from(face, VOrigin::Top))
    }

    /// The table that reads along d what this one reads along d with one axis negated.
    pub fn reflected(&self, axis: u8) -> Self {
        let reflect = |signed: SignedAxis| if signed.axis == axis { -signed } else { signed };
        let rows = Face::ALL.map(|face| {
            let row = self.row(reflect(face.signed_axis()).face());
            FaceLookup { u: reflect(row.u), v: reflect(row.v), ..row }
        });
        self.with_rows(rows).expect("reflected axes span the reflected face")
    }
}
