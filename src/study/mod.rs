//! What one picture is against another: metrics, and what a student's picture does differently, and how far
//! the program's own kernels stay accurate. Data only.

pub mod comparison;
pub mod metrics;
mod plane;
pub mod stress;

pub use plane::Plane;
