//! Analyses of skyboxes, pictures and the tracer itself. Data only: nothing here prints or draws.

use skycube_tracer::{
    choice, colour, envmap, error, integrators, materials, math, parallel, picture, render, sampling, scene, shapes,
};

pub mod compare;
pub mod converge;
pub mod digits;
pub mod grade;
pub mod limits;
pub mod metrics;
mod pixel_trace;
mod random;
#[cfg(feature = "stress")]
pub mod stress;
pub mod validate;
#[cfg(feature = "stress")]
pub mod validator_limits;

pub use pixel_trace::PixelTrace;
pub use random::Random;
