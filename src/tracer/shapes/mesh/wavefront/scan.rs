//! A first look at an OBJ file: which line is wrong, if one is.

use std::path::Path;

use super::materials::Libraries;
use super::statements;
use crate::error::{Error, Result};

/// How many positions, texture coordinates and normals the lines so far have defined.
type Counts = [usize; 3];

const NAMES: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// Checks every line and reads the material libraries; relative to `folder`.
pub(super) fn scan(text: &str, folder: &Path) -> Result<Libraries> {
    let mut libraries = Libraries::default();
    let mut counts = [0; 3];
    for (line, keyword, rest) in statements(text) {
        let checked = match keyword {
            "v" => count(&mut counts[0], rest, 3),
            "vt" => count(&mut counts[1], rest, 2),
            "vn" => count(&mut counts[2], rest, 3),
            "f" => check_face(rest, &counts),
            // Its errors name the library's own lines.
            "mtllib" => {
                libraries.add(folder.join(rest)).map_err(|error| error.help(MATERIAL_HELP))?;
                Ok(())
            }
            "usemtl" => check_material(rest, &libraries),
            _ => Ok(()),
        };
        checked.map_err(|error| error.at_line(line))?;
    }
    Ok(libraries)
}

const MATERIAL_HELP: &str =
    "put the MTL file where the OBJ file's `mtllib` line says, or remove its `mtllib` and `usemtl` lines";

fn count(counter: &mut usize, rest: &str, numbers: usize) -> Result<()> {
    let finite = |word: &str| word.parse::<f32>().is_ok_and(f32::is_finite);
    if rest.split_whitespace().count() < numbers || !rest.split_whitespace().all(finite) {
        return Err(Error::new(format!("found \"{rest}\"")).expected(format!("{numbers} finite numbers")));
    }
    *counter += 1;
    Ok(())
}

fn check_material(name: &str, libraries: &Libraries) -> Result<()> {
    if libraries.has(name) {
        return Ok(());
    }
    let known = match libraries.names() {
        [] => "a `mtllib` line before it that names a file with this material".to_owned(),
        names => format!("one of {}", names.join(", ")),
    };
    Err(Error::new(format!("no material \"{name}\"")).expected(known).help(MATERIAL_HELP))
}

/// Checks a face of `v`, `v/vt`, `v//vn` or `v/vt/vn`, each counted from 1, or from the end if negative.
fn check_face(rest: &str, counts: &Counts) -> Result<()> {
    let corners: Vec<&str> = rest.split_whitespace().collect();
    if corners.len() < 3 {
        return Err(Error::new(format!("a face of {} corners", corners.len())).expected("at least three"));
    }
    let given = |corner: &str| {
        let mut parts = corner.split('/').map(|part| !part.is_empty()).collect::<Vec<_>>();
        parts.resize(3, false);
        parts
    };
    if corners.iter().any(|corner| given(corner) != given(corners[0])) {
        return Err(Error::new(format!("found \"f {rest}\"")).expected("the same parts at all corners of the face"));
    }
    corners.iter().try_for_each(|corner| check_corner(corner, counts))
}

fn check_corner(corner: &str, counts: &Counts) -> Result<()> {
    let malformed = || Error::new(format!("found the corner \"{corner}\"")).expected("v, v/vt, v//vn or v/vt/vn");
    if corner.starts_with('/') || corner.split('/').count() > 3 {
        return Err(malformed());
    }
    for (kind, part) in corner.split('/').enumerate().filter(|(_, part)| !part.is_empty()) {
        let index: i64 = part.parse().map_err(|_| malformed())?;
        let count = counts[kind] as i64;
        if index == 0 || index > count || -index > count {
            return Err(
                Error::new(format!("the corner \"{corner}\" has {} {index}", NAMES[kind])).expected(range(count))
            );
        }
    }
    Ok(())
}

fn range(count: i64) -> String {
    match count {
        0 => "none: no such line comes before it".to_owned(),
        _ => format!("1 to {count}, or -1 to -{count}: so many are defined before this line"),
    }
}
