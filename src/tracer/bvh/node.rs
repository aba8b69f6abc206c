//! A node of eight children.

use glam::Vec4;

use super::FloatBox;

/// Children of a node.
pub(super) const WIDTH: usize = 8;

/// Children that one instruction handles.
pub(super) const LANES: usize = 4;

/// A number for each child.
pub(super) type Row = [Vec4; WIDTH / LANES];

/// What a slot of a node leads to: another node, or a leaf. Fits a register and is kept on the traversal stack.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Child(u32);

impl Child {
    const LEAF: u32 = 1 << 31;

    pub(super) fn node(index: usize) -> Self {
        debug_assert!(index < Self::LEAF as usize);
        Self(index as u32)
    }

    pub(super) fn leaf(number: usize) -> Self {
        debug_assert!(number < Self::LEAF as usize);
        Self(number as u32 | Self::LEAF)
    }

    /// The number of the leaf, if it is one.
    pub(super) fn leaf_number(self) -> Option<u32> {
        (self.0 & Self::LEAF != 0).then_some(self.0 & !Self::LEAF)
    }

    /// The child as a number, and back.
    #[inline(always)]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    #[inline(always)]
    pub(super) fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// The index of the node, unless it is a leaf.
    pub(super) fn node_index(self) -> usize {
        self.0 as usize
    }
}

/// Eight boxes, a plane of four of them in one vector, and what they hold: four cache lines.
#[derive(Debug, Clone)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// `x`, `y`, `z` of the minima, then of the maxima: of all children each.
    pub(super) planes: [Row; 6],
    pub(super) children: [Child; WIDTH],
    padding: [u32; WIDTH],
}

impl Node {
    /// A node without children: empty boxes (minimum above maximum) that no ray enters.
    pub(super) const EMPTY: Self = {
        let (above, below) = ([Vec4::INFINITY; WIDTH / LANES], [Vec4::NEG_INFINITY; WIDTH / LANES]);
        Self { planes: [above, above, above, below, below, below], children: [Child(0); WIDTH], padding: [0; WIDTH] }
    };

    /// Puts a child into a slot.
    pub(super) fn set(&mut self, slot: usize, bounds: &FloatBox, child: Child) {
        for axis in 0..3 {
            self.planes[axis][slot / LANES][slot % LANES] = bounds.minimum[axis];
            self.planes[axis + 3][slot / LANES][slot % LANES] = bounds.maximum[axis];
        }
        self.children[slot] = child;
    }
}
