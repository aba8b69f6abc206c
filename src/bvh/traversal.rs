//! Walking down the hierarchy along a ray, nearest boxes first.

use glam::Vec4;

use super::hierarchy::DEPTH_LIMIT;
use super::node::{Child, Node, WIDTH};
use super::{Hierarchy, HierarchyRay};

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
        let mut stack = [(Child::node(0), 0.0_f32); STACK_SIZE];
        let mut top = 1;
        while top > 0 {
            top -= 1;
            let (child, enter) = stack[top];
            if enter > limit {
                continue;
            }
            match child.leaf_number() {
                None => top = slabs.push_children(&self.nodes[child.node_index()], limit, &mut stack, top),
                Some(leaf) => match visit(leaf) {
                    Visit::Continue => {}
                    Visit::Closer(t) => limit = ray.limit(t),
                    Visit::Stop => return,
                },
            }
        }
    }
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
    #[inline]
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

    /// Puts the children that the ray touches on the stack, the nearest on top; returns the new height.
    #[inline]
    fn push_children(&self, node: &Node, limit: f32, stack: &mut [(Child, f32); STACK_SIZE], top: usize) -> usize {
        let (enter, mut touched) = self.intersect(node, limit);
        let enter = enter.to_array();
        let mut end = top;
        while touched != 0 {
            let slot = touched.trailing_zeros() as usize;
            touched &= touched - 1;
            let mut place = end;
            while place > top && stack[place - 1].1 < enter[slot] {
                stack[place] = stack[place - 1];
                place -= 1;
            }
            stack[place] = (node.children[slot], enter[slot]);
            end += 1;
        }
        end
    }
}
