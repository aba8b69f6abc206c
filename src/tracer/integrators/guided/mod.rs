//! Path tracing where light goes through glass and over mirrors: the textbook's walk with two additions. Both branches of a
//! glass that the camera sees are followed, and rays are guided to where photons say that light is focused. The mean is the
//! textbook's, with less noise: see [`walk`] and lesson 11 for what it saves.

mod caustics;
mod walk;

pub use walk::GuidedTracer;
