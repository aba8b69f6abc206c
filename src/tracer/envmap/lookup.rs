//! The lookup: the table that turns a direction into a place in one of six pictures, and back.
//!
//! For a face with the signed axes `a` (of u) and `b` (of v), seen along the face's own axis:
//!
//! ```text
//!     v = 1  +---------+        m = |d| along the face's axis, the largest component
//!            |         |        u = (a.d / m + 1) / 2
//!       b ^  |    o    |        v = (b.d / m + 1) / 2
//!         |  |         |        direction = axis + (2u - 1) a + (2v - 1) b
//!     v = 0  +---------+
//!          u = 0  a-> u = 1
//! ```

use super::axis::SignedAxis;
use super::face::Face;
use super::v_origin::VOrigin;
use super::world::Handedness;
use crate::math::functions::clamp_number;
use crate::math::{DVec3, Vec3};
use crate::picture::Picture;

/// A lookup table, as the head of [`envmap`](super) describes it: per face the image it reads, the signed axis of u, the
/// signed axis of v; and once for the table where v = 0 lies. The tracer, the baker and every check go through it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lookup {
    faces: [FaceLookup; 6],
    v_origin: VOrigin,
    handedness: Handedness,
}

/// One row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FaceLookup {
    /// The image the face reads, by the name of the image.
    pub image: Face,
    /// The axis along which u grows.
    pub u: SignedAxis,
    /// The axis along which v grows.
    pub v: SignedAxis,
}

/// A place on the cube: a face and its coordinates u and v, both in `[0, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacePoint {
    /// The face that the direction meets.
    pub face: Face,
    /// Along the signed axis of u.
    pub u: f32,
    /// Along the signed axis of v.
    pub v: f32,
}

/// A place in a picture: which image, and how far from its left and top border, both in `[0, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImagePoint {
    /// By its name.
    pub image: Face,
    /// From the left border: 0 to 1.
    pub right: f32,
    /// From the top border: 0 to 1.
    pub down: f32,
}

impl ImagePoint {
    /// The place in texels from the top left corner; texel centres are at half integers.
    #[inline]
    pub fn texels(&self, picture: &Picture) -> (f32, f32) {
        (self.right * picture.width() as i32 as f32, self.down * picture.height() as i32 as f32)
    }

    /// The colour of the texel this place falls into.
    #[inline]
    pub fn nearest(&self, picture: &Picture) -> Vec3 {
        let (x, y) = self.texels(picture);
        picture.nearest(x, y)
    }
}

impl Lookup {
    /// A table from its rows. An error says which face's axes do not span that face.
    pub fn new(faces: [FaceLookup; 6], v_origin: VOrigin) -> Result<Self, String> {
        for (face, row) in Face::ALL.into_iter().zip(&faces) {
            let axes = [face.axis(), usize::from(row.u.axis), usize::from(row.v.axis)];
            if axes[0] == axes[1] || axes[0] == axes[2] || axes[1] == axes[2] {
                let (face, u, v) = (face.name(), row.u, row.v);
                return Err(format!(
                    "{face}: u = {u} and v = {v} do not span the face: use both other axes, once each"
                ));
            }
        }
        Ok(Self { faces, v_origin, handedness: Handedness::Right })
    }

    /// The same table with other rows.
    pub fn with_rows(&self, faces: [FaceLookup; 6]) -> Result<Self, String> {
        Ok(Self { handedness: self.handedness, ..Self::new(faces, self.v_origin)? })
    }

    /// The same table for the directions of a left- or right-handed world.
    pub fn in_world(self, handedness: Handedness) -> Self {
        Self { handedness, ..self }
    }

    /// The handedness of the world whose directions it gets; no direction is located otherwise because of it.
    pub fn handedness(&self) -> Handedness {
        self.handedness
    }

    /// The row of a face.
    #[inline]
    pub fn row(&self, face: Face) -> FaceLookup {
        self.faces[face.index()]
    }

