//! The twelve edges of the cube, and where each lies on the two faces that meet there.
//!
//! ```text
//!         side Top (v = 1)
//!        +--------------->          A border is a side of a picture, walked in the direction of the growing
//!        ^               ^          coordinate (u along v = 0 and v = 1, v along u = 0 and u = 1), or against it.
//!  u = 0 |               | u = 1
//!        +--------------->
//!            v = 0
//! ```

use crate::envmap::{Face, FaceLookup, Lookup, Orientation};

/// An edge of the cube: the two faces that meet there, in the order of [`Face::ALL`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Edge {
    /// The face that comes first in [`Face::ALL`].
    pub first: Face,
    /// The other face.
    pub second: Face,
}

/// By its name.
impl serde::Serialize for Edge {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

impl Edge {
    /// All twelve: +x+y +x-y +x+z +x-z -x+y -x-y -x+z -x-z +y+z +y-z -y+z -y-z.
    pub const ALL: [Self; 12] = {
        const fn edge(first: Face, second: Face) -> Edge {
            Edge { first, second }
        }
        use Face::{NegX, NegY, NegZ, PosX, PosY, PosZ};
        [
            edge(PosX, PosY),
            edge(PosX, NegY),
            edge(PosX, PosZ),
            edge(PosX, NegZ),
            edge(NegX, PosY),
            edge(NegX, NegY),
            edge(NegX, PosZ),
            edge(NegX, NegZ),
            edge(PosY, PosZ),
            edge(PosY, NegZ),
            edge(NegY, PosZ),
            edge(NegY, NegZ),
        ]
    };

    /// `+x+y`.
    pub fn name(self) -> String {
        format!("{}{}", self.first.signed_name(), self.second.signed_name())
    }

    /// True if the face is one of the two.
    pub fn touches(self, face: Face) -> bool {
        self.first == face || self.second == face
    }
}

/// A side of a picture in texture coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// u = 0
    Left,
    /// u = 1
    Right,
    /// v = 0
    Zero,
    /// v = 1
    One,
}

impl Side {
    pub const ALL: [Self; 4] = [Side::Left, Side::Right, Side::Zero, Side::One];

    pub fn index(self) -> usize {
        self as usize
    }

    /// The texture coordinates of a place on the picture: `along` the side from its start, `inwards` from the side,
    /// both in `[0, 1]`.
    pub fn place(self, along: f32, inwards: f32) -> (f32, f32) {
        match self {
            Side::Left => (inwards, along),
            Side::Right => (1.0 - inwards, along),
            Side::Zero => (along, inwards),
            Side::One => (along, 1.0 - inwards),
        }
    }
}

/// A side of a picture and the direction in which it is walked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Border {
    pub side: Side,
    /// True if the walk goes against the growing coordinate.
    pub reversed: bool,
}

impl Border {
    /// Where the edge between `face` and `neighbour`, walked along the growing free axis, lies on the face as the row
    /// of a lookup sees it.
    pub fn of_face(row: FaceLookup, face: Face, neighbour: Face) -> Self {
        debug_assert_ne!(face.axis(), neighbour.axis());
        let towards_positive = neighbour.normal().max_element() > 0.0;
        if usize::from(row.u.axis) == neighbour.axis() {
            let side = if towards_positive == row.u.negative { Side::Left } else { Side::Right };
            Self { side, reversed: row.v.negative }
        } else {
            let side = if towards_positive == row.v.negative { Side::Zero } else { Side::One };
            Self { side, reversed: row.u.negative }
        }
    }

    /// The same edge on the picture when the face reads it at `orientation(u, v)`.
    pub fn in_orientation(self, orientation: Orientation) -> Self {
        let along = if self.reversed { 0.75 } else { 0.25 };
        let (u, v) = self.side.place(along, 0.0);
        let (u, v) = orientation.apply(u, v);
        let ends = [(u == 0.0, Side::Left, v), (u == 1.0, Side::Right, v), (v == 0.0, Side::Zero, u)];
        let (_, side, along) = ends.into_iter().find(|end| end.0).unwrap_or((true, Side::One, u));
        Self { side, reversed: along > 0.5 }
    }
}

/// The borders that meet at each edge under a lookup, for every orientation of either face.
#[derive(Debug, Clone)]
pub struct EdgeBorders {
    /// By edge, end (first, second face) and index of the orientation in [`Orientation::ALL`].
    borders: [[[Border; 8]; 2]; 12],
}

impl EdgeBorders {
    pub fn new(lookup: &Lookup) -> Self {
        let all = |face: Face, neighbour: Face| {
            Orientation::ALL
                .map(|orientation| Border::of_face(lookup.row(face), face, neighbour).in_orientation(orientation))
        };
        let borders = Edge::ALL.map(|Edge { first, second }| [all(first, second), all(second, first)]);
        Self { borders }
    }

    /// The borders of both faces at an edge, each under the orientation of that index.
    pub fn at(&self, edge: usize, orientations: [usize; 2]) -> [Border; 2] {
        [self.borders[edge][0][orientations[0]], self.borders[edge][1][orientations[1]]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::{FacePoint, Preset};

    #[test]
    fn names_are_those_of_the_report() {
        let names: Vec<String> = Edge::ALL.iter().map(|edge| edge.name()).collect();
        assert_eq!(names.join(" "), "+x+y +x-y +x+z +x-z -x+y -x-y -x+z -x-z +y+z +y-z -y+z -y-z");
    }

    #[test]
    fn a_border_holds_the_points_of_its_edge() {
        for preset in Preset::ALL {
            let lookup = preset.lookup();
            for edge in Edge::ALL {
                for (face, neighbour) in [(edge.first, edge.second), (edge.second, edge.first)] {
                    let border = Border::of_face(lookup.row(face), face, neighbour);
                    let free = 3 - face.axis() - neighbour.axis();
                    for along in [0.25_f32, 0.5, 0.875] {
                        let walked = if border.reversed { 1.0 - along } else { along };
                        let (u, v) = border.side.place(walked, 0.0);
                        let direction = lookup.direction(FacePoint { face, u, v });
                        let mut expected = face.normal() + neighbour.normal();
                        expected[free] = 2.0 * along - 1.0;
                        assert_eq!(direction, expected, "{} {}", preset.name(), edge.name());
                    }
                }
            }
        }
    }

    #[test]
    fn an_oriented_border_is_the_border_of_the_oriented_row() {
        for orientation in Orientation::ALL {
            for edge in Edge::ALL {
                let row = Preset::Course.lookup().row(edge.first);
                let placed = Border::of_face(row, edge.first, edge.second).in_orientation(orientation);
                assert_eq!(
                    placed,
                    Border::of_face(orientation.of_row(row), edge.first, edge.second),
                    "{orientation:?}"
                );
            }
        }
    }
}
