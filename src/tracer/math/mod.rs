//! Vectors, rays, transforms and elementary functions.
//!
//! Geometry is `f64` ([`DVec3`]), light and colour are `f32` ([`Vec3`]).

mod bounds;
mod frame;
pub mod functions;
mod ray;
mod transform;

pub use bounds::Bounds;
pub use frame::Frame;
pub use glam::{DAffine3, DMat3, DVec2, DVec3, Vec2, Vec3};
pub use ray::{Departure, Ray, Side, SurfaceId};
pub use transform::Transform;
