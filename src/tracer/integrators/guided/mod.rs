//! Guided path tracing of light through glass and mirrors: the textbook path tracer with two additions. It follows both
//! branches at glass seen by the camera, and photons guide rays to focused light. The mean is that of the textbook,
//! with less noise: see [`walk`] and lesson 11 for what it saves.

mod caustics;
mod walk;

pub use walk::GuidedTracer;
