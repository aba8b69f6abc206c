//! What one picture is against another: metrics, and what a student's picture does differently. Data only.

pub mod comparison;
pub mod metrics;
mod plane;

pub use plane::Plane;
