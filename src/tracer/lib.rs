//! The ray tracer: from numbers to rendered pictures.
//!
//! Read the modules in this order; none uses those below it.

pub use skycube_files::{choice, error, memory, take_notes};

pub mod parallel;

pub mod math;

pub mod colour;
pub mod sampling;

pub mod picture;

pub mod envmap;

pub mod bvh;
pub mod shapes;

pub mod camera;
pub mod lights;
pub mod materials;

pub mod scene;

pub mod integrators;

pub mod render;
