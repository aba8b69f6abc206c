//! What a command examined, and what it found there.

use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::validate::Level;

/// A map, a pair of pictures or a set of shots, and what was found.
#[derive(Debug, Clone)]
pub(crate) struct Examined {
    /// As the user calls it.
    pub name: String,
    /// The verdict in a word; `failed` if it could not be examined.
    pub verdict: &'static str,
    pub findings: Vec<ReportedFinding>,
}

/// A finding with the file it is about.
#[derive(Debug, Clone)]
pub(crate) struct ReportedFinding {
    /// Its name, which never changes.
    pub kind: &'static str,
    /// What it says in general, where that is known.
    pub meaning: Option<&'static str>,
    pub level: Level,
    pub sentence: String,
    pub file: PathBuf,
    /// True if the user's configuration allows it.
    pub allowed: bool,
}

impl Examined {
    /// Something that could not be examined.
    pub fn failed(name: String, error: &Error) -> Self {
        let file = error.file().map_or_else(|| PathBuf::from(&name), Path::to_path_buf);
        let finding = ReportedFinding {
            kind: if error.is_damage() { "damaged" } else { "failed" },
            meaning: Some("it could not be examined"),
            level: Level::Error,
            sentence: error.to_string(),
            file,
            allowed: false,
        };
        Self { name, verdict: "failed", findings: vec![finding] }
    }

    /// The verdict and a sentence, which may begin with it.
    pub fn said(&self, sentence: &str) -> String {
        if sentence.starts_with(self.verdict) { sentence.to_owned() } else { format!("{}: {sentence}", self.verdict) }
    }

    /// Errors and warnings that are not allowed.
    pub fn faults(&self) -> impl Iterator<Item = &ReportedFinding> {
        self.findings.iter().filter(|finding| !finding.allowed && finding.level != Level::Note)
    }
}

impl ReportedFinding {
    /// An error about a file.
    pub fn error(kind: &'static str, sentence: String, file: &Path) -> Self {
        Self { kind, meaning: None, level: Level::Error, sentence, file: file.to_path_buf(), allowed: false }
    }

    /// The file with forward slashes, as URIs and annotations have it.
    pub fn path(&self) -> String {
        let path = self.file.to_string_lossy();
        let path = if std::path::MAIN_SEPARATOR == '\\' { path.replace('\\', "/") } else { path.into_owned() };
        path.strip_prefix("./").map_or(path.clone(), str::to_owned)
    }
}
