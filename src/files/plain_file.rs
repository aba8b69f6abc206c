//! The bytes of plain files; pipes and devices are refused, since they may never end.

use std::io::ErrorKind;
use std::path::Path;

use crate::error::{Error, Result};

/// The bytes of a plain file. `expected` is what the user should name instead of a folder or a device.
pub fn read_plain_file(path: &Path, expected: &str) -> Result<Vec<u8>> {
    read(path, expected).map_err(|error| error.in_file(path))
}

fn read(path: &Path, expected: &str) -> Result<Vec<u8>> {
    check_plain(path, expected)?;
    std::fs::read(path).map_err(|error| unreadable(&error))
}

/// An error unless the path leads to a plain file.
pub fn check_plain(path: &Path, expected: &str) -> Result<()> {
    let found = std::fs::metadata(path).map_err(|error| unreadable(&error))?;
    match found.file_type() {
        kind if kind.is_file() => Ok(()),
        kind if kind.is_dir() => Err(Error::new("this is a folder").expected(expected)),
        _ => Err(Error::new("this is a pipe or a device, not a plain file").expected(expected)),
    }
}

fn unreadable(error: &std::io::Error) -> Error {
    match error.kind() {
        ErrorKind::NotFound => Error::new("the file does not exist"),
        _ => Error::new(format!("cannot be read: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_plain_file_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = |path: &Path| read_plain_file(path, "a mesh").unwrap_err().problem().to_owned();
        assert_eq!(error(folder.path()), "this is a folder");
        assert_eq!(error(&folder.path().join("missing")), "the file does not exist");
        #[cfg(unix)]
        assert_eq!(error(Path::new("/dev/zero")), "this is a pipe or a device, not a plain file");
        std::fs::write(folder.path().join("there"), b"x").unwrap();
        assert_eq!(read_plain_file(&folder.path().join("there"), "a mesh").unwrap(), b"x");
    }
}
