//! Walking down the hierarchy along a ray, nearest boxes first.

use glam::Vec4;

use super::hierarchy::DEPTH_LIMIT;
use super::node::{Child, Node, WIDTH};
use super::{Hierarchy, HierarchyRay};
use crate::memory::prefetch;

/// A node leaves at most three of its children on the stack and is itself taken off it, so a tree of depth `d` never
/// needs more than `3 d + 1` places.
const STACK_SIZE: usize = (WIDTH - 1) * DEPTH_LIMIT + 1;

/// What to do after a leaf.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Visit {
    /// Nothing new: go on.
    Continue,
    /// Go on, but only boxes that begin before this ray parameter matter now.
    Closer(f64),
    /// Enough.
    Stop,
}

impl Hierarchy {
    /// Makes a ray ready; `None` if it misses everything. `direction` need not have unit length.
    #[inline]
    pub fn ray(&self, origin: crate::math::DVec3, direction: crate::math::DVec3) -> Option<HierarchyRay> {
        HierarchyRay::new(&self.bounds, origin, direction)
    }

    /// Calls `visit` for every leaf whose box the ray touches at parameters from 0 to `t_max`, roughly from near to
    /// far; leaves that begin beyond the last [`Visit::Closer`] are passed over. Nothing is allocated.
    #[inline]
    pub fn traverse(&self, ray: &HierarchyRay, t_max: f64, mut visit: impl FnMut(u32) -> Visit) {
        let slabs = Slabs::new(ray);
        let mut limit = ray.limit(t_max);
        let mut stack = Stack { entries: [Entry(0); STACK_SIZE], height: 0 };
        let mut next = Some(Child::node(0));
        while let Some(child) = next {
            if let Some(leaf) = child.leaf_number() {
                match visit(leaf) {
                    Visit::Continue => {}
                    Visit::Closer(t) => limit = ray.limit(t),
                    Visit::Stop => return,
                }
                next = stack.pop(limit);
            } else {
                let node = &self.nodes[child.node_index()];
                let (enter, touched) = slabs.intersect(node, limit);
                let waiting = stack.height;
                next = stack.descend(node, enter, touched);
                self.fetch_ahead(&stack.entries[waiting..stack.height]);
                next = next.or_else(|| stack.pop(limit));
            }
        }
    }

    /// Nodes that wait on the stack come from memory meanwhile. Measured with a million triangles and random rays in ten
    /// runs each, side by side: 0.98 to 1.2 times as many rays a second, median 1.05, shadow rays 1.15; camera rays are the
    /// same within the noise.
    #[inline(always)]
    fn fetch_ahead(&self, entries: &[Entry]) {
        for child in entries.iter().map(|entry| entry.child()).filter(|child| child.leaf_number().is_none()) {
            prefetch(&self.nodes[child.node_index()]);
        }
    }
}

/// A child and where the ray enters it, in one number that sorts by distance: the bits of an `f32` that is not
/// negative grow with its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Entry(u64);

impl Entry {
    #[inline(always)]
    fn new(enter: f32, child: Child) -> Self {
        Self(u64::from(enter.to_bits()) << 32 | u64::from(child.bits()))
    }

    #[inline(always)]
    fn enter(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    #[inline(always)]
    fn child(self) -> Child {
        Child::from_bits(self.0 as u32)
    }
}

/// What is still to be looked at, the nearest on top.
struct Stack {
    entries: [Entry; STACK_SIZE],
    height: usize,
}

impl Stack {
    #[inline(always)]
    fn push(&mut self, entry: Entry) {
        self.entries[self.height] = entry;
        self.height += 1;
    }

    /// The topmost child that the ray enters before the limit.
    #[inline(always)]
    fn pop(&mut self, limit: f32) -> Option<Child> {
        while self.height > 0 {
            self.height -= 1;
            let entry = self.entries[self.height];
            // Written so that NaN, which tells nothing, is looked at.
            #[allow(clippy::neg_cmp_op_on_partial_ord)]
            if !(entry.enter() > limit) {
                return Some(entry.child());
            }
        }
        None
    }

    /// The nearest of the touched children; the others go on the stack.
    #[inline(always)]
    fn descend(&mut self, node: &Node, enter: Vec4, touched: u32) -> Option<Child> {
        if touched == 0 {
            return None;
        }
        let first = touched.trailing_zeros() as usize % WIDTH;
        let rest = touched & (touched - 1);
        if rest == 0 {
            return Some(node.children[first]);
        }
        let entry = |slot: usize| Entry::new(enter.as_ref()[slot], node.children[slot]);
        let second = rest.trailing_zeros() as usize % WIDTH;
        if rest & (rest - 1) == 0 {
            let (near, far) = in_order(entry(first), entry(second));
            self.push(far);
            return Some(near.child());
        }
        let absent = Entry(u64::MAX);
        let slots = std::array::from_fn(|slot| if touched >> slot & 1 == 1 { entry(slot) } else { absent });
        let [nearest, second, third, farthest] = sorted(slots);
        if farthest != absent {
            self.push(farthest);
        }
        self.push(third);
        self.push(second);
        Some(nearest.child())
    }
}

#[inline(always)]
fn in_order(a: Entry, b: Entry) -> (Entry, Entry) {
    if a <= b { (a, b) } else { (b, a) }
}

/// A sorting network: five exchanges without branches.
#[inline(always)]
fn sorted([a, b, c, d]: [Entry; 4]) -> [Entry; 4] {
    let ((a, b), (c, d)) = (in_order(a, b), in_order(c, d));
    let ((a, c), (b, d)) = (in_order(a, c), in_order(b, d));
    let (b, c) = in_order(b, c);
    [a, b, c, d]
}

/// The ray, each component four times.
struct Slabs {
    origin_near: [Vec4; 3],
    origin_far: [Vec4; 3],
    inverse: [Vec4; 3],
    inverse_far: [Vec4; 3],
    /// Which of a node's planes is the near one of each axis.
    near: [usize; 3],
}

impl Slabs {
    #[inline]
    fn new(ray: &HierarchyRay) -> Self {
        Self {
            origin_near: ray.origin_near.map(Vec4::splat),
            origin_far: ray.origin_far.map(Vec4::splat),
            inverse: ray.inverse.map(Vec4::splat),
            inverse_far: ray.inverse_far.map(Vec4::splat),
            near: std::array::from_fn(|axis| if ray.negative[axis] { axis + 3 } else { axis }),
        }
    }

    /// Where the ray enters the four boxes, and a bit for each that it touches before `limit`.
    #[inline(always)]
    fn intersect(&self, node: &Node, limit: f32) -> (Vec4, u32) {
        let enter_slab = |axis: usize| (node.planes[self.near[axis]] - self.origin_near[axis]) * self.inverse[axis];
        let exit_slab = |axis: usize| {
            let far = if self.near[axis] < 3 { axis + 3 } else { axis };
            (node.planes[far] - self.origin_far[axis]) * self.inverse_far[axis]
        };
        let enter = enter_slab(0).max(enter_slab(1)).max(enter_slab(2)).max(Vec4::ZERO);
        let exit = exit_slab(0).min(exit_slab(1)).min(exit_slab(2)).min(Vec4::splat(limit));
        (enter, !enter.cmpgt(exit).bitmask() & 0xF)
    }
}
