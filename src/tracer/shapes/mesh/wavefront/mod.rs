//! Meshes from Wavefront OBJ files with their MTL material files.
//!
//! The format is older than its descriptions, and files vary: a byte-order mark, UTF-16, lines that end in CR alone or
//! continue after a backslash, `1.0.` for a number. Unambiguous input is read, a remark names what is ignored, and
//! everything else is an error that names the line.

mod materials;
mod object;
mod polygon;
mod statements;

pub use materials::{ObjMap, ObjMaterial, ObjMaterials};
pub use object::ObjFile;
