//! Six files in a folder, or in its one subfolder that holds them.

use std::fs;
use std::io;
use std::path::Path;

use crate::error::{Error, Result};

/// The files of a folder and of its direct subfolders, as sorted paths relative to it with `/` between the parts.
pub(super) fn list(folder: &Path) -> Result<Vec<String>> {
    let mut paths = Vec::new();
    let mut subfolders = Vec::new();
    for (name, is_folder) in entries(folder)? {
        if is_folder { subfolders.push(name) } else { paths.push(name) }
    }
    for subfolder in subfolders {
        // An unreadable subfolder does not exclude the faces beside it.
        let Ok(entries) = entries(&folder.join(&subfolder)) else { continue };
        let files = entries.into_iter().filter(|(_, is_folder)| !is_folder);
        paths.extend(files.map(|(name, _)| format!("{subfolder}/{name}")));
    }
    paths.sort();
    Ok(paths)
}

/// Names in a folder, and whether each is a folder itself. Names that are not Unicode are left out: none is a face.
fn entries(folder: &Path) -> Result<Vec<(String, bool)>> {
    let read = || -> io::Result<Vec<(String, bool)>> {
        let mut entries = Vec::new();
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let Ok(name) = entry.file_name().into_string() else { continue };
            entries.push((name, entry.path().is_dir()));
        }
        Ok(entries)
    };
    read().map_err(|error| Error::new(format!("the folder cannot be read: {error}")).in_file(folder))
}
