//! Arrangements of the six images, and the exact search for the cheapest one.

pub mod arrangement;
pub mod branch_and_bound;
pub mod convention;
pub mod evidence;
pub mod symmetry;
