//! The place that the files of a lesson are read from.

use std::borrow::Cow;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use include_dir::{Dir, include_dir};

use crate::error::{Error, Result};

/// The lessons of the course, part of the program: they need no clone of the repository.
static LESSONS: Dir = include_dir!("$CARGO_MANIFEST_DIR/lessons");

/// The file that makes a folder a lesson.
pub(super) const FILE: &str = "lesson.toml";

/// The folder of one lesson.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// In this program.
    Program(&'static Dir<'static>),
    /// On disk.
    Folder(PathBuf),
}

impl Source {
    /// The lessons in this program.
    pub(super) fn in_program() -> Vec<Self> {
        let lessons = LESSONS.dirs().filter(|lesson| lesson.contains(lesson.path().join(FILE)));
        lessons.map(Self::Program).collect()
    }

    /// The lessons in a folder. An error if there are none.
    pub(super) fn in_folder(folder: &Path) -> Result<Vec<Self>> {
        let entries = std::fs::read_dir(folder).map_err(|error| {
            Error::new(format!("cannot read the folder of lessons: {error}"))
                .in_file(folder)
                .help("without --folder, `skycube lessons` shows the lessons of the course")
        })?;
        let mut lessons: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        lessons.retain(|path| path.join(FILE).is_file());
        lessons.sort();
        if lessons.is_empty() {
            return Err(Error::new("there are no lessons in this folder")
                .in_file(folder)
                .expected(format!("folders such as 01-camera-rays with a {FILE}")));
        }
        Ok(lessons.into_iter().map(Self::Folder).collect())
    }

    /// The folder: a path on disk, or the name of the lesson in the program.
    pub fn path(&self) -> &Path {
        match self {
            Self::Program(lesson) => lesson.path(),
            Self::Folder(folder) => folder,
        }
    }

    /// The content of a file of the lesson.
    pub fn read(&self, file: &Path) -> Result<Cow<'static, [u8]>> {
        let path = self.path().join(file);
        let content = match self {
            Self::Program(lesson) => lesson
                .get_file(&path)
                .map(|file| Cow::Borrowed(file.contents()))
                .ok_or_else(|| ErrorKind::NotFound.into()),
            Self::Folder(_) => std::fs::read(&path).map(Cow::Owned),
        };
        content.map_err(|error| match error.kind() {
            ErrorKind::NotFound => Error::new("the lesson names this file, but it does not exist").in_file(&path),
            _ => Error::new(format!("cannot read the file: {error}")).in_file(&path),
        })
    }
}
