//! Text files by students: reads them, or says what the file is instead.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use crate::atomic_file::folder_of;
use crate::error::{Error, Result};
use crate::plain_file::check_plain;
use crate::standard_stream::{is_standard_stream, standard_input};

const EXPECTED: &str = "a TOML file";

/// The text of a TOML file, or of standard input for `-`.
pub fn read_text(file: &Path) -> Result<String> {
    if is_standard_stream(file) {
        let text = standard_input().and_then(|bytes| str::from_utf8(bytes).map_err(|_| not_text()));
        return text.map(str::to_owned).map_err(|error| error.in_file(file));
    }
    if file.exists() {
        check_plain(file, EXPECTED).map_err(|error| error.in_file(file))?;
    }
    std::fs::read_to_string(file).map_err(|error| unreadable(file, &error))
}

/// Why a file cannot be read, and which was probably meant.
fn unreadable(file: &Path, error: &std::io::Error) -> Error {
    let error = match error.kind() {
        ErrorKind::NotFound => {
            let missing = Error::new("the file does not exist");
            match similar_file(file) {
                Some(similar) => missing.help(format!("did you mean {}?", similar.display())),
                None => missing,
            }
        }
        ErrorKind::InvalidData => not_text(),
        _ => Error::new(format!("cannot read the file: {error}")),
    };
    error.in_file(file)
}

fn not_text() -> Error {
    Error::new("this is not a text file; it may be a picture").expected(EXPECTED)
}

/// The TOML file beside a missing one whose name without extension differs by at most two letters, the nearest.
fn similar_file(missing: &Path) -> Option<PathBuf> {
    let stem = missing.file_stem()?.to_str()?;
    let near = |path: PathBuf| {
        let is_toml = path.extension().is_some_and(|extension| extension == "toml");
        let distance = strsim::damerau_levenshtein(path.file_stem()?.to_str()?, stem);
        (is_toml && distance <= stem.len().div_ceil(3).min(2)).then_some((distance, path))
    };
    let entries = std::fs::read_dir(folder_of(missing)).ok()?.flatten();
    let (_, similar) = entries.filter_map(|entry| near(entry.path())).min()?;
    Some(missing.with_file_name(similar.file_name()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there_instead_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        for name in ["directions.toml", "spheres.toml", "direction.png"] {
            std::fs::write(at(name), b"\xff\xd8\xff").unwrap();
        }
        let error = |name: &str| read_text(&at(name)).unwrap_err().to_string();
        assert!(error("directions").ends_with("directions.toml?"), "{}", error("directions"));
        assert!(error("sphere.toml").ends_with("spheres.toml?"), "{}", error("sphere.toml"));
        assert!(error("cubes.toml").ends_with("the file does not exist"), "{}", error("cubes.toml"));
        assert!(error("direction.png").contains("may be a picture"), "{}", error("direction.png"));
        assert!(error("").contains("this is a folder"), "{}", error(""));
    }
}
