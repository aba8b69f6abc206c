//! The textbook BVH (bounding volume hierarchy) of lesson 10, in one file.
//!
//! Each node of the binary tree has a box around everything below it: a ray that misses the box misses the whole
//! subtree. The nodes lie in one list, parents before their children; leaves are ranges of `order`, the list of the
//! shapes' numbers.
//!
//! ```text
//!     +-0----------------------+          0
//!     | +-1----------+  +-4--+ |        /   \            nodes  [ 0  1  2  3  4 ]
//!     | | +2-+  +3-+ |  |c  d| |       1     4
//!     | | |a |  | e| |  | b  | |      / \    bcd         order  [ a | e | b  c  d ]
//!     | | +--+  +--+ |  +----+ |     2   3                       2   3   4
//!     | +------------+         |     a   e
//!     +------------------------+
//! ```
//!
//! Boxes around shapes, with slabs to test them: Kay, Kajiya: "Ray Tracing Complex Scenes", SIGGRAPH 1986. The cost of
//! a tree: Goldsmith, Salmon: "Automatic Creation of Object Hierarchies for Ray Tracing", IEEE CG&A 1987. Further
//! reading: Pharr, Jakob, Humphreys: "Physically Based Rendering", 4th ed., 7.3; Shirley: "Ray Tracing: The Next Week",
//! 3.

use crate::math::{Bounds, DVec3};

/// A binary tree of boxes over shapes, which it knows by their numbers only.
#[derive(Debug, Clone)]
pub struct TextbookHierarchy {
    nodes: Vec<Node>,
    /// Numbers of the shapes, leaf by leaf.
    order: Vec<u32>,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    bounds: Bounds,
    content: Content,
}

#[derive(Debug, Clone, Copy)]
enum Content {
    /// A range of `order`.
    Leaf { start: usize, end: usize },
    /// Two nodes, and the axis along which the right one lies farther.
    Inner { left: usize, right: usize, axis: usize },
}

impl TextbookHierarchy {
    /// Builds the hierarchy over the boxes of shapes; their corners are finite.
    pub fn build(boxes: &[Bounds]) -> Self {
        let mut hierarchy = Self { nodes: Vec::new(), order: (0..boxes.len() as u32).collect() };
        hierarchy.build_node(boxes, 0, boxes.len());
        hierarchy
    }

    /// The box around everything.
    pub fn bounds(&self) -> Bounds {
        self.nodes[0].bounds
    }

    /// Adds the node of a range of `order` with all below it, and returns its number.
    fn build_node(&mut self, boxes: &[Bounds], start: usize, end: usize) -> usize {
        let shapes = &mut self.order[start..end];
        let bounds = shapes.iter().fold(Bounds::EMPTY, |all, &shape| all.union(boxes[shape as usize]));
        let split = cheapest_split(boxes, shapes, area(bounds));
        let node = self.nodes.len();
        self.nodes.push(Node { bounds, content: Content::Leaf { start, end } });
        if let Some((axis, left_count)) = split {
            let left = self.build_node(boxes, start, start + left_count);
            let right = self.build_node(boxes, start + left_count, end);
            self.nodes[node].content = Content::Inner { left, right, axis };
        }
        node
    }

    /// Looks for the nearest hit before `limit` along a ray whose direction need not have unit length. `test` is called
    /// for each shape that the ray may hit and returns the distance of the nearest hit so far.
    pub fn intersect(&self, origin: DVec3, direction: DVec3, limit: f64, mut test: impl FnMut(u32) -> f64) {
        let ray = SlabRay::new(origin, direction, self.bounds());
        self.intersect_node(0, &ray, &mut { limit }, &mut test);
    }

    fn intersect_node(&self, node: usize, ray: &SlabRay, nearest: &mut f64, test: &mut impl FnMut(u32) -> f64) {
        let Node { bounds, content } = self.nodes[node];
        if !ray.meets(bounds, *nearest) {
            return;
        }
        match content {
            Content::Leaf { start, end } => self.order[start..end].iter().for_each(|&shape| *nearest = test(shape)),
            Content::Inner { left, right, axis } => {
                // First the child that the ray comes to first: the other may be beyond the nearest hit by now.
                let (first, second) = if ray.inverse[axis] < 0.0 { (right, left) } else { (left, right) };
                self.intersect_node(first, ray, nearest, test);
                self.intersect_node(second, ray, nearest, test);
            }
        }
    }

