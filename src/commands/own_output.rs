//! What skycube wrote into a folder, so that a later run may replace it, and nothing else.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::envmap::Face;
use crate::error::{Error, Result};
use crate::picture::{make_folder, write_together};

/// The file that lists what was written. Hidden: it is no face of a map that lies in the folder.
const RECORD: &str = ".skycube-written";

const HEADING: &str =
    "# Written by skycube, with CRC-32: a later run may replace these files, unless they were changed.\n";

/// The CRC-32 of every file that was written to a folder, by name.
#[derive(Default)]
struct Record(BTreeMap<String, u32>);

impl Record {
    /// The record of a folder; without one, or with one that cannot be read, nothing in it is ours.
    fn read(folder: &Path) -> Self {
        let text = std::fs::read_to_string(folder.join(RECORD)).unwrap_or_default();
        let entry = |line: &str| {
            let (sum, name) = line.split_once("  ")?;
            Some((name.to_owned(), u32::from_str_radix(sum, 16).ok()?))
        };
        Self(text.lines().filter_map(entry).collect())
    }

    /// True if the file is as it was written.
    fn holds(&self, path: &Path) -> bool {
        let sum = path.file_name().and_then(OsStr::to_str).and_then(|name| self.0.get(name));
        sum.is_some_and(|&sum| std::fs::read(path).is_ok_and(|bytes| crc32fast::hash(&bytes) == sum))
    }

    fn add(&mut self, path: &Path, bytes: &[u8]) {
        if let Some(name) = path.file_name().and_then(OsStr::to_str) {
            self.0.insert(name.to_owned(), crc32fast::hash(bytes));
        }
    }

    fn to_text(&self) -> String {
        let mut text = HEADING.to_owned();
        for (name, sum) in &self.0 {
            let _ = writeln!(text, "{sum:08x}  {name}");
        }
        text
    }
}

/// An error if writing the targets, all of one folder, would replace a file that skycube did not write there, or one that
/// was changed since; or if the folder holds the same face in another format, which would make the result ambiguous.
pub fn refuse_pictures_of_others(targets: &[PathBuf]) -> Result<()> {
    let Some(folder) = targets.first().map(|target| folder_of(target)) else { return Ok(()) };
    let Ok(entries) = std::fs::read_dir(folder) else { return Ok(()) };
    let mut found: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    found.sort();
    let record = Record::read(folder);
    for path in found {
        if targets.iter().any(|target| target.file_name() == path.file_name()) {
            if !record.holds(&path) {
                return Err(Error::new("this picture is already there, and not as skycube wrote it")
                    .in_file(path)
                    .help("it may be one of your own: name another folder with -o, or move it away"));
            }
        } else if let Some(target) = targets.iter().find(|target| is_rival(&path, target)) {
            return Err(Error::new(format!("{} would lie beside it: two files for one face", target.display()))
                .in_file(path)
                .help("choose an empty folder with -o"));
        }
    }
    Ok(())
}

/// True if both are the same face by name, in upper or lower case.
fn is_rival(path: &Path, target: &Path) -> bool {
    let [stem, other] = [path, target].map(|path| path.file_stem().unwrap_or_default());
    stem.eq_ignore_ascii_case(other) && Face::ALL.iter().any(|face| stem.eq_ignore_ascii_case(face.name()))
}

/// Makes the folders, writes all files or none, and notes in each folder what was written.
pub fn write_own(files: &[(&Path, &[u8])]) -> Result<()> {
    let folders: BTreeSet<&Path> = files.iter().map(|(path, _)| folder_of(path)).collect();
    let mut records = Vec::new();
    for folder in folders {
        make_folder(folder)?;
        let mut record = Record::read(folder);
        files.iter().filter(|(path, _)| folder_of(path) == folder).for_each(|(path, bytes)| record.add(path, bytes));
        records.push((folder.join(RECORD), record.to_text()));
    }
    let records = records.iter().map(|(path, text)| (path.as_path(), text.as_bytes()));
    write_together(files.iter().copied().chain(records))
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_was_written_and_not_changed_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let [posx, negx] = ["posx.png", "negx.png"].map(|name| folder.path().join(name));
        let targets = [posx.clone(), negx.clone()];
        write_own(&[(&posx, b"one")]).unwrap();
        write_own(&[(&negx, b"two")]).unwrap();
        assert!(refuse_pictures_of_others(&targets).is_ok());
        std::fs::write(&posx, b"mine").unwrap();
        let error = refuse_pictures_of_others(&targets).unwrap_err();
        assert!(error.problem().contains("not as skycube wrote it"), "{error}");
        write_own(&[(&posx, b"one")]).unwrap();
        let rival = folder.path().join("NEGX.tga");
        std::fs::write(&rival, b"mine").unwrap();
        assert!(refuse_pictures_of_others(&targets).unwrap_err().problem().contains("would lie beside it"));
        std::fs::remove_file(rival).unwrap();
        std::fs::remove_file(folder.path().join(RECORD)).unwrap();
        assert!(refuse_pictures_of_others(&targets).is_err(), "without a record nothing is ours");
    }
}
