//! Output folders for pictures of faces, and the files already in them.

use std::path::{Path, PathBuf};

use crate::envmap::Face;
use crate::error::{Error, Result};
use crate::picture::folder_of;

/// An error if the folder of the targets holds one of their faces in another format, which would make the result
/// ambiguous.
pub fn refuse_rivals(targets: &[PathBuf]) -> Result<()> {
    let Some(folder) = targets.first().map(|target| folder_of(target)) else { return Ok(()) };
    for path in files_in(folder) {
        let is_target = |target: &PathBuf| target.file_name() == path.file_name();
        if targets.iter().any(is_target) {
            continue;
        }
        if let Some(target) = targets.iter().find(|target| is_same_face(&path, target)) {
            return Err(Error::new(format!("{} would be beside it: two files for one face", target.display()))
                .in_file(path)
                .help("choose an empty folder with -o"));
        }
    }
    Ok(())
}

/// An error if shots would replace pictures that may be a student's own: they are named alike, and the contact sheet that
/// earlier shots leave is missing.
pub fn refuse_pictures_of_others(targets: &[PathBuf], contact_sheet: &Path) -> Result<()> {
    match targets.iter().find(|target| target.exists()) {
        Some(picture) if !contact_sheet.exists() => {
            Err(Error::new("this picture exists already, without a contact sheet of earlier shots beside it")
                .in_file(picture)
                .help("it may be your own picture: name another folder with -o"))
        }
        _ => Ok(()),
    }
}

/// True if both are the same face by name, in upper or lower case.
fn is_same_face(path: &Path, target: &Path) -> bool {
    let [stem, other] = [path, target].map(|path| path.file_stem().unwrap_or_default());
    stem.eq_ignore_ascii_case(other) && Face::ALL.iter().any(|face| stem.eq_ignore_ascii_case(face.name()))
}

/// The files of a folder, sorted; none if the folder does not exist.
fn files_in(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    files.sort();
    files
}
