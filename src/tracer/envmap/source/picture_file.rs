//! A picture file, or the beginning of one.

use std::io::Read;
use std::path::Path;

use crate::error::{Error, Result};
use crate::picture::{self, Header};

/// How much of a file is read first to find its header; the whole file follows only if that does not suffice.
const HEAD: u64 = 256 * 1024;

/// Reads a header from the beginning of a file, or from all of it where the beginning does not suffice. `read` yields
/// the bytes up to a limit; those that the header was read from are returned beside it.
pub(super) fn read_header(read: impl Fn(Option<u64>) -> Result<Vec<u8>>, name: &Path) -> Result<(Header, Vec<u8>)> {
    let head = read(Some(HEAD))?;
    match picture::read_header(&head, name) {
        Ok(header) => Ok((header, head)),
        // What does not begin as a picture is none, however long it is.
        Err(_) if head.len() as u64 == HEAD && picture::Format::of_content(&head, name).is_some() => {
            let whole = read(None)?;
            Ok((picture::read_header(&whole, name)?, whole))
        }
        Err(error) => Err(error),
    }
}

/// The bytes of a file, or its first ones.
pub(super) fn read_file(path: &Path, limit: Option<u64>) -> Result<Vec<u8>> {
    skycube_files::check_plain(path, "a picture file").map_err(|error| error.in_file(path))?;
    let mut file = skycube_files::open_file(path).map_err(|error| error.in_file(path))?;
    let mut bytes = Vec::new();
    let read = match limit {
        Some(limit) => file.take(limit).read_to_end(&mut bytes),
        None => file.read_to_end(&mut bytes),
    };
    read.map_err(|error| Error::new(format!("cannot be read: {error}")).in_file(path))?;
    Ok(bytes)
}
