//! The limits of accuracy: what `skycube stress` measures, with fewer rays, and the same properties on random inputs.

#[path = "../common/mod.rs"]
mod common;
#[path = "../support/icosphere.rs"]
mod icosphere;

mod command;
mod figures;
mod properties;
