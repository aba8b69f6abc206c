//! skycube: a small, complete ray tracer for teaching, and a validator for skyboxes.
//!
//! Read the modules in this order; none knows those below it.

pub mod error;

pub mod bvh;
pub mod colour;
pub mod envmap;
pub mod math;
pub mod picture;
pub mod shapes;
