//! Traversal of the hierarchy along a ray, nearest boxes first.

use std::mem::MaybeUninit;

use glam::Vec4;

use super::hierarchy::DEPTH_LIMIT;
use super::node::{Child, LANES, Node, Row, WIDTH};
use super::{Hierarchy, HierarchyRay};
use crate::memory::prefetch;

/// A node leaves at most seven of its children on the stack and is itself taken off it, so a tree of depth `d` never
/// needs more than `7 d + 1` places.
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
    /// far; leaves that begin beyond the last [`Visit::Closer`] are passed over. `announce` receives leaves that are
    /// likely to be visited soon, to prefetch them. Nothing is allocated.
    #[inline]
    pub fn traverse(
        &self,
        ray: &HierarchyRay,
        t_max: f64,
        announce: impl Fn(u32),
        mut visit: impl FnMut(u32) -> Visit,
    ) {
        let slabs = Slabs::new(ray);
        let mut limit = ray.limit(t_max);
        let mut stack = Stack::new();
        let fetch = |child: Child| match child.leaf_number() {
            None => prefetch(&self.nodes[child.node_index()]),
            Some(leaf) => announce(leaf),
        };
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
                next = stack.descend(node, &enter, touched, fetch).or_else(|| stack.pop(limit));
            }
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
    /// Those below `height` were written.
    entries: [MaybeUninit<Entry>; STACK_SIZE],
    height: usize,
}

impl Stack {
    /// Nothing is written to its 2 KB: that alone would take 2 to 6 % of the time of a ray.
    #[inline(always)]
    fn new() -> Self {
        Self { entries: [const { MaybeUninit::uninit() }; STACK_SIZE], height: 0 }
    }

    /// The entry at a place below `height`.
    #[inline(always)]
    fn at(&self, place: usize) -> Entry {
        assert!(place < self.height);
        // SAFETY: the place is below the height, and `insert` has written all of those.
        unsafe { self.entries[place].assume_init() }
    }

    /// The topmost child that the ray enters before the limit.
    #[inline(always)]
    fn pop(&mut self, limit: f32) -> Option<Child> {
        while self.height > 0 {
            let entry = self.at(self.height - 1);
            self.height -= 1;
            // Written so that NaN, which tells nothing, is looked at.
            #[allow(clippy::neg_cmp_op_on_partial_ord)]
            if !(entry.enter() > limit) {
                return Some(entry.child());
            }
        }
        None
    }

    /// The nearest of the touched children; the others go on the stack. Where there are several, `fetch` is called for each.
    #[inline(always)]
    fn descend(&mut self, node: &Node, enter: &Row, touched: u32, fetch: impl Fn(Child)) -> Option<Child> {
        if touched == 0 {
            return None;
        }
        let first = touched.trailing_zeros() as usize % WIDTH;
        let mut rest = touched & (touched - 1);
        if rest == 0 {
            return Some(node.children[first]);
        }
        let entry = |slot: usize| {
            let child = node.children[slot];
            fetch(child);
            Entry::new(enter[slot / LANES].as_ref()[slot % LANES], child)
        };
        let (bottom, mut nearest) = (self.height, entry(first));
        while rest != 0 {
            let next = rest.trailing_zeros() as usize % WIDTH;
            rest &= rest - 1;
            let farther;
            (nearest, farther) = in_order(nearest, entry(next));
            self.insert(farther, bottom);
        }
        Some(nearest.child())
    }

    /// Puts an entry where it belongs among those from `bottom` up. They are few: exchanges without branches are fast.
    #[inline(always)]
    fn insert(&mut self, entry: Entry, bottom: usize) {
        let mut farthest = entry;
        for place in (bottom..self.height).rev() {
            let (near, far) = in_order(self.at(place), farthest);
            self.entries[place + 1].write(near);
            farthest = far;
        }
        self.entries[bottom].write(farthest);
        self.height += 1;
    }
}

#[inline(always)]
fn in_order(a: Entry, b: Entry) -> (Entry, Entry) {
    if a <= b { (a, b) } else { (b, a) }
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

    /// Where the ray enters the boxes, and a bit for each that it touches before `limit`.
    #[inline(always)]
    fn intersect(&self, node: &Node, limit: f32) -> (Row, u32) {
        let (first, touched_first) = self.intersect_part(node, 0, limit);
        let (second, touched_second) = self.intersect_part(node, 1, limit);
        ([first, second], touched_first | touched_second << LANES)
    }

    /// The same for those boxes that one instruction handles.
    #[inline(always)]
    fn intersect_part(&self, node: &Node, part: usize, limit: f32) -> (Vec4, u32) {
        let enter_slab =
            |axis: usize| (node.planes[self.near[axis]][part] - self.origin_near[axis]) * self.inverse[axis];
        let exit_slab = |axis: usize| {
            let far = if self.near[axis] < 3 { axis + 3 } else { axis };
            (node.planes[far][part] - self.origin_far[axis]) * self.inverse_far[axis]
        };
        let enter = enter_slab(0).max(enter_slab(1)).max(enter_slab(2)).max(Vec4::ZERO);
        let exit = exit_slab(0).min(exit_slab(1)).min(exit_slab(2)).min(Vec4::splat(limit));
        (enter, !enter.cmpgt(exit).bitmask() & 0xF)
    }
}