    /// The row of a face with v counted from `v_origin`: from the other end, v grows the other way.
    pub fn row_counted_from(&self, face: Face, v_origin: VOrigin) -> FaceLookup {
        let row = self.row(face);
        if v_origin == self.v_origin { row } else { FaceLookup { v: -row.v, ..row } }
    }

    /// All rows in the order of [`Face::ALL`].
    pub fn rows(&self) -> &[FaceLookup; 6] {
        &self.faces
    }

    /// The row of every image at v = 0.
    pub fn v_origin(&self) -> VOrigin {
        self.v_origin
    }

    /// Where the direction meets the cube. Its length does not matter; on a tie x wins over y, y over z.
    ///
    /// Defined for every input: u and v are in `[0, 1]`, and 0 where a component is not a number or the quotient of
    /// two infinities or zeros.
    #[inline]
    pub fn locate(&self, direction: Vec3) -> FacePoint {
        let face = Self::face_towards(direction);
        let components = signed_components(direction);
        let largest = components[face.axis()].abs();
        let row = &self.faces[face.index()];
        let u = components[row.u.code()] / largest;
        let v = components[row.v.code()] / largest;
        FacePoint { face, u: unit_interval(u), v: unit_interval(v) }
    }

    /// The face that a direction meets.
    #[inline(always)]
    pub(super) fn face_towards(direction: Vec3) -> Face {
        let Vec3 { x, y, z } = direction;
        let (along_x, along_y, along_z) = (x.abs(), y.abs(), z.abs());
        if along_x >= along_y && along_x >= along_z {
            if x > 0.0 { Face::PosX } else { Face::NegX }
        } else if along_y >= along_z {
            if y > 0.0 { Face::PosY } else { Face::NegY }
        } else if z > 0.0 {
            Face::PosZ
        } else {
            Face::NegZ
        }
    }

    /// The direction through a place on the cube: the inverse of [`Lookup::locate`], from the same table.
    /// Not of unit length: its largest component is 1.
    #[inline]
    pub fn direction(&self, point: FacePoint) -> Vec3 {
        let row = self.faces[point.face.index()];
        point.face.normal() + row.u.direction() * (2.0 * point.u - 1.0) + row.v.direction() * (2.0 * point.v - 1.0)
    }

    /// Where in which picture the colour of a place on the cube stands.
    #[inline]
    pub fn image_point(&self, point: FacePoint) -> ImagePoint {
        let down = match self.v_origin {
            VOrigin::Top => point.v,
            VOrigin::Bottom => 1.0 - point.v,
        };
        ImagePoint { image: self.faces[point.face.index()].image, right: point.u, down }
    }

    /// The direction through a place of the image that a face reads, `right` and `down` in `[0, 1]` from its top left
    /// corner; not of unit length.
    pub fn image_direction(&self, face: Face, right: f64, down: f64) -> DVec3 {
        let row = self.faces[face.index()];
        let v = match self.v_origin {
            VOrigin::Top => down,
            VOrigin::Bottom => 1.0 - down,
        };
        let axis = |axis: SignedAxis| axis.direction().as_dvec3();
        face.normal().as_dvec3() + axis(row.u) * (2.0 * right - 1.0) + axis(row.v) * (2.0 * v - 1.0)
    }
}

/// The components along +x +y +z, a pad, and along -x -y -z: indexed by [`SignedAxis::code`].
#[inline(always)]
fn signed_components(vector: Vec3) -> [f32; 8] {
    let Vec3 { x, y, z } = vector;
    [x, y, z, 0.0, -x, -y, -z, 0.0]
}

/// From `[-1, 1]` to `[0, 1]`; NaN gives 0.
#[inline(always)]
fn unit_interval(coordinate: f32) -> f32 {
    clamp_number((coordinate + 1.0) * 0.5, 0.0, 1.0)
}
