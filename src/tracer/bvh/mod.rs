//! A BVH (bounding volume hierarchy): finds the few things a ray may hit among very many.
//!
//! There are two. Read [`TextbookHierarchy`] first: one file, the text of lesson 10. The other, [`Hierarchy`], finds the
//! same and is fast.
//!
//! It is built over boxes and knows no shape. What it finds are leaves, small sets of neighbouring boxes; the caller
//! looks at what is inside them. It never passes over a leaf whose box the ray touches, whatever the rounding.
//!
//! The binary tree comes from the crate `obvhs`; its nodes are then merged to eight children each, whose boxes two
//! sequences of four-wide instructions test. Rays wait for memory more than they compute, so what counts is how many
//! nodes they visit one after the other: the four lines of a node come at the same time.
//!
//! Measured side by side, with the same rays through a million triangles, one thread: how many times as many rays a
//! second as with four children per node, merged by area, whose leaves were not fetched ahead.
//!
//! ```text
//!                                            camera    random, from inside
//!     four children, leaves fetched ahead,     1.02       1.06
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

pub use float_box::FloatBox;
pub use hierarchy::{Hierarchy, LEAF_CAPACITY};
pub use slabs::HierarchyRay;
pub use textbook::TextbookHierarchy;
pub use traversal::Visit;

#[cfg(test)]
mod tests;
