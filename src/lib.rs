//! skycube: a small, complete ray tracer for teaching, and a validator for skyboxes.
//!
//! Read the modules in this order; none knows those below it. They make four packages, each with its own table of
//! contents, so that only code that has to be fast takes the compiler's time to make it fast:
//!
//! - `src/files`: the formats of files, and what is said of files that are not as they should be;
//! - `src/tracer`: from numbers to rendered pictures;
//! - `src/analysis`: what can be found out about skyboxes, pictures and the tracer itself;
//! - `src`: what a user meets.

pub use skycube_tracer::{
    bvh, camera, choice, colour, envmap, error, integrators, lights, materials, math, memory, parallel, picture,
    render, sampling, scene, shapes,
};

#[cfg(feature = "stress")]
pub use skycube_analysis::stress;
pub use skycube_analysis::{PixelTrace, Random, compare, converge, digits, grade, limits, metrics, validate};

pub mod lessons;

pub mod report;

pub mod commands;
