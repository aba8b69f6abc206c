//! One lesson, read from its `lesson.toml`.

use std::collections::BTreeMap;
use std::num::NonZeroU32;
use std::path::{Component, Path, PathBuf};

use serde::Deserialize;

use super::source::{FILE, Source};
use crate::error::{Error, Result};

/// The language that lessons are shown in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum Language {
    /// English
    #[default]
    En,
    /// Czech
    Cs,
}

/// A text in both languages.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bilingual {
    /// English.
    pub en: String,
    /// Czech.
    pub cs: String,
}

/// A lesson.
#[derive(Debug, Clone, PartialEq)]
pub struct Lesson {
    /// The folder with its texts and scenes.
    pub source: Source,
    /// From 1, in the order of the course.
    pub number: u32,
    /// A few words.
    pub title: Bilingual,
    /// One sentence.
    pub goal: Bilingual,
    /// What one must have before.
    pub needs: Bilingual,
    /// What a student gets, relative to the folder.
    pub files: Vec<PathBuf>,
    /// Command lines, each beginning with `skycube `.
    pub commands: Vec<String>,
    /// Samples per pixel of `expected-NAME.png`, for the scene `NAME.toml`: enough to leave hardly any noise. The expected
    /// picture of a scene that is not here was rendered with the scene's own samples.
    pub expected_samples: BTreeMap<String, NonZeroU32>,
}

/// The keys of the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    number: u32,
    title: Bilingual,
    goal: Bilingual,
    needs: Bilingual,
    files: Vec<PathBuf>,
    commands: Vec<String>,
    #[serde(default)]
    expected_samples: BTreeMap<String, NonZeroU32>,
}

impl Language {
    /// The one of two texts that is in this language.
    pub fn choose<T>(self, english: T, czech: T) -> T {
        match self {
            Language::En => english,
            Language::Cs => czech,
        }
    }
}

impl Bilingual {
    /// The text in a language.
    pub fn in_language(&self, language: Language) -> &str {
        language.choose(&self.en, &self.cs)
    }
}

impl Lesson {
    /// Reads the `lesson.toml` of a lesson.
    pub fn read(source: Source) -> Result<Self> {
        let file = source.path().join(FILE);
        let content = source.read(Path::new(FILE))?;
        let text = str::from_utf8(&content).map_err(|error| Error::new(error.to_string()).in_file(&file))?;
        let keys: Keys = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| text[..span.start].matches('\n').count() + 1);
            Error::new(error.message().replace('\n', "; ")).in_file(&file).at_line(line)
        })?;
        keys.check().map_err(|error| error.in_file(&file))?;
        let Keys { number, title, goal, needs, files, commands, expected_samples } = keys;
        Ok(Self { source, number, title, goal, needs, files, commands, expected_samples })
    }

    /// The name of its folder: `01-camera-rays`.
    pub fn name(&self) -> String {
        self.source.path().file_name().map_or_else(|| format!("{:02}", self.number), |name| name.display().to_string())
    }
}

impl Language {
    /// The language of the system's messages, by the variables of POSIX: Czech where it says `cs`, else English.
    pub fn of_system() -> Self {
        let mut variables = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().filter_map(|name| std::env::var(name).ok());
        match variables.find(|value| !value.is_empty()) {
            Some(locale) if locale.split(['_', '.', '@']).next() == Some("cs") => Language::Cs,
            _ => Language::En,
        }
    }

    /// The name of the README in this language.
    pub fn readme(self) -> &'static str {
        self.choose("README.md", "README.cs.md")
    }
}

impl Keys {
    /// An error if a value is not what the program relies on.
    fn check(&self) -> Result<()> {
        if let Some(outside) = self.files.iter().find(|path| !stays_inside(path)) {
            return Err(Error::new(format!("{} lies outside the lesson", outside.display()))
                .at_key("files")
                .expected("paths relative to the lesson's folder"));
        }
        if let Some(command) = self.commands.iter().find(|command| !command.starts_with("skycube ")) {
            return Err(Error::new(format!("found \"{command}\""))
                .at_key("commands")
                .expected("command lines that begin with \"skycube \""));
        }
        let listed = |scene: &str| self.files.iter().any(|file| *file == Path::new(&format!("{scene}.toml")));
        if let Some(scene) = self.expected_samples.keys().find(|scene| !listed(scene)) {
            return Err(Error::new(format!("there is no scene {scene}.toml among the files"))
                .at_key("expected_samples")
                .expected("names of the lesson's scenes, without .toml"));
        }
        Ok(())
    }
}

fn stays_inside(path: &Path) -> bool {
    path.components().all(|component| matches!(component, Component::Normal(_))) && !path.as_os_str().is_empty()
}
