//! Meshes from Wavefront OBJ files with their MTL material files, read by the crate `tobj`.
//!
//! `tobj` names no line, passes over unknown materials and trusts some of its input; so [`scan`] and [`materials`]
//! look at every line first and refuse what it would stumble over.

mod materials;
mod object;
mod scan;

pub use materials::ObjMaterial;
pub use object::ObjFile;

use std::path::Path;

use crate::error::{Error, Result};

/// The text of a file; bytes that are not UTF-8 (old files have them in comments) become replacement characters.
fn read_text(path: &Path) -> Result<String> {
    match std::fs::read(path) {
        Ok(bytes) => Ok(String::from_utf8_lossy(&bytes).into_owned()),
        Err(error) => Err(Error::new(format!("cannot be read: {error}")).in_file(path)),
    }
}

/// The lines that say something: number from 1, first word, the rest.
fn statements(text: &str) -> impl Iterator<Item = (usize, &str, &str)> {
    text.lines().enumerate().filter_map(|(index, line)| {
        let line = line.trim();
        let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        (!keyword.is_empty() && !keyword.starts_with('#')).then_some((index + 1, keyword, rest.trim()))
    })
}
