//! The six faces of a cube.

use super::axis::SignedAxis;
use crate::math::Vec3;

/// A face of the cube, named after the axis it lies on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Face {
    /// The face at +x.
    PosX,
    /// The face at -x.
    NegX,
    /// The face at +y.
    PosY,
    /// The face at -y.
    NegY,
    /// The face at +z.
    PosZ,
    /// The face at -z.
    NegZ,
}

impl Face {
    /// All faces in the order of files and JSON: +X -X +Y -Y +Z -Z.
    pub const ALL: [Face; 6] = [Face::PosX, Face::NegX, Face::PosY, Face::NegY, Face::PosZ, Face::NegZ];

    /// Position in [`Face::ALL`], 0 to 5.
    #[inline]
    pub fn index(self) -> usize {
        self as usize
    }

    /// Number of the axis the face lies on: 0 for x, 1 for y, 2 for z.
    pub fn axis(self) -> usize {
        self.index() / 2
    }

    /// The face in the direction of growing (`positive`) or falling coordinate on axis 0, 1 or 2.
    pub fn on_axis(axis: usize, positive: bool) -> Self {
        Self::ALL[2 * axis + usize::from(!positive)]
    }

    /// The name in files and JSON: `posx`.
    pub fn name(self) -> &'static str {
        ["posx", "negx", "posy", "negy", "posz", "negz"][self.index()]
    }

    /// The name with a sign: `+x`.
    pub fn signed_name(self) -> &'static str {
        ["+x", "-x", "+y", "-y", "+z", "-z"][self.index()]
    }

    /// The name in the course's C++ code: `POS_X`.
    pub fn constant_name(self) -> &'static str {
        ["POS_X", "NEG_X", "POS_Y", "NEG_Y", "POS_Z", "NEG_Z"][self.index()]
    }

    /// The axis through the middle of the face, outwards.
    pub fn signed_axis(self) -> SignedAxis {
        SignedAxis { axis: self.axis() as u8, negative: self.index() % 2 == 1 }
    }

    /// The unit direction through the middle of the face.
    pub fn normal(self) -> Vec3 {
        let sign = if self.index().is_multiple_of(2) { 1.0 } else { -1.0 };
        let mut normal = [0.0; 3];
        normal[self.axis()] = sign;
        Vec3::from_array(normal)
    }
}

impl SignedAxis {
    /// The face of the cube that this axis goes through.
    pub fn face(self) -> Face {
        Face::on_axis(usize::from(self.axis), !self.negative)
    }
}
