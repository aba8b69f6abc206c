//! The scattering functions from outside: sampling against density, energy, reciprocity, limits.

#[path = "../support/chi_square.rs"]
mod chi_square;

mod energy;
mod samples;
mod subjects;
mod symmetry;
