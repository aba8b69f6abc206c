//! A BVH (bounding volume hierarchy): finds the few shapes that a ray may hit among very many.
//!
//! There are two. Read [`TextbookHierarchy`] first: one file, the text of lesson 10. The other, [`Hierarchy`], finds
//! the same hits faster.
//!
//! It is built over boxes and does not know the shapes. It finds leaves, small sets of neighbouring boxes; the caller
//! tests the shapes inside them. It never misses a leaf whose box the ray touches, despite rounding.
//!
//! The binary tree comes from the crate `obvhs`; its nodes are then merged to eight children each, whose boxes two
//! sequences of four-wide instructions test. Traversal waits for memory more than it computes, so the number of nodes
//! that a ray visits in sequence decides: the four cache lines of a node arrive at the same time.
//!
//! Speed-up in rays per second over four children per node, merged by area, without prefetched leaves; measured side by
//! side with the same rays through a million triangles on one thread.
//!
//! ```text
//!                                            camera    random, from inside
//!     four children, leaves prefetched,        1.02       1.06
//!       merged at the least cost
//!     the same, boxes in bytes, 64 bytes       0.80       1.06
//!     eight children, boxes in bytes, 128      0.85       1.28
//!     eight children, boxes in full, 256       1.08       1.33
//!     the same, stack not cleared, sorted      1.15       1.37      this layout
//!       without branches
//!     obvhs CwBvh as it comes                  0.75       1.0 to 1.06
//! ```
//!
//! Rays of both kinds visit 9 to 10 of these nodes (15 with four children) and 2 leaves. Boxes in bytes need more
//! instructions than they save in memory. Nodes and triangles lie on large pages (see [`crate::memory`]).

mod binary;
mod float_box;
mod hierarchy;
mod merge;
mod node;
mod slabs;
mod textbook;
mod traversal;

pub use binary::LEAF_CAPACITY;
pub use float_box::FloatBox;
pub use hierarchy::Hierarchy;
pub use slabs::HierarchyRay;
pub use textbook::TextbookHierarchy;
pub use traversal::Visit;

#[cfg(test)]
mod tests;
