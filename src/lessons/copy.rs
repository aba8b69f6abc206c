//! Copies a lesson into a student's folder.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use super::Lesson;
use crate::error::{Error, Result};
use crate::picture::{folder_of, make_folder, write_if_absent};

/// Copies the files of a lesson to a folder, which is made if missing, and gives their places. Nothing is overwritten: if
/// another file has one of the names already, an error names it and nothing is copied. What a start that was stopped has
/// copied is kept.
pub fn start(lesson: &Lesson, folder: &Path) -> Result<Vec<Started>> {
    let copies: Vec<Copy> = lesson.files.iter().map(|file| Copy::read(lesson, file, folder)).collect::<Result<_>>()?;
    if let Some(copy) = copies.iter().find(|copy| copy.target.symlink_metadata().is_ok() && !copy.is_made()) {
        return Err(occupied(&copy.target));
    }
    let mut started = Vec::new();
    for copy in copies {
        let was_there = copy.is_made();
        if !was_there {
            copy.make()?;
        }
        started.push(Started { file: copy.target, was_there });
    }
    Ok(started)
}

/// A file of a lesson in the student's folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Started {
    /// Where the copy lies.
    pub file: PathBuf,
    /// True if an earlier start had copied it, and it was left alone.
    pub was_there: bool,
}

/// A file of a lesson and where it goes.
struct Copy {
    content: Cow<'static, [u8]>,
    target: PathBuf,
}

impl Copy {
    fn read(lesson: &Lesson, file: &Path, folder: &Path) -> Result<Self> {
        let content = lesson.source.read(file)?;
        Ok(Self { content, target: folder.join(file) })
    }

    /// True if the target holds this very content.
    fn is_made(&self) -> bool {
        std::fs::read(&self.target).is_ok_and(|found| self.content == found)
    }

    /// Writes the file, whole or not at all.
    fn make(&self) -> Result<()> {
        make_folder(folder_of(&self.target))?;
        if write_if_absent(&self.target, &self.content)? { Ok(()) } else { Err(occupied(&self.target)) }
    }
}

fn occupied(target: &Path) -> Error {
    Error::new("this file exists already: nothing is overwritten")
        .in_file(target)
        .help("choose another folder with -o, or move the file away")
}
