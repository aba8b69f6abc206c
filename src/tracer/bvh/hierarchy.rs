//! The hierarchy: built once, traversed by any number of threads.

use super::FloatBox;
use super::binary::{BinaryNode, BinaryTree};
use super::node::{Child, Node, WIDTH};
use crate::memory::on_large_pages;

/// The most boxes a leaf holds.
pub const LEAF_CAPACITY: usize = 4;

/// Nodes on the longest way from the root down; deeper trees are replaced by a balanced one.
pub(super) const DEPTH_LIMIT: usize = 32;

/// Binary trees deeper than this are not even merged (and cannot exhaust the recursion).
const BINARY_DEPTH_LIMIT: usize = DEPTH_LIMIT * 8;

/// A tree of boxes whose leaves hold at most [`LEAF_CAPACITY`] of those it was built over.
#[derive(Debug, Clone)]
pub struct Hierarchy {
    pub(super) nodes: Vec<Node>,
    pub(super) bounds: FloatBox,
    /// Where the leaves begin in `order`; one more than there are leaves.
    leaf_starts: Vec<u32>,
    /// Numbers of the boxes, leaf by leaf.
    order: Vec<u32>,
}

impl Hierarchy {
    /// Builds the hierarchy over boxes with finite corners, fewer than 2^31. The same boxes give the same hierarchy.
    pub fn build(boxes: &[FloatBox]) -> Self {
        Self::merged(BinaryTree::clustered(boxes)).unwrap_or_else(|| {
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

    /// Merges a binary tree to nodes of four; `None` if the result is deeper than [`DEPTH_LIMIT`].
    pub(super) fn merged(tree: BinaryTree) -> Option<Self> {
        if tree.depth() > BINARY_DEPTH_LIMIT {
            return None;
        }
        let bounds = tree.nodes.first().map_or(FloatBox::EMPTY, |root| root.0);
        let hierarchy = Self { nodes: vec![Node::EMPTY], bounds, leaf_starts: vec![0], order: Vec::new() };
        let mut merge = Merge { tree: &tree, hierarchy, deepest: 1 };
        match tree.nodes.first() {
            None => {}
            Some((_, BinaryNode::Leaf { .. })) => merge.fill(0, &[0], 1),
            Some((_, BinaryNode::Inner { left, right })) => merge.fill(0, &[*left, *right], 1),
        }
        (merge.deepest <= DEPTH_LIMIT).then(|| merge.hierarchy.on_large_pages())
    }

    /// The same with its nodes, which rays visit at random, on large pages.
    fn on_large_pages(mut self) -> Self {
        let mut nodes = on_large_pages(self.nodes.len());
        nodes.append(&mut self.nodes);
        Self { nodes, ..self }
    }
}

/// The merging of a binary tree.
struct Merge<'a> {
    tree: &'a BinaryTree,
    hierarchy: Hierarchy,
    deepest: usize,
}

impl Merge<'_> {
    /// Fills node `index` with the given binary nodes, or rather with what they open up to.
    fn fill(&mut self, index: usize, members: &[usize], depth: usize) {
        self.deepest = self.deepest.max(depth);
        let members = self.opened(members);
        let kinds = members.iter().map(|&member| self.tree.nodes[member]).collect::<Vec<_>>();
        let first = self.hierarchy.nodes.len();
        let inner = kinds.iter().filter(|(_, kind)| matches!(kind, BinaryNode::Inner { .. })).count();
        self.hierarchy.nodes.resize(first + inner, Node::EMPTY);
        let mut next = first;
        for (slot, (bounds, kind)) in kinds.into_iter().enumerate() {
            let child = match kind {
                BinaryNode::Leaf { first, count } => self.leaf(first, count),
                BinaryNode::Inner { left, right } => {
                    next += 1;
                    self.fill(next - 1, &[left, right], depth + 1);
                    Child::node(next - 1)
                }
            };
            self.hierarchy.nodes[index].set(slot, &bounds, child);
        }
    }

    /// Replaces the largest inner node by its two children until there are four (or leaves only).
    fn opened(&self, members: &[usize]) -> Vec<usize> {
        let mut members = members.to_vec();
        while members.len() < WIDTH {
            let area = |position: usize| self.tree.nodes[members[position]].0.half_area();
            let is_inner = |&position: &usize| matches!(self.tree.nodes[members[position]].1, BinaryNode::Inner { .. });
            let inner = (0..members.len()).filter(is_inner);
            let Some(largest) = inner.max_by(|&a, &b| area(a).total_cmp(&area(b)).then(b.cmp(&a))) else { break };
            if let BinaryNode::Inner { left, right } = self.tree.nodes[members[largest]].1 {
                members.splice(largest..=largest, [left, right]);
            }
        }
        members
    }

    fn leaf(&mut self, first: usize, count: usize) -> Child {
        let number = self.hierarchy.leaf_count();
        self.hierarchy.order.extend_from_slice(&self.tree.order[first..first + count]);
        self.hierarchy.leaf_starts.push(self.hierarchy.order.len() as u32);
        Child::leaf(number)
    }
}
