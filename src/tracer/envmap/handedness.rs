//! Handedness: whether a lookup mirrors its pictures. It follows from the table and from the world that it is used in.

use super::axis::SignedAxis;
use super::face::Face;
use super::lookup::{FaceLookup, Lookup};
use super::v_origin::VOrigin;
use super::world::Handedness;

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
