//! Six files in a downloaded zip archive, read without unpacking it.

use std::io::{Cursor, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use crate::error::{Error, Result};
use crate::guard::guarded;
use crate::plain_file::{PlainFile, open_file};

/// The largest face that is unpacked, in bytes: a guard against archives made to fill the memory.
const LARGEST_ENTRY: u64 = 1 << 30;

/// Bytes of a file's name.
const LONGEST_NAME: usize = 255;

/// The list of files in an archive.
pub struct Archive {
    path: Arc<Path>,
    /// Paths with `/` between the parts, and the place of each in the archive.
    entries: Vec<(String, usize)>,
}

/// One file in an archive. The archive is opened anew for every reading, so threads do not wait for each other.
#[derive(Debug, Clone)]
pub struct ArchiveEntry {
    archive: Arc<Path>,
    path: String,
    index: usize,
}

impl Archive {
    /// Reads the list of files.
    pub fn open(path: &Path) -> Result<Self> {
        guarded(DOWNLOAD_AGAIN, || Self::list(path)).map_err(|error| error.in_file(path))
    }

    fn list(path: &Path) -> Result<Self> {
        let archive = open(path)?;
        let mut entries = Vec::new();
        for index in 0..archive.len() {
            let entry = archive.by_index_data(index).map_err(|error| refused(&error).in_file(path))?;
            let decoded = entry.name().map(|name| name.into_owned());
            let name = decoded.unwrap_or_else(|_| String::from_utf8_lossy(entry.name_raw()).into_owned());
            // Some archivers of Windows write backslashes.
            let name = name.replace('\\', "/");
            // No file system has longer names: an archive with one is made to fill the terminal.
            let bounded = name.split('/').all(|part| part.len() <= LONGEST_NAME);
            if !name.ends_with('/') && bounded {
                entries.push((name, index));
            }
        }
        entries.sort();
        Ok(Self { path: path.into(), entries })
    }

    /// The archive with the files of one of its folders alone.
    pub fn subfolder(mut self, folder: &str) -> Result<Self> {
        let prefix = format!("{folder}/");
        self.entries.retain(|(name, _)| name.starts_with(&prefix));
        if self.entries.is_empty() {
            return Err(Error::new(format!("the archive has no folder {folder}")).in_file(&self.path));
        }
        Ok(self)
    }

    /// The paths of all files in the archive.
    pub fn paths(&self) -> Vec<String> {
        self.entries.iter().map(|(name, _)| name.clone()).collect()
    }

    /// The file at a place in the list of [`Archive::paths`].
    pub fn entry(&self, place: usize) -> ArchiveEntry {
        let (path, index) = &self.entries[place];
        ArchiveEntry { archive: Arc::clone(&self.path), path: path.clone(), index: *index }
    }
}

impl ArchiveEntry {
    /// The archive on disk.
    pub fn archive_file(&self) -> &Path {
        &self.archive
    }

    /// The archive's path followed by the path in it, for errors.
    pub fn path(&self) -> PathBuf {
        self.archive.join(&self.path)
    }

    /// The name of the archive followed by the path in it, as the user knows it.
    pub fn name(&self) -> String {
        let archive = self.archive.file_name().unwrap_or(self.archive.as_os_str());
        format!("{}/{}", archive.to_string_lossy(), self.path)
    }

    /// The unpacked bytes, or the first ones.
    pub fn read(&self, limit: Option<u64>) -> Result<Vec<u8>> {
        guarded(DOWNLOAD_AGAIN, || self.unpack(limit)).map_err(|error| error.in_file(self.path()))
    }

    fn unpack(&self, limit: Option<u64>) -> Result<Vec<u8>> {
        let mut archive = open(&self.archive)?;
        let entry = archive.by_index(self.index).map_err(|error| refused(&error))?;
        if entry.size() > LARGEST_ENTRY {
            return Err(too_large(entry.size()));
        }
        let mut bytes = Vec::new();
        // The size that the archive states may be a lie: never read more than the limit either way.
        let reading = entry.take(limit.unwrap_or(LARGEST_ENTRY + 1)).read_to_end(&mut bytes);
        reading.map_err(|error| Error::new(format!("cannot be unpacked: {error}")).help(DOWNLOAD_AGAIN))?;
        if bytes.len() as u64 > LARGEST_ENTRY { Err(too_large(bytes.len() as u64)) } else { Ok(bytes) }
    }
}

/// What to do about a damaged archive.
const DOWNLOAD_AGAIN: &str = "the archive is damaged or incomplete; download it again";

fn open(path: &Path) -> Result<ZipArchive<Box<dyn PlainFile>>> {
    let file = open_file(path).map_err(|error| error.in_file(path))?;
    ZipArchive::new(file).map_err(|error| refused(&error).in_file(path))
}

/// The bytes of an archive that holds files as they are, for pictures are compressed already. They tell no time.
pub fn archive_of<'a>(files: impl IntoIterator<Item = (&'a str, &'a [u8])>) -> Result<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    for (name, bytes) in files {
        archive.start_file(name, stored).map_err(|error| refused(&error))?;
        archive.write_all(bytes).map_err(|error| Error::new(format!("cannot be packed: {error}")))?;
    }
    Ok(archive.finish().map_err(|error| refused(&error))?.into_inner())
}

/// What is wrong with an archive or one of its entries.
fn refused(error: &ZipError) -> Error {
    match error {
        ZipError::UnsupportedArchive(ZipError::PASSWORD_REQUIRED) => {
            Error::new("is encrypted").help("unpack the archive with its password and give the folder")
        }
        ZipError::UnsupportedArchive(_) | ZipError::CompressionMethodNotSupported(_) => {
            Error::new(format!("cannot be unpacked: {error}")).help("unpack the archive and give the folder")
        }
        ZipError::Io(_) | ZipError::InvalidArchive(_) => Error::new(error.to_string()).help(DOWNLOAD_AGAIN),
        _ => Error::new(error.to_string()),
    }
}

fn too_large(size: u64) -> Error {
    Error::new(format!("would be {size} bytes unpacked")).expected(format!("at most {LARGEST_ENTRY} bytes per face"))
}
