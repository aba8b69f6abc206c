//! The image of one face: its name and size, and its pixels on demand.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use skycube_files::archive::ArchiveEntry;

use super::layout::Cell;
use super::picture_file::{read_file, read_header};
use super::sheet::Sheet;
use crate::envmap::Face;
use crate::error::Result;
use crate::picture::{self, Header, Picture};

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
