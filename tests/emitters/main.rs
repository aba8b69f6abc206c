//! Drawing directions to lights: the environment and shapes, against their densities and closed forms.

#[path = "../support/icosphere.rs"]
mod icosphere;

mod environment;
mod histogram;
mod maps;
mod shape_hits;
mod solid_angles;
mod suns;
mod support;
