//! Whitted's and Phong's integrators for many rays at once: the same bits as the textbook's, sooner.
//!
//! ```text
//!     one by one      hit surface light  hit surface light  hit surface light
//!     side by side    hit hit hit  surface surface surface  light light light
//! ```
//!
//! The steps of one ray wait for each other: the point for the distance, the light for the point. Those of several rays do
//! not, and the processor works on several of them at once.

mod queue;
mod stream;
mod whitted;

pub use stream::RayStream;
pub use whitted::StreamTracer;
