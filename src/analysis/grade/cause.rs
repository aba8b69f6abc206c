//! The usual mistakes in a `get_texel`, recognised by their effect on the six shots.

use super::explanation::FaceGrade;
use super::placement::{Placement, ShotFrame, on_screen};
use super::thresholds::angle::DEGREES;
use super::{Alternative, Grade, Misfit};
use crate::envmap::{Face, Lookup, Orientation, SignedAxis};

/// A slip that explains what the shots show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// v = 0 is the other row of the image in all six cases.
    VFromTheOtherEnd,
    /// u = 0 is the other column of the image in all six cases.
    UFromTheOtherEnd,
    /// The division is by the component itself, not by its absolute value.
    AbsForgotten,
    /// `0.5 + x / m` in place of `0.5 + 0.5 x / m`.
    NotHalved,
    /// What two cases of the switch compute is exchanged.
    CasesExchanged([Face; 2]),
    /// u is used for v, or v for u.
    OneCoordinateTwice(Face),
    /// The shots along the vertical axis are black: the camera's up is parallel to its view.
    UpAlongTheView,
}

/// The angle of a camera that sees as much as code that does not halve the coordinates: the scale is 2.
const NOT_HALVED: f64 = 126.87;

impl Grade {
    /// What the code does for each face if the camera is right.
    fn faces_of_code(&self) -> &[FaceGrade; 6] {
        for alternative in &self.alternatives {
            if let Alternative::Lookup(faces) = alternative {
                return faces;
            }
        }
        &self.faces
    }

    /// The slips that explain these shots, the likeliest first. `lookup` is the one that the code should have.
    pub fn causes(&self, lookup: &Lookup, world_up: SignedAxis) -> Vec<Cause> {
        let faces = self.faces_of_code();
        let shows = |face: &FaceGrade, inverts_u: bool, inverts_v: bool| {
            let orientation = Orientation { swaps: false, inverts_u, inverts_v };
            face.possible.contains(&Placement { image: face.expected, orientation })
        };
        let negative = |face: &FaceGrade| face.face.index() % 2 == 1;
        let mut causes = Vec::new();
        if faces.iter().any(FaceGrade::is_wrong) {
            if faces.iter().all(|face| shows(face, false, true)) {
                causes.push(Cause::VFromTheOtherEnd);
            } else if faces.iter().all(|face| shows(face, true, false)) {
                causes.push(Cause::UFromTheOtherEnd);
            } else if faces.iter().all(|face| shows(face, negative(face), negative(face))) {
                causes.push(Cause::AbsForgotten);
            }
            causes.extend(exchanged_cases(faces, lookup));
        }
        if self.unhalved || self.field_of_view.is_some_and(|angle| (angle - NOT_HALVED).abs() < DEGREES) {
            causes.push(Cause::NotHalved);
        }
        let twice = self.faces.iter().filter(|face| face.misfit == Some(Misfit::OneCoordinate));
        causes.extend(twice.map(|face| Cause::OneCoordinateTwice(face.face)));
        let vertical = |face: &FaceGrade| face.shot.axis() == usize::from(world_up.axis);
        if self.faces.iter().all(|face| vertical(face) == (face.misfit == Some(Misfit::Black))) {
            causes.push(Cause::UpAlongTheView);
        }
        causes
    }

    /// The lookup that the code has: the most plausible one, and the right row where the pixels tell nothing.
    pub fn lookup_of_code(&self, lookup: &Lookup) -> Lookup {
        let faces = self.faces_of_code();
        let rows = Face::ALL.map(|face| {
            let row = lookup.row(face);
            let grade = &faces[face.index()];
            match grade.placement().filter(|_| grade.is_wrong()) {
                Some(Placement { image, orientation }) => {
                    crate::envmap::FaceLookup { image, ..orientation.of_row(row) }
                }
                None => row,
            }
        });
        lookup.with_rows(rows).expect("a row in another orientation spans its face")
    }
}

/// Two opposite faces, each of which is read as the other should be, while the others are right.
fn exchanged_cases(faces: &[FaceGrade; 6], lookup: &Lookup) -> Option<Cause> {
    let wrong: Vec<Face> = faces.iter().filter(|face| face.is_wrong()).map(|face| face.face).collect();
    let [one, other] = wrong[..] else { return None };
    let reads_as = |face: Face, other: Face| {
        let orientation = Orientation::between(lookup.row(face), lookup.row(other));
        faces[face.index()].possible.contains(&Placement { image: lookup.row(other).image, orientation })
    };
    let exchanged = one.axis() == other.axis() && reads_as(one, other) && reads_as(other, one);
    exchanged.then_some(Cause::CasesExchanged([one, other]))
}

/// The other up vectors that a shot's camera may have had, and what the case of its face would then need.
pub fn other_ups(lookup: &Lookup, frame: ShotFrame) -> Vec<(SignedAxis, Orientation)> {
    let row = lookup.row(frame.face);
    let seen = on_screen(row, frame.right, frame.up);
    let forward = frame.face.signed_axis();
    let ups = [-frame.up, frame.right, -frame.right];
    let repair = |up: SignedAxis| {
        let right = forward.cross(up).expect("up is at a right angle to the view");
        // The code shows `seen` where this camera should see another part of the face.
        (up, on_screen(row, right, up).after(seen.inverse()))
    };
    ups.map(repair).to_vec()
}
