//! Studies of pictures and of the program itself: metrics, what a student's picture does differently, error against run
//! time, and how far the kernels stay accurate. Data only.

pub mod comparison;
pub mod converge;
pub mod metrics;
mod pixel_trace;
mod plane;
pub mod stress;

pub use pixel_trace::PixelTrace;
pub use plane::Plane;
