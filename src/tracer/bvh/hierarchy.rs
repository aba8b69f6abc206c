//! The hierarchy: built once, traversed by any number of threads.

use super::FloatBox;
use super::binary::BinaryTree;
use super::merge::Merge;
use super::node::Node;
use crate::memory::on_large_pages;

/// The most nodes on a path from the root; deeper trees are replaced by a balanced one.
pub(super) const DEPTH_LIMIT: usize = 32;

/// Binary trees deeper than this are not even merged (and cannot exhaust the recursion).
const BINARY_DEPTH_LIMIT: usize = DEPTH_LIMIT * 8;

/// A tree of boxes whose leaves hold at most [`LEAF_CAPACITY`](super::LEAF_CAPACITY) of those it was built over.
#[derive(Debug, Clone)]
pub struct Hierarchy {
    pub(super) nodes: Vec<Node>,
    pub(super) bounds: FloatBox,
    /// Where the leaves begin in `order`; one more than there are leaves.
    pub(super) leaf_starts: Vec<u32>,
    /// Numbers of the boxes, leaf by leaf.
    pub(super) order: Vec<u32>,
}

impl Hierarchy {
    /// Builds the hierarchy over boxes with finite corners, fewer than 2^31. The same boxes give the same hierarchy.
    pub fn build(boxes: &[FloatBox]) -> Self {
        let clustered = if has_heaps(boxes) { None } else { Self::merged(BinaryTree::clustered(boxes)) };
        clustered.unwrap_or_else(|| {
            Self::merged(BinaryTree::balanced(boxes)).expect("a balanced tree of 2^31 boxes is 30 levels deep")
        })
    }

    /// Leaves, which are numbered from 0 in the order of the tree: close numbers are close in space.
    pub fn leaf_count(&self) -> usize {
        self.leaf_starts.len() - 1
    }

    /// The numbers of the boxes in a leaf.
    pub fn leaf(&self, number: u32) -> &[u32] {
        let number = number as usize;
        &self.order[self.leaf_starts[number] as usize..self.leaf_starts[number + 1] as usize]
    }

    /// The box around everything; empty if it was built over nothing.
    pub fn bounds(&self) -> FloatBox {
        self.bounds
    }

    /// Merges a binary tree to nodes of eight; `None` if the result is deeper than [`DEPTH_LIMIT`].
    pub(super) fn merged(tree: BinaryTree) -> Option<Self> {
        if tree.depth() > BINARY_DEPTH_LIMIT {
            return None;
        }
        let bounds = tree.nodes.first().map_or(FloatBox::EMPTY, |root| root.0);
        let Merge { nodes, leaf_starts, order, deepest, .. } = Merge::of(&tree);
        (deepest <= DEPTH_LIMIT).then(|| Self { nodes, bounds, leaf_starts, order }.on_large_pages())
    }

    /// The same with its nodes, which rays visit at random, on large pages.
    fn on_large_pages(mut self) -> Self {
        let mut nodes = on_large_pages(self.nodes.len());
        nodes.append(&mut self.nodes);
        Self { nodes, ..self }
    }
}

/// True if many boxes are the same, judged by a sample: of neighbours that are all equally near, the clustering joins a single
/// pair in each pass, and would take minutes for what no tree can part.
fn has_heaps(boxes: &[FloatBox]) -> bool {
    const SAMPLE: usize = 4096;
    const HEAP: usize = 16;
    let bits = |sample: &FloatBox| [sample.minimum, sample.maximum].map(|corner| corner.to_array().map(f32::to_bits));
    let mut sample: Vec<_> = boxes.iter().step_by(boxes.len().div_ceil(SAMPLE).max(1)).map(bits).collect();
    sample.sort_unstable();
    sample.chunk_by(|a, b| a == b).any(|heap| heap.len() >= HEAP)
}
