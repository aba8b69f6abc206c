//! What can be found out about skyboxes, pictures and the tracer itself. Data only: nothing here prints or draws.

use skycube_tracer::{
    colour, envmap, error, integrators, materials, math, parallel, picture, render, sampling, scene, shapes,
};

pub mod study;

pub mod validate;
