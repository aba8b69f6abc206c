//! What one picture is against another: metrics, what a student's picture does differently, error against run time. Data only.

pub mod comparison;
pub mod converge;
pub mod metrics;
mod plane;

pub use plane::Plane;
