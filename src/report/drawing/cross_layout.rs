//! The unfolded cross: where each face lies, and which sides of cells are the same edge of the cube.
//!
//! ```text
//!             +-------+                     Every cell is an axis shot: seen from inside, right = forward x up.
//!             |  top  |                     Five edges join two cells of the cross. The other seven are torn apart
//!     +-------+-------+-------+-------+     and wear a letter on both their sides.
//!     | left  | front | right | back  |
//!     +-------+-------+-------+-------+
//!             | bottom|
//!             +-------+
//! ```

use crate::envmap::{Face, SignedAxis};
use crate::render::{AxisShot, front};

/// A side of a cell, as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    Top,
    Right,
    Bottom,
    Left,
}

/// The place of one face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CrossCell {
    /// How the face is seen.
    pub shot: AxisShot,
    /// 0 to 3 from the left.
    pub column: usize,
    /// 0 to 2 from the top.
    pub row: usize,
}

/// An edge of the cube in the cross.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CrossEdge {
    /// The two faces, in the order of [`Face::ALL`].
    pub faces: [Face; 2],
    /// The side of either face's cell.
    pub sides: [Side; 2],
    /// The letter of an edge whose cells are not beside each other, from A on.
    pub letter: Option<char>,
}

/// The whole cross.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CrossLayout {
    /// In the order of [`Face::ALL`].
    pub cells: [CrossCell; 6],
    pub edges: Vec<CrossEdge>,
}

impl Side {
    const ALL: [Self; 4] = [Side::Top, Side::Right, Side::Bottom, Side::Left];

    /// One cell further: columns to the right, rows down.
    pub fn step(self) -> (isize, isize) {
        match self {
            Side::Top => (0, -1),
            Side::Right => (1, 0),
            Side::Bottom => (0, 1),
            Side::Left => (-1, 0),
        }
    }
}

impl CrossCell {
    /// The face across a side.
    pub fn neighbour(&self, side: Side) -> Face {
        let axis = match side {
            Side::Top => self.shot.up,
            Side::Right => self.shot.right(),
            Side::Bottom => -self.shot.up,
            Side::Left => -self.shot.right(),
        };
        axis.face()
    }

    /// The side towards a neighbour. None for the face itself and its opposite.
    pub fn side_towards(&self, neighbour: Face) -> Option<Side> {
        Side::ALL.into_iter().find(|&side| self.neighbour(side) == neighbour)
    }
}

impl CrossLayout {
    /// The cross of a world whose vertical axis is `world_up`.
    pub fn new(world_up: SignedAxis) -> Self {
        let front = front(world_up);
        let right = AxisShot::new(front.face(), world_up).right();
        let cells = Face::ALL.map(|face| {
            let axis = face.signed_axis();
            let places = [(-right, 0, 1), (front, 1, 1), (right, 2, 1), (-front, 3, 1), (world_up, 1, 0)];
            let place = places.into_iter().find(|(known, ..)| *known == axis);
            let (_, column, row) = place.unwrap_or((-world_up, 1, 2));
            CrossCell { shot: AxisShot::new(face, world_up), column, row }
        });
        Self { cells, edges: edges(&cells) }
    }

    /// The cell of a face.
    pub fn cell(&self, face: Face) -> &CrossCell {
        &self.cells[face.index()]
    }
}

/// The twelve edges, +x+y +x-y +x+z +x-z -x+y -x-y -x+z -x-z +y+z +y-z -y+z -y-z.
fn edges(cells: &[CrossCell; 6]) -> Vec<CrossEdge> {
    let mut letters = 'A'..='G';
    let mut edges = Vec::new();
    for first in Face::ALL {
        for second in Face::ALL.into_iter().filter(|second| second.axis() > first.axis()) {
            let (one, other) = (&cells[first.index()], &cells[second.index()]);
            let sides = one.side_towards(second).zip(other.side_towards(first));
            let sides = sides.expect("faces on different axes have an edge").into();
            let letter = if are_beside(one, other, sides) { None } else { letters.next() };
            edges.push(CrossEdge { faces: [first, second], sides, letter });
        }
    }
    edges
}

/// True if the two sides are one line of the cross.
fn are_beside(one: &CrossCell, other: &CrossCell, sides: [Side; 2]) -> bool {
    let reaches = |from: &CrossCell, side: Side, to: &CrossCell| {
        let (columns, rows) = side.step();
        from.column as isize + columns == to.column as isize && from.row as isize + rows == to.row as isize
    };
    reaches(one, sides[0], other) && reaches(other, sides[1], one)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined(layout: &CrossLayout) -> String {
        let joined = layout.edges.iter().filter(|edge| edge.letter.is_none());
        joined.map(|edge| edge.faces.map(Face::signed_name).concat()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn the_inner_edges_join_the_faces_of_the_drawing() {
        // z up: left -x, front +y, right +x, back -y.
        assert_eq!(joined(&CrossLayout::new(SignedAxis::POS_Z)), "+x+y +x-y -x+y +y+z +y-z");
        // y up: left -x, front -z, right +x, back +z.
        assert_eq!(joined(&CrossLayout::new(SignedAxis::POS_Y)), "+x+z +x-z -x-z +y-z -y-z");
    }

    #[test]
    fn both_ends_of_a_shared_side_are_the_same_points_of_the_cube() {
        for world_up in Face::ALL.map(Face::signed_axis) {
            let layout = CrossLayout::new(world_up);
            assert_eq!(layout.edges.iter().filter_map(|edge| edge.letter).collect::<String>(), "ABCDEFG");
            for edge in layout.edges.iter().filter(|edge| edge.letter.is_none()) {
                // The directions at the two ends of the side, going right or down, agree from both cells.
                let [one, other] = [0, 1].map(|end| ends(layout.cell(edge.faces[end]), edge.sides[end]));
                assert_eq!(one, other, "{edge:?} with {world_up} up");
            }
        }
    }

    /// The corners of the cube at the ends of a side: its left or upper end first.
    fn ends(cell: &CrossCell, side: Side) -> [[f32; 3]; 2] {
        let towards = cell.neighbour(side).normal() + cell.shot.direction.normal();
        let along = match side {
            Side::Top | Side::Bottom => cell.shot.right().direction(),
            Side::Left | Side::Right => -cell.shot.up.direction(),
        };
        [(towards - along).to_array(), (towards + along).to_array()]
    }

    #[test]
    fn cells_do_not_share_a_place() {
        let places = CrossLayout::new(SignedAxis::POS_Z).cells.map(|cell| (cell.column, cell.row));
        assert_eq!(places, [(2, 1), (0, 1), (1, 1), (3, 1), (1, 0), (1, 2)]);
    }
}
