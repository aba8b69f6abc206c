//! The image of one face: its name and size, and its pixels on demand.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use skycube_files::archive::ArchiveEntry;

use super::layout::Cell;
use super::sheet::Sheet;
use crate::envmap::Face;
use crate::error::{Error, Result};
use crate::picture::{self, Header, Picture};

/// How much of a file is read first to find its header; the whole file follows only if that does not suffice.
const HEAD: u64 = 256 * 1024;

/// The image of one face. Opening it has read the header alone; each call of [`FaceImage::decode`] decodes the pixels,
/// so whoever needs them twice keeps them. May be shared between threads.
#[derive(Debug, Clone)]
pub struct FaceImage {
    name: String,
    header: Header,
    origin: Origin,
}

/// Where the pixels come from.
#[derive(Debug, Clone)]
enum Origin {
    File(PathBuf),
    Entry(ArchiveEntry),
    Cell(Arc<Sheet>, Cell),
}

impl FaceImage {
    /// A face in a separate file, called `name` in reports.
    pub(super) fn from_file(path: PathBuf, name: String) -> Result<Self> {
        let (header, _) = read_header(|limit| read_file(&path, limit), &path)?;
        Ok(Self { name, header, origin: Origin::File(path) })
    }

    /// A face in an entry of a zip archive, called `name` in reports.
    pub(super) fn from_entry(entry: ArchiveEntry, name: String) -> Result<Self> {
        let (header, _) = read_header(|limit| entry.read(limit), &entry.path())?;
        Ok(Self { name, header, origin: Origin::Entry(entry) })
    }

    /// A face in a cell of a picture that holds all six.
    pub(super) fn from_cell(sheet: &Arc<Sheet>, face: Face) -> Self {
        let name = format!("{} [{} cell]", sheet.name(), face.signed_name());
        Self { name, header: sheet.cell_header(), origin: Origin::Cell(Arc::clone(sheet), sheet.cell(face)) }
    }

    /// The file as the user knows it: `posx.jpg`, `Meadow.zip/posx.jpg`, or `storm-cross.jpg [+x cell]`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The file on disk that the pixels are read from: the image itself, the archive or the larger picture.
    pub fn file(&self) -> &Path {
        match &self.origin {
            Origin::File(path) => path,
            Origin::Entry(entry) => entry.archive_file(),
            Origin::Cell(sheet, _) => sheet.path(),
        }
    }

    /// Format, and width and height of the face in pixels. For a cell of a larger picture the size is that of the cell.
    pub fn header(&self) -> Header {
        self.header
    }

    /// Decodes the pixels. The cells of one picture share its decoding.
    pub fn decode(&self) -> Result<Picture> {
        match &self.origin {
            Origin::File(path) => picture::decode(&read_file(path, None)?, path),
            Origin::Entry(entry) => picture::decode(&entry.read(None)?, &entry.path()),
            Origin::Cell(sheet, cell) => sheet.cut(*cell),
        }
    }

    /// The bytes of the file, to be copied as they are. None for a cell of a larger picture, which has no file.
    pub fn encoded_bytes(&self) -> Result<Option<Vec<u8>>> {
        match &self.origin {
            Origin::File(path) => read_file(path, None).map(Some),
            Origin::Entry(entry) => entry.read(None).map(Some),
            Origin::Cell(..) => Ok(None),
        }
    }
}

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
    let read = || {
        let mut bytes = Vec::new();
        let file = File::open(path)?;
        match limit {
            Some(limit) => file.take(limit).read_to_end(&mut bytes)?,
            None => { file }.read_to_end(&mut bytes)?,
        };
        Ok(bytes)
    };
    read().map_err(|error: std::io::Error| Error::new(format!("cannot be read: {error}")).in_file(path))
}
