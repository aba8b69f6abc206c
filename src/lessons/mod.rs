//! The lessons of the course: their contents, and copying one into a student's folder.
//!
//! A lesson is a folder with a `lesson.toml`; no other file lists it.

mod copy;
mod lesson;

pub use copy::{Started, start};
pub use lesson::{Bilingual, Language, Lesson};

use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// The folder of the lessons: that of the clone this program was built in, or `lessons` in the current folder.
pub fn default_folder() -> PathBuf {
    let built_in = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    if built_in.is_dir() { built_in } else { PathBuf::from("lessons") }
}

/// All lessons in a folder, by their numbers.
pub fn read_all(folder: &Path) -> Result<Vec<Lesson>> {
    let entries = std::fs::read_dir(folder).map_err(|error| {
        Error::new(format!("cannot read the folder of lessons: {error}"))
            .in_file(folder)
            .help("run in a clone of the repository, or name its folder `lessons` with --folder")
    })?;
    let mut folders: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    folders.retain(|path| path.join(lesson::FILE).is_file());
    folders.sort();
    let mut lessons = folders.into_iter().map(Lesson::read).collect::<Result<Vec<_>>>()?;
    lessons.sort_by_key(|lesson| lesson.number);
    if let Some(pair) = lessons.windows(2).find(|pair| pair[0].number == pair[1].number) {
        return Err(Error::new(format!(
            "lesson {} exists twice; the other one is {}",
            pair[1].number,
            pair[0].folder.display()
        ))
        .in_file(pair[1].folder.join(lesson::FILE)));
    }
    if lessons.is_empty() {
        return Err(Error::new("there are no lessons in this folder")
            .in_file(folder)
            .expected(format!("folders such as 01-camera-rays with a {}", lesson::FILE)));
    }
    Ok(lessons)
}

/// The lesson of a number. An error names those there are.
pub fn find(lessons: &[Lesson], number: u32) -> Result<&Lesson> {
    let numbers = || lessons.iter().map(|lesson| lesson.number.to_string()).collect::<Vec<_>>().join(", ");
    let found = lessons.iter().find(|lesson| lesson.number == number);
    found.ok_or_else(|| Error::new(format!("there is no lesson {number}")).expected(format!("one of {}", numbers())))
}
