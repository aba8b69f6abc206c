//! A lesson into a student's folder.

use std::path::{Path, PathBuf};

use super::Lesson;
use crate::error::{Error, Result};
use crate::picture::write_if_absent;

/// Copies the files of a lesson to a folder, which is made if missing, and gives their new places. Nothing is overwritten: if
/// one file is there already, an error names it and nothing is copied.
pub fn start(lesson: &Lesson, folder: &Path) -> Result<Vec<PathBuf>> {
    let pairs: Vec<(PathBuf, PathBuf)> =
        lesson.files.iter().map(|file| (lesson.folder.join(file), folder.join(file))).collect();
    for (source, target) in &pairs {
        if target.symlink_metadata().is_ok() {
            return Err(occupied(target));
        }
        if !source.is_file() {
            return Err(Error::new("the lesson names this file, and it is not there").in_file(source));
        }
    }
    pairs.iter().try_for_each(|(source, target)| copy(source, target))?;
    Ok(pairs.into_iter().map(|(_, target)| target).collect())
}

/// Copies one file, whole or not at all.
fn copy(source: &Path, target: &Path) -> Result<()> {
    let folder = target.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)
        .map_err(|error| Error::new(format!("cannot make the folder: {error}")).in_file(folder))?;
    let content =
        std::fs::read(source).map_err(|error| Error::new(format!("cannot read the file: {error}")).in_file(source))?;
    if write_if_absent(target, &content)? { Ok(()) } else { Err(occupied(target)) }
}

fn occupied(target: &Path) -> Error {
    Error::new("this file is there already: nothing is overwritten")
        .in_file(target)
        .help("choose another folder with -o, or move the file away")
}
