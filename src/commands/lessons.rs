//! `skycube lessons`: lists the lessons, shows one, starts one.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use super::terminal::{Outcome, print};
use crate::error::Result;
use crate::lessons::{Language, find, read_all, start};
use crate::report::{lesson_list, lesson_page, lesson_started};

#[derive(Debug, Args)]
pub struct LessonsArguments {
    /// Show this lesson: its goal and its commands
    #[arg(value_name = "NN", value_parser = lesson_number)]
    number: Option<u32>,
    #[command(flatten)]
    options: LessonOptions,
    #[command(subcommand)]
    command: Option<LessonCommand>,
}

#[derive(Debug, Args)]
struct LessonOptions {
    /// The language of the lessons [default: that of the system: LC_ALL, LC_MESSAGES, LANG]
    #[arg(long, value_enum, global = true)]
    language: Option<Language>,
    /// A folder of lessons of your own, in place of those of the course
    #[arg(long, value_name = "FOLDER", global = true)]
    folder: Option<PathBuf>,
}

#[derive(Debug, Subcommand)]
enum LessonCommand {
    /// Copy a lesson's text, scenes and expected pictures into a new folder; nothing is overwritten
    Start(StartArguments),
}

#[derive(Debug, Args)]
struct StartArguments {
    /// The lesson
    #[arg(value_name = "NN", value_parser = lesson_number)]
    number: u32,
    /// The folder to copy it to [default: a folder with the lesson's name, in this folder]
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// Lists, shows or starts.
pub fn run(arguments: &LessonsArguments) -> Result<Outcome> {
    let options = &arguments.options;
    let language = options.language.unwrap_or_else(Language::of_system);
    let lessons = read_all(options.folder.as_deref())?;
    let text = match (&arguments.command, arguments.number) {
        (Some(LessonCommand::Start(arguments)), _) => {
            let lesson = find(&lessons, arguments.number)?;
            let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from(lesson.name()));
            let started = start(lesson, &folder)?;
            lesson_started(lesson, &started, &folder, language)
        }
        (None, Some(number)) => lesson_page(find(&lessons, number)?, language),
        (None, None) => lesson_list(&lessons, language),
    };
    print(text);
    Ok(Outcome::Clean)
}

/// `6`, `06` or the name of its folder, `06-environment-map`.
fn lesson_number(text: &str) -> std::result::Result<u32, String> {
    let name = Path::new(text).file_name().and_then(|name| name.to_str()).unwrap_or(text);
    let digits = name.split_once('-').map_or(name, |(digits, _)| digits);
    digits.parse().map_err(|_| "expected the number of a lesson, such as 06; `skycube lessons` lists them".to_owned())
}
