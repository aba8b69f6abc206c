//! Two folders of pictures, paired by their names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::library::lies_inside;
use crate::error::{Error, Result};
use crate::picture::Format;

/// A picture of mine and the expected one of the same name; one of them may be missing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pair {
    /// The path inside the folders, without extension.
    pub name: String,
    pub mine: Option<PathBuf>,
    pub expected: Option<PathBuf>,
}

/// All pictures of two folders and their subfolders, by name.
pub fn pairs(mine: &Path, expected: &Path) -> Result<Vec<Pair>> {
    if lies_inside(mine, expected) || lies_inside(expected, mine) {
        return Err(Error::new("one of the folders lies inside the other").in_file(mine).expected("two folders apart"));
    }
    let (mine, mut expected) = (pictures(mine)?, pictures(expected)?);
    let mut pairs = Vec::new();
    for (name, path) in mine {
        let other = expected.remove(&name);
        pairs.push(Pair { name, mine: Some(path), expected: other });
    }
    pairs.extend(expected.into_iter().map(|(name, path)| Pair { name, mine: None, expected: Some(path) }));
    pairs.sort_by(|one, other| one.name.cmp(&other.name));
    Ok(pairs)
}

/// The pictures of a folder by their names without extension.
fn pictures(folder: &Path) -> Result<BTreeMap<String, PathBuf>> {
    let mut found = BTreeMap::new();
    collect(folder, folder, &mut found)?;
    if found.is_empty() {
        return Err(Error::new("the folder holds no picture").in_file(folder));
    }
    Ok(found)
}

fn collect(root: &Path, folder: &Path, found: &mut BTreeMap<String, PathBuf>) -> Result<()> {
    let unreadable = |error: std::io::Error| Error::new(format!("cannot read the folder: {error}")).in_file(folder);
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.is_dir() && !path.is_symlink() {
            collect(root, &path, found)?;
        } else if path.is_file() && Format::of_extension(&path).is_some() {
            let inside = path.strip_prefix(root).unwrap_or(&path).with_extension("");
            let name = inside.to_string_lossy().replace(std::path::MAIN_SEPARATOR, "/");
            if let Some(other) = found.insert(name, path.clone()) {
                return Err(Error::new(format!("{} has the same name: pictures are paired by name", other.display()))
                    .in_file(path)
                    .help("leave one of them"));
            }
        }
    }
    Ok(())
}
