//! Signed coordinate axes, the entries of lookup tables.

use std::fmt;
use std::ops::Neg;
use std::str::FromStr;

use crate::math::Vec3;

/// One of the six directions +x -x +y -y +z -z.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SignedAxis {
    /// 0 for x, 1 for y, 2 for z.
    pub axis: u8,
    /// True for -x, -y and -z.
    pub negative: bool,
}

impl SignedAxis {
    /// +x.
    pub const POS_X: Self = Self { axis: 0, negative: false };
    /// -x.
    pub const NEG_X: Self = Self { axis: 0, negative: true };
    /// +y.
    pub const POS_Y: Self = Self { axis: 1, negative: false };
    /// -y.
    pub const NEG_Y: Self = Self { axis: 1, negative: true };
    /// +z.
    pub const POS_Z: Self = Self { axis: 2, negative: false };
    /// -z.
    pub const NEG_Z: Self = Self { axis: 2, negative: true };

    /// +1 or -1.
    #[inline]
    pub fn sign(self) -> f32 {
        if self.negative { -1.0 } else { 1.0 }
    }

    /// The component of a vector along this axis.
    pub fn component(self, vector: [f32; 3]) -> f32 {
        self.sign() * vector[usize::from(self.axis)]
    }

    /// A number from 0 to 7: the axis, plus 4 if negative.
    #[inline(always)]
    pub(super) fn code(self) -> usize {
        (usize::from(self.axis) + 4 * usize::from(self.negative)) & 7
    }

    /// The unit vector along this axis.
    pub fn direction(self) -> Vec3 {
        let mut direction = [0.0; 3];
        direction[usize::from(self.axis)] = self.sign();
        Vec3::from_array(direction)
    }

    /// The axis at right angles to both, by the right-hand rule: `x.cross(y) = z`. `None` for parallel axes.
    pub fn cross(self, other: Self) -> Option<Self> {
        let cross = self.direction().cross(other.direction());
        let axis = cross.to_array().iter().position(|&component| component != 0.0)?;
        Some(Self { axis: axis as u8, negative: cross[axis] < 0.0 })
    }
}

impl Neg for SignedAxis {
    type Output = Self;

    fn neg(self) -> Self {
        Self { axis: self.axis, negative: !self.negative }
    }
}

impl fmt::Display for SignedAxis {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.negative { '-' } else { '+' };
        write!(formatter, "{sign}{}", ["x", "y", "z"][usize::from(self.axis)])
    }
}

/// As it is written: `+x`.
impl serde::Serialize for SignedAxis {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl FromStr for SignedAxis {
    type Err = String;

    /// Reads `+x`, `-x` or `x`, and so on.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (negative, name) = match text.as_bytes().first() {
            Some(b'-') => (true, &text[1..]),
            Some(b'+') => (false, &text[1..]),
            _ => (false, text),
        };
        let axis = ["x", "y", "z"].iter().position(|known| known.eq_ignore_ascii_case(name));
        match axis {
            Some(axis) => Ok(Self { axis: axis as u8, negative }),
            None => Err(format!("\"{text}\" is not an axis: expected one of +x -x +y -y +z -z")),
        }
    }
}
