//! Shapes: their intersection with a ray, and the surface there.
//!
//! Every shape is canonical in object space (the unit sphere, the plane z = 0, the cube [-1, 1]^3), and a transform
//! places it in the world. Intersection is computed in `f64`, so that it stays exact to an ulp of `f32` over twelve
//! decades of scale.

mod cuboid;
mod extent;
mod flat;
pub mod mesh;
mod primitive;
mod sampling;
mod sphere;
mod sphere_pack;
mod view_cones;

pub use extent::BoundingSphere;
pub use flat::Outline;
pub use primitive::{Geometry, Hit, MaterialChoice, Primitive, Surface, TexturePoint};
pub use sampling::{ShapeSample, ShapeSampler};
pub use sphere_pack::SpherePack;
pub use view_cones::ViewCones;
