//! The report of `skycube convert`: the files, and what each one is.

use std::fmt;

/// What was written.
#[derive(Debug, Clone)]
pub struct ConvertReport {
    pub files: Vec<ConvertedFile>,
    /// Of all files: the layout, its size, and how the texels came there.
    pub summary: String,
}

/// A file, and what it is made of.
#[derive(Debug, Clone)]
pub struct ConvertedFile {
    pub file: String,
    /// `posz.png, turn 90° clockwise`.
    pub origin: String,
}

impl fmt::Display for ConvertReport {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for ConvertedFile { file, origin } in &self.files {
            writeln!(formatter, "wrote {file}: {origin}")?;
        }
        writeln!(formatter, "{}", self.summary)
    }
}
