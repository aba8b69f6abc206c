//! A map for another lookup: the same six images under other names, turned and mirrored.

use super::face::Face;
use super::lookup::Lookup;
use super::orientation::{ImageOperation, Orientation};
use super::v_origin::VOrigin;

/// An image of the new map: which image of the old map it is, and what is done to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MovedImage {
    /// The image of the new map, by its name.
    pub target: Face,
    /// The image of the old map.
    pub source: Face,
    /// What makes the old one into the new one.
    pub operation: ImageOperation,
}

/// What makes the images that `from` reads into images that `to` reads: through both, every direction has the same colour.
/// Face by face of the cube.
pub fn moved_images(from: &Lookup, to: &Lookup) -> [MovedImage; 6] {
    Face::ALL.map(|face| {
        let [old, new] = [from, to].map(|lookup| lookup.row_counted_from(face, VOrigin::Top));
        // The new image holds at (u, v) what the old one holds at (u', v').
        let operation = Orientation::between(new, old).image_operation(VOrigin::Top);
        MovedImage { target: new.image, source: old.image, operation }
    })
}
