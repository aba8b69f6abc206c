//! Meshes from Wavefront OBJ files with their MTL material files.
//!
//! The format is older than its descriptions, and everybody writes it: with a byte-order mark, in UTF-16, with lines that
//! end in CR alone or go on behind a backslash, with `1.0.` for a number. What can be read in one way only is read; what
//! is left out is said in a remark; all else is an error that names the line.

mod materials;
mod object;
mod polygon;
mod statements;

pub use materials::{ObjMap, ObjMaterial, ObjMaterials};
pub use object::ObjFile;
