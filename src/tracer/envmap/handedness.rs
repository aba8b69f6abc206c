//! Handedness: whether a lookup mirrors its pictures. It follows from the table alone.

use super::face::Face;
use super::lookup::Lookup;
use super::v_origin::VOrigin;

impl Lookup {
    /// True if the face shows its picture mirrored to an observer inside the cube of a right-handed world.
    ///
    /// With r the direction of growing u and t the direction from the bottom to the top of the image, r x t points
    /// back at the viewer when a photograph taken looking outwards is seen right (`conventions.md`, "Handedness").
    pub fn mirrors(&self, face: Face) -> bool {
        let row = self.row(face);
        let towards_top = match self.v_origin() {
            VOrigin::Top => -row.v,
            VOrigin::Bottom => row.v,
        };
        row.u.direction().cross(towards_top.direction()).dot(face.normal()) > 0.0
    }
}
