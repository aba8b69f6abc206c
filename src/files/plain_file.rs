//! The bytes of plain files; pipes and devices are refused, since they may never end.

use std::fs::File;
use std::io::{BufReader, Cursor, ErrorKind, Read, Seek};
use std::path::Path;

use crate::error::{Error, Result};
use crate::standard_stream::{is_standard_stream, standard_input};

/// A file that is open for reading, or standard input.
pub trait PlainFile: Read + Seek {}

impl<T: Read + Seek> PlainFile for T {}

/// Opens a file, or standard input for `-`.
pub fn open_file(path: &Path) -> Result<Box<dyn PlainFile>> {
    if is_standard_stream(path) {
        return Ok(Box::new(Cursor::new(standard_input()?)));
    }
    let file = File::open(path).map_err(|error| Error::new(format!("cannot be read: {error}")).in_file(path))?;
    Ok(Box::new(BufReader::new(file)))
}

/// The bytes of a plain file, or of standard input for `-`. `expected` is what the user should name instead of a folder or a device.
pub fn read_plain_file(path: &Path, expected: &str) -> Result<Vec<u8>> {
    read(path, expected).map_err(|error| error.in_file(path))
}

fn read(path: &Path, expected: &str) -> Result<Vec<u8>> {
    if is_standard_stream(path) {
        return standard_input().map(<[u8]>::to_vec);
    }
    check_plain(path, expected)?;
    std::fs::read(path).map_err(|error| unreadable(&error))
}

/// An error unless the path leads to a plain file, or is `-`.
pub fn check_plain(path: &Path, expected: &str) -> Result<()> {
    if is_standard_stream(path) {
        return Ok(());
    }
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
