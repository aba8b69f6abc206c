//! Wide nodes from a binary tree.

use super::binary::{BinaryNode, BinaryTree};
use super::node::{Child, Node, WIDTH};

/// Of one subtree the least cost of all wide nodes in it, if its parent has room for 1, 2, ... of its parts.
type Costs = [f32; WIDTH];

/// The merging of a binary tree into the nodes and leaves of a hierarchy.
///
/// A wide node holds some binary nodes below another, chosen so that a random ray visits the fewest nodes:
///
/// ```text
///          a                      With room for 4 below `a`: b, f, g, e,
///        /   \                    or b, c (a wide node of its own), ...
///       b     c                   The cost of a choice is the sum of the areas
///      / \   / \                  of all wide nodes that it makes.
///     .   . d   e
///          / \
///         f   g
/// ```
///
/// Ylitie, Karras, Laine: "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, section
/// 4.1; here the leaves are given.
pub(super) struct Merge<'a> {
    tree: &'a BinaryTree,
    costs: Vec<Costs>,
    /// Node 0 is the root.
    pub(super) nodes: Vec<Node>,
    /// Where the leaves begin in `order`, and where the last one ends.
    pub(super) leaf_starts: Vec<u32>,
    /// Numbers of the boxes, leaf by leaf.
    pub(super) order: Vec<u32>,
    /// The number of nodes on the longest path from the root.
    pub(super) deepest: usize,
}

impl<'a> Merge<'a> {
    /// Merges a tree. That of nothing becomes one empty node.
    pub(super) fn of(tree: &'a BinaryTree) -> Self {
        let nodes = vec![Node::EMPTY];
        let mut merge = Self { tree, costs: costs(tree), nodes, leaf_starts: vec![0], order: Vec::new(), deepest: 1 };
        if !tree.nodes.is_empty() {
            merge.fill(0, 0, 1);
        }
        merge
    }

    /// Fills node `index` with what the binary node opens up to.
    fn fill(&mut self, index: usize, binary: usize, depth: usize) {
        self.deepest = self.deepest.max(depth);
        let mut members = Vec::with_capacity(WIDTH);
        match self.tree.nodes[binary].1 {
            BinaryNode::Leaf { .. } => members.push(binary),
            BinaryNode::Inner { left, right } => self.share(left, right, WIDTH, &mut members),
        }
        let kinds = members.iter().map(|&member| self.tree.nodes[member]);
        let mut next = self.nodes.len();
        let inner = kinds.clone().filter(|(_, kind)| matches!(kind, BinaryNode::Inner { .. })).count();
        self.nodes.resize(next + inner, Node::EMPTY);
        for (slot, (&member, (bounds, kind))) in members.iter().zip(kinds).enumerate() {
            let child = match kind {
                BinaryNode::Leaf { first, count } => self.leaf(first, count),
                BinaryNode::Inner { .. } => {
                    next += 1;
                    self.fill(next - 1, member, depth + 1);
                    Child::node(next - 1)
                }
            };
            self.nodes[index].set(slot, &bounds, child);
        }
    }

    /// Shares `room` places between two siblings.
    fn share(&self, left: usize, right: usize, room: usize, members: &mut Vec<usize>) {
        let cost = |places: usize| shared_cost(&self.costs[left], &self.costs[right], places, room);
        let places = (1..room).min_by(|&a, &b| cost(a).total_cmp(&cost(b))).expect("there is room for both");
        self.open(left, places, members);
        self.open(right, room - places, members);
    }

    /// Puts a binary node, or what it opens up to, into `room` places.
    fn open(&self, binary: usize, room: usize, members: &mut Vec<usize>) {
        let costs = &self.costs[binary];
        match self.tree.nodes[binary].1 {
            BinaryNode::Inner { left, right } if costs[room - 1] < costs[0] => self.share(left, right, room, members),
            _ => members.push(binary),
        }
    }

    fn leaf(&mut self, first: usize, count: usize) -> Child {
        let number = self.leaf_starts.len() - 1;
        self.order.extend_from_slice(&self.tree.order[first..first + count]);
        self.leaf_starts.push(self.order.len() as u32);
        Child::leaf(number)
    }
}

/// The cost if `places` of `room` go to the left of two siblings.
fn shared_cost(left: &Costs, right: &Costs, places: usize, room: usize) -> f32 {
    left[places - 1] + right[room - places - 1]
}

/// The costs of all binary nodes, from the leaves up. Leaves cost nothing, because they are the same in all choices. A
/// node costs the chance that a ray visits it; where that is the same, fewer nodes are better.
fn costs(tree: &BinaryTree) -> Vec<Costs> {
    let mut costs = vec![[0.0; WIDTH]; tree.nodes.len()];
    let whole = tree.nodes.first().map_or(1.0, |root| root.0.half_area().max(f64::MIN_POSITIVE));
    let one_more = 1e-3 / tree.nodes.len() as f64;
    for index in tree.parents_first().into_iter().rev() {
        let (bounds, BinaryNode::Inner { left, right }) = tree.nodes[index] else { continue };
        let mut least = [f32::INFINITY; WIDTH];
        for room in 2..=WIDTH {
            let shared = (1..room).map(|places| shared_cost(&costs[left], &costs[right], places, room));
            least[room - 1] = shared.fold(f32::INFINITY, f32::min);
        }
        least[0] = least[WIDTH - 1] + (bounds.half_area() / whole + one_more) as f32;
        for room in 1..WIDTH {
            least[room] = least[room].min(least[room - 1]);
        }
        costs[index] = least;
    }
    costs
}
