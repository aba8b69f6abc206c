//! Triangle meshes and their hierarchy from outside: against brute force, for leaks, and for rays that leave them.

#[path = "../support/icosphere.rs"]
mod icosphere;

mod departures;
mod input;
mod leaks;
mod soups;
mod wavefront;
