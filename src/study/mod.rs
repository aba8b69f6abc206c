//! What one picture is against another: metrics, and what a student's picture does differently. Data only.

pub mod comparison;
pub mod metrics;
mod pixel_trace;
mod plane;

pub use pixel_trace::PixelTrace;
pub use plane::Plane;