    /// True if the ray hits any shape before `limit`; `test` answers for one shape.
    pub fn occluded(&self, origin: DVec3, direction: DVec3, limit: f64, mut test: impl FnMut(u32) -> bool) -> bool {
        self.occluded_node(0, &SlabRay::new(origin, direction, self.bounds()), limit, &mut test)
    }

    fn occluded_node(&self, node: usize, ray: &SlabRay, limit: f64, test: &mut impl FnMut(u32) -> bool) -> bool {
        let Node { bounds, content } = self.nodes[node];
        ray.meets(bounds, limit)
            && match content {
                Content::Leaf { start, end } => self.order[start..end].iter().any(|&shape| test(shape)),
                Content::Inner { left, right, .. } => {
                    self.occluded_node(left, ray, limit, test) || self.occluded_node(right, ray, limit, test)
                }
            }
    }
}

/// Half the surface of a box: proportional to the chance that a random ray meets it.
fn area(bounds: Bounds) -> f64 {
    let size = bounds.extent();
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// The surface area heuristic: sorts shapes along the best axis and returns it with the count of those that go left, or
/// `None` if no split is cheaper than testing all N. The cost of a split, in tests of a shape or a box, is
///
/// ```text
///     C = 1 + (A_left / A) N_left + (A_right / A) N_right
/// ```
///
/// All N - 1 places along each axis are tried. (Halving at the median is simpler, but rays take longer. Comparing some 16
/// places an axis takes less time to build: Wald: "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007.)
fn cheapest_split(boxes: &[Bounds], shapes: &mut [u32], whole: f64) -> Option<(usize, usize)> {
    let count = shapes.len();
    // Costs are compared times A: the boxes of flat shapes may have none.
    let (mut least, mut best) = (whole * count as f64, None);
    for axis in 0..3 {
        sort_along(axis, boxes, shapes);
        // From right to left: the areas of what goes right.
        let (mut right, mut right_areas) = (Bounds::EMPTY, vec![0.0; count]);
        for place in (1..count).rev() {
            right = right.union(boxes[shapes[place] as usize]);
            right_areas[place] = area(right);
        }
        // From left to right: the cost of each place.
        let mut left = Bounds::EMPTY;
        for place in 1..count {
            left = left.union(boxes[shapes[place - 1] as usize]);
            let cost = whole + area(left) * place as f64 + right_areas[place] * (count - place) as f64;
            if cost < least {
                (least, best) = (cost, Some((axis, place)));
            }
        }
    }
    sort_along(best?.0, boxes, shapes);
    best
}

/// Sorts shapes by the middles of their boxes.
fn sort_along(axis: usize, boxes: &[Bounds], shapes: &mut [u32]) {
    let middle = |shape: u32| 0.5 * (boxes[shape as usize].minimum[axis] + boxes[shape as usize].maximum[axis]);
    shapes.sort_by(|&a, &b| middle(a).total_cmp(&middle(b)).then(a.cmp(&b)));
}

/// A ray, made ready for many boxes.
struct SlabRay {
    origin: DVec3,
    /// 1 / d.
    inverse: DVec3,
    /// Boxes are enlarged by this much more than rounding moves a point, so that no ray misses them.
    slack: f64,
}

impl SlabRay {
    fn new(origin: DVec3, direction: DVec3, world: Bounds) -> Self {
        let largest = origin.abs().max(world.minimum.abs()).max(world.maximum.abs()).max_element();
        Self { origin, inverse: 1.0 / direction, slack: largest * 1e-13 }
    }

    /// Whether the ray is inside all three slabs of the box at once, somewhere from 0 to `nearest`.
    fn meets(&self, bounds: Bounds, nearest: f64) -> bool {
        let (mut near, mut far) = (0.0_f64, nearest);
        for axis in 0..3 {
            let t_minimum = (bounds.minimum[axis] - self.slack - self.origin[axis]) * self.inverse[axis];
            let t_maximum = (bounds.maximum[axis] + self.slack - self.origin[axis]) * self.inverse[axis];
            let backwards = self.inverse[axis] < 0.0;
            let (enter, exit) = if backwards { (t_maximum, t_minimum) } else { (t_minimum, t_maximum) };
            // 0 * infinity, a ray in the plane of a side, is NaN: `max` and `min` pass over it.
            near = near.max(enter);
            far = far.min(exit);
        }
        near <= far
    }
}
