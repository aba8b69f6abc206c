//! Environment maps: the faces of a cube, the lookup, where their pictures come from.
//!
#![doc = include_str!("conventions.md")]

mod axis;
mod background;
mod cube_map;
mod engine;
mod environment;
mod face;
mod handedness;
mod lazy_image;
mod lookup;
mod moved_images;
mod orientation;
mod preset;
mod probe;
mod resampling;
mod sampling;
mod seamless;
pub mod source;
mod v_origin;
mod world;

pub use axis::SignedAxis;
pub use background::{Equirectangular, Gradient};
pub use cube_map::{CubeFilter, CubeMap};
pub use engine::Engine;
pub use environment::{Environment, EnvironmentKind};
pub use face::Face;
pub use lazy_image::{Decoder, LazyImage};
pub use lookup::{FaceLookup, FacePoint, ImagePoint, Lookup};
pub use moved_images::{MovedImage, moved_images};
pub use orientation::{ImageOperation, Orientation};
pub use preset::Preset;
pub use probe::{Probe, ProbedTexel, TexelPlace};
pub use resampling::{Sky, equirectangular_image, face_image};
pub use sampling::EnvironmentSampler;
pub use v_origin::VOrigin;
pub use world::{Handedness, World};

#[cfg(test)]
mod tests;
