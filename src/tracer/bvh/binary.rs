//! The binary tree that becomes the hierarchy.

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use super::FloatBox;
use crate::math::Vec3;

/// The most boxes a leaf holds.
pub const LEAF_CAPACITY: usize = 4;

/// Share of the nodes that the optimiser tries to move to a better place.
const REINSERTED: f32 = 0.05;

/// The same once leaves are made. Half of the nodes would make the build of a million triangles 1.6 times as long (1.05
/// instead of 0.64 s), for no more rays per second: measured side by side, within 2 % either way.
const REINSERTED_AFTER: f32 = 0.1;

/// Cost of testing a node, in tests of a leaf's primitive: large, because a leaf is tested as a whole.
const TRAVERSAL_COST: f32 = 3.0;

/// A node of a binary tree.
#[derive(Debug, Clone, Copy)]
pub(super) enum BinaryNode {
    Inner { left: usize, right: usize },
    Leaf { first: usize, count: usize },
}

/// A binary tree; node 0 is the root, leaves are ranges of `order`, which numbers the boxes.
pub(super) struct BinaryTree {
    pub(super) nodes: Vec<(FloatBox, BinaryNode)>,
    pub(super) order: Vec<u32>,
}

impl BinaryTree {
    /// Clusters neighbours bottom-up, then moves subtrees to where they cost least, in one thread, so that the tree
    /// is the same on any machine.
    ///
    /// Meister, Bittner: "Parallel Locally-Ordered Clustering for Bounding Volume Hierarchy Construction", TVCG 2018;
    /// the same: "Parallel Reinsertion for Bounding Volume Hierarchy Optimization", Eurographics 2018.
    pub(super) fn clustered(boxes: &[FloatBox]) -> Self {
        let boxes: Vec<Aabb> = boxes.iter().map(|b| Aabb::new(b.minimum.into(), b.maximum.into())).collect();
        let numbers = (0..boxes.len() as u32).collect();
        let mut builder = PlocBuilder::with_capacity(boxes.len());
        let mut tree = builder.build(PlocSearchDistance::Medium, &boxes, numbers, SortPrecision::U64, 3);
        let mut optimizer = ReinsertionOptimizer::default();
        optimizer.run(&mut tree, REINSERTED, None);
        collapse(&mut tree, LEAF_CAPACITY as u32, TRAVERSAL_COST);
        optimizer.run(&mut tree, REINSERTED_AFTER, None);
        Self::from_obvhs(tree)
    }

    fn from_obvhs(tree: Bvh2) -> Self {
        let nodes = tree.nodes.iter().map(|node| {
            let (first, count) = (node.first_index as usize, node.prim_count as usize);
            let kind = if node.is_leaf() {
                BinaryNode::Leaf { first, count }
            } else {
                BinaryNode::Inner { left: first, right: first + 1 }
            };
            (FloatBox { minimum: Vec3::from(node.aabb().min), maximum: Vec3::from(node.aabb().max) }, kind)
        });
        Self { nodes: nodes.collect(), order: tree.primitive_indices }
    }

    /// Halves the boxes at the median along the longest axis of their centres: a worse tree, but never deep.
    pub(super) fn balanced(boxes: &[FloatBox]) -> Self {
        let mut tree = Self { nodes: Vec::new(), order: (0..boxes.len() as u32).collect() };
        let count = boxes.len();
        if count > 0 {
            tree.split(boxes, 0, count);
        }
        tree
    }

    fn split(&mut self, boxes: &[FloatBox], first: usize, count: usize) -> usize {
        let range = &mut self.order[first..first + count];
        let index = self.nodes.len();
        let bounds = range.iter().fold(FloatBox::EMPTY, |all, &number| all.union(boxes[number as usize]));
        self.nodes.push((bounds, BinaryNode::Leaf { first, count }));
        if count > LEAF_CAPACITY {
            let centre = |number: u32| 0.5 * boxes[number as usize].minimum + 0.5 * boxes[number as usize].maximum;
            let centres = FloatBox::around(range.iter().map(|&number| centre(number)));
            let axis = (centres.maximum - centres.minimum).max_position();
            let key = |&number: &u32| (centre(number)[axis], number);
            range.sort_by(|a, b| key(a).0.total_cmp(&key(b).0).then(a.cmp(b)));
            let left = self.split(boxes, first, count / 2);
            let right = self.split(boxes, first + count / 2, count - count / 2);
            self.nodes[index].1 = BinaryNode::Inner { left, right };
        }
        index
    }

    /// All nodes, each after its parent.
    pub(super) fn parents_first(&self) -> Vec<usize> {
        let mut order = Vec::with_capacity(self.nodes.len());
        let mut open = if self.nodes.is_empty() { vec![] } else { vec![0] };
        while let Some(index) = open.pop() {
            order.push(index);
            if let BinaryNode::Inner { left, right } = self.nodes[index].1 {
                open.extend([right, left]);
            }
        }
        order
    }

    /// Inner nodes on the longest path from the root to a leaf, counted without recursion.
    pub(super) fn depth(&self) -> usize {
        let mut deepest = 0;
        let mut open = if self.nodes.is_empty() { vec![] } else { vec![(0, 0)] };
        while let Some((index, depth)) = open.pop() {
            deepest = deepest.max(depth);
            if let BinaryNode::Inner { left, right } = self.nodes[index].1 {
                open.extend([(left, depth + 1), (right, depth + 1)]);
            }
        }
        deepest
    }
}
