//! The 48 rotations and mirrorings of the cube: arrangements of all six images that close the same seams.

use super::arrangement::Arrangement;
use crate::envmap::{Face, FaceLookup, Lookup, Orientation, SignedAxis};

/// A rotation or mirroring: where x, y and z go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symmetry([SignedAxis; 3]);

impl Symmetry {
    /// All 48, the identity first.
    pub fn all() -> Vec<Self> {
        const ORDERS: [[u8; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        let signed = |order: [u8; 3], signs: u8| {
            let axis = |index: usize| SignedAxis { axis: order[index], negative: signs >> index & 1 == 1 };
            Self([axis(0), axis(1), axis(2)])
        };
        ORDERS.into_iter().flat_map(|order| (0..8).map(move |signs| signed(order, signs))).collect()
    }

    fn axis(self, axis: SignedAxis) -> SignedAxis {
        let image = self.0[usize::from(axis.axis)];
        if axis.negative { -image } else { image }
    }

    fn face(self, face: Face) -> Face {
        let negative = face.index() % 2 == 1;
        let image = self.axis(SignedAxis { axis: face.axis() as u8, negative });
        Face::on_axis(usize::from(image.axis), !image.negative)
    }

    /// The arrangement that shows the turned cube.
    pub fn of(self, arrangement: &Arrangement, lookup: &Lookup) -> Arrangement {
        let mut turned = *arrangement;
        for face in Face::ALL {
            let row = arrangement.orientation(face).of_row(lookup.row(face));
            let target = self.face(face);
            let row = FaceLookup { u: self.axis(row.u), v: self.axis(row.v), ..row };
            turned.images[target.index()] = arrangement.images[face.index()];
            turned.orientations[target.index()] = orientation_between(lookup.row(target), row);
        }
        turned
    }
}

/// The index of the orientation that makes the axes of one row into those of another of the same face.
pub fn orientation_between(from: FaceLookup, to: FaceLookup) -> usize {
    let wanted = Orientation::between(from, to);
    Orientation::ALL.iter().position(|&orientation| orientation == wanted).expect("all orientations are listed")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::Preset;

    #[test]
    fn there_are_48_different_ones() {
        let lookup = Preset::Course.lookup();
        let given = Arrangement::given(Face::ALL);
        let mut turned: Vec<Arrangement> =
            Symmetry::all().into_iter().map(|symmetry| symmetry.of(&given, &lookup)).collect();
        assert_eq!(turned[0], given);
        turned.sort();
        turned.dedup();
        assert_eq!(turned.len(), 48);
    }

    #[test]
    fn humus_y_up_is_opengl_mirrored_in_z() {
        let mirror = Symmetry([SignedAxis::POS_X, SignedAxis::POS_Y, SignedAxis::NEG_Z]);
        let opengl = Preset::Opengl.lookup();
        let turned = mirror.of(&Arrangement::given(Face::ALL), &opengl);
        let rows = Face::ALL.map(|face| {
            let row = turned.orientation(face).of_row(opengl.row(face));
            FaceLookup { image: turned.images[face.index()], ..row }
        });
        assert_eq!(Lookup::new(rows, opengl.v_origin()).unwrap(), Preset::HumusYUp.lookup());
    }
}
