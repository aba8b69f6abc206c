//! Errors about a folder or archive without exactly one file for each face.

use super::passing_over::{all_but, is_passed_over, is_readable_format};
use super::selection::{self, Found, Selection};
use crate::envmap::Face;
use crate::error::Error;

/// How many names an error lists before it counts the rest.
const LISTED: usize = 12;

/// No directory has all six: shows the one that comes nearest.
pub(super) fn no_complete_set(paths: &[String], selections: &[Selection]) -> Error {
    let mut nearest: Option<&Found> = None;
    for selection in selections {
        let Selection::Unclear(found) = selection else { continue };
        if nearest.is_none_or(|nearest| selection::missing(found).len() < selection::missing(nearest).len()) {
            nearest = Some(found);
        }
    }
    match nearest {
        Some(found) if selection::missing(found).len() < 6 => unclear(paths, found),
        _ => no_faces(paths),
    }
}

/// Nothing is named like a face.
pub(super) fn no_faces(paths: &[String]) -> Error {
    let pictures: Vec<&String> =
        paths.iter().filter(|path| !is_passed_over(path) && is_readable_format(path)).collect();
    let problem = if paths.is_empty() { "no files in it" } else { "no file in it has the name of a cube face" };
    let error = Error::new(format!("{problem}{}", passed_over_line(&all_but(paths, &[]))));
    match pictures[..] {
        [one] => error.help(format!("if {one} holds all six faces as a cross or strip, give that file itself")),
        _ => error,
    }
    .expected(NAMES)
}

/// The names that a user may give the files.
const NAMES: &str = "six pictures named posx negx posy negy posz negz, or px nx ..., or +x -x ..., or right left top \
                     bottom front back, or rt lf up dn ft bk, or r l u d f b, or numbered, with any prefix, case and \
                     extension";

/// Faces are missing or have several files.
pub(super) fn unclear(paths: &[String], found: &Found) -> Error {
    let (missing, doubled) = (selection::missing(found), selection::doubled(found));
    let counted = [(missing, "without a file"), (doubled, "with several files")];
    let parts: Vec<String> = counted
        .into_iter()
        .filter(|(faces, _)| !faces.is_empty())
        .map(|(faces, what)| format!("{} {what}", names_of(&faces)))
        .collect();
    let problem = if parts.is_empty() { "one file matches two faces".to_owned() } else { parts.join("; ") };
    let used: Vec<usize> = found.iter().flatten().copied().collect();
    let rest = passed_over_line(&all_but(paths, &used));
    Error::new(format!("{problem}{}{rest}", table(paths, found)))
        .expected("one picture for each of the six faces")
        .help("rename files, or move the superfluous ones away; a scene may also name the six files itself")
}

fn names_of(faces: &[Face]) -> String {
    faces.iter().map(|face| face.name()).collect::<Vec<_>>().join(", ")
}

/// One line for each face with what was found for it.
fn table(paths: &[String], found: &Found) -> String {
    let line = |face: Face| {
        let files: Vec<&str> = found[face.index()].iter().map(|&file| paths[file].as_str()).collect();
        let files = if files.is_empty() { "nothing".to_owned() } else { shortened(&files) };
        format!("\n  {}: {files}", face.name())
    };
    Face::ALL.map(line).concat()
}

/// A line with the files that are not faces; empty if there are none.
fn passed_over_line(names: &[String]) -> String {
    if names.is_empty() { String::new() } else { format!("\n  ignored: {}", shortened(names)) }
}

/// A list that stays readable when a folder holds thousands of files.
fn shortened(names: &[impl AsRef<str>]) -> String {
    let shown: Vec<&str> = names.iter().take(LISTED).map(AsRef::as_ref).collect();
    let more = if names.len() > LISTED { format!(" and {} more", names.len() - LISTED) } else { String::new() };
    format!("{}{more}", shown.join(", "))
}

/// One directory holds several complete sets.
pub(super) fn several_sets(paths: &[String], sets: &[Found]) -> Error {
    let list = |found: &Found| {
        let files: Vec<&str> = found.iter().flatten().map(|&file| paths[file].as_str()).collect();
        format!("\n  {}", shortened(&files))
    };
    let lists: String = sets.iter().map(list).collect();
    Error::new(format!("{} complete sets of six faces{lists}", sets.len())).expected("one set").help(
        "choose a set by the prefix of its files, as in FOLDER/day_; or move the others away; a scene may also \
             name the six files itself",
    )
}

/// Several subfolders hold complete sets.
pub(super) fn several_folders<'a>(folders: impl Iterator<Item = &'a str>) -> Error {
    let folders: Vec<&str> = folders.collect();
    let lines: String = folders.iter().take(LISTED).map(|folder| format!("\n  {folder}")).collect();
    let more = if folders.len() > LISTED { format!("\n  and {} more", folders.len() - LISTED) } else { String::new() };
    Error::new(format!("{} subfolders hold six faces each{lines}{more}", folders.len()))
        .expected("one set of six faces")
        .help(format!("name the subfolder after a slash, as in .../{}", folders[0]))
}
