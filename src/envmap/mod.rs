//! Environment maps: the faces of a cube, the lookup, where their pictures come from.

mod face;
pub mod source;

pub use face::Face;
