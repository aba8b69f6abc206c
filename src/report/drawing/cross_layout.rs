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

use crate::envmap::{Face, SignedAxis, World};
use crate::render::AxisShot;
use crate::validate::Edge;

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

impl CrossCell {
    /// Where an axis points in the cell: to the right and down. Towards a neighbour this is the side they share.
    pub fn on_screen(&self, axis: SignedAxis) -> (f32, f32) {
        let direction = axis.direction();
        (direction.dot(self.shot.right().direction()), -direction.dot(self.shot.up.direction()))
    }

    /// True if the cell of a neighbour lies across the side towards it.
    fn is_beside(&self, neighbour: &Self) -> bool {
        let (right, down) = self.on_screen(neighbour.shot.direction.signed_axis());
        let place = (self.column as f32 + right, self.row as f32 + down);
        place == (neighbour.column as f32, neighbour.row as f32)
    }
}

/// The whole cross.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CrossLayout {
    /// In the order of [`Face::ALL`].
    pub cells: [CrossCell; 6],
}

impl CrossLayout {
    /// The cross of a world, or of a right-handed one of which the vertical axis is given.
    pub fn new(world: impl Into<World>) -> Self {
        let world = world.into();
        let front = world.front();
        let right = AxisShot::new(front.face(), world).right();
        let cells = Face::ALL.map(|face| {
            let axis = face.signed_axis();
            let places = [(-right, 0, 1), (front, 1, 1), (right, 2, 1), (-front, 3, 1), (world.up, 1, 0)];
            let place = places.into_iter().find(|(known, ..)| *known == axis);
            let (_, column, row) = place.unwrap_or((-world.up, 1, 2));
            CrossCell { shot: AxisShot::new(face, world), column, row }
        });
        Self { cells }
    }

    /// The cell of a face.
    pub fn cell(&self, face: Face) -> &CrossCell {
        &self.cells[face.index()]
    }

    /// The two cells at an edge, each with its side towards the other.
    pub fn sides(&self, edge: Edge) -> [(&CrossCell, (f32, f32)); 2] {
        [(edge.first, edge.second), (edge.second, edge.first)].map(|(face, neighbour)| {
            let cell = self.cell(face);
            (cell, cell.on_screen(neighbour.signed_axis()))
        })
    }

    /// True if the two cells lie side by side at the edge.
    pub fn joins(&self, edge: Edge) -> bool {
        let (one, other) = (self.cell(edge.first), self.cell(edge.second));
        one.is_beside(other) && other.is_beside(one)
    }

    /// The edges that are torn apart, each with its letter.
    pub fn torn(&self) -> impl Iterator<Item = (Edge, char)> {
        Edge::ALL.into_iter().filter(|edge| !self.joins(*edge)).zip('A'..)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::Handedness;

    fn joined(layout: &CrossLayout) -> String {
        let joined = Edge::ALL.into_iter().filter(|edge| layout.joins(*edge));
        joined.map(Edge::name).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn the_inner_edges_join_the_faces_of_the_drawing() {
        // z up: left -x, front +y, right +x, back -y.
        assert_eq!(joined(&CrossLayout::new(SignedAxis::POS_Z)), "+x+y +x-y -x+y +y+z +y-z");
        // y up: left -x, front -z, right +x, back +z.
        assert_eq!(joined(&CrossLayout::new(SignedAxis::POS_Y)), "+x+z +x-z -x-z +y-z -y-z");
        // y up in a left-handed world: left -x, front +z, right +x, back -z.
        let world = World { up: SignedAxis::POS_Y, handedness: Handedness::Left };
        assert_eq!(joined(&CrossLayout::new(world)), "+x+z +x-z -x+z +y+z -y+z");
    }

    #[test]
    fn both_ends_of_a_shared_side_are_the_same_points_of_the_cube() {
        for world_up in Face::ALL.map(Face::signed_axis) {
            let layout = CrossLayout::new(world_up);
            assert_eq!(layout.torn().map(|(_, letter)| letter).collect::<String>(), "ABCDEFG");
            for edge in Edge::ALL.into_iter().filter(|edge| layout.joins(*edge)) {
                // The directions at the two ends of the side, going right or down, agree from both cells.
                let one = ends(layout.cell(edge.first), edge.second);
                assert_eq!(one, ends(layout.cell(edge.second), edge.first), "{edge:?} with {world_up} up");
            }
        }
    }

    /// The corners of the cube at the ends of the side towards a neighbour: its left or upper end first.
    fn ends(cell: &CrossCell, neighbour: Face) -> [[f32; 3]; 2] {
        let towards = neighbour.normal() + cell.shot.direction.normal();
        let (across, _) = cell.on_screen(neighbour.signed_axis());
        let along = if across == 0.0 { cell.shot.right() } else { -cell.shot.up }.direction();
        [(towards - along).to_array(), (towards + along).to_array()]
    }

    #[test]
    fn arrows_of_the_course_lie_as_its_table_says() {
        // +x in a z-up world: u along -y is to the right, v along +z upwards.
        let layout = CrossLayout::new(SignedAxis::POS_Z);
        let cell = layout.cell(Face::PosX);
        assert_eq!(cell.on_screen(SignedAxis::NEG_Y), (1.0, 0.0));
        assert_eq!(cell.on_screen(SignedAxis::POS_Z), (0.0, -1.0));
    }

    #[test]
    fn cells_do_not_share_a_place() {
        let places = CrossLayout::new(SignedAxis::POS_Z).cells.map(|cell| (cell.column, cell.row));
        assert_eq!(places, [(2, 1), (0, 1), (1, 1), (3, 1), (1, 0), (1, 2)]);
    }
}
