//! The lessons of the course: their contents, and copying one into a student's folder.
//!
//! A lesson is a folder with a `lesson.toml`; no other file lists it.

mod copy;
mod lesson;
mod source;

pub use copy::{Started, start};
pub use lesson::{Bilingual, Language, Lesson};
pub use source::Source;

use std::path::Path;

use crate::error::{Error, Result};

/// The lessons of a folder, by their numbers; without one, those of the course, which are part of the program.
pub fn read_all(folder: Option<&Path>) -> Result<Vec<Lesson>> {
    let sources = folder.map_or_else(|| Ok(Source::in_program()), Source::in_folder)?;
    let mut lessons = sources.into_iter().map(Lesson::read).collect::<Result<Vec<_>>>()?;
    lessons.sort_by_key(|lesson| lesson.number);
    if let Some([first, second]) = lessons.windows(2).find(|pair| pair[0].number == pair[1].number) {
        let other = first.source.path().display();
        return Err(Error::new(format!("lesson {} exists twice; the other one is {other}", second.number))
            .in_file(second.source.path().join(source::FILE)));
    }
    Ok(lessons)
}

/// The lesson of a number. An error names those there are.
pub fn find(lessons: &[Lesson], number: u32) -> Result<&Lesson> {
    let numbers = || lessons.iter().map(|lesson| lesson.number.to_string()).collect::<Vec<_>>().join(", ");
    let found = lessons.iter().find(|lesson| lesson.number == number);
    found.ok_or_else(|| Error::new(format!("there is no lesson {number}")).expected(format!("one of {}", numbers())))
}
