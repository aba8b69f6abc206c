//! Folders of maps: which maps an argument stands for, and a command that runs on each of them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::terminal::{Outcome, remark, tell};
use crate::envmap::source::{FaceImage, Skybox, is_meant_as_map, is_passed_over, sets_in};
use crate::error::{Error, Result};
use crate::picture::is_standard_stream;

/// The maps that an argument stands for: those inside a folder of maps, else the argument itself.
pub fn maps_at(path: &Path) -> Vec<PathBuf> {
    if !path.is_dir() {
        return vec![path.to_owned()];
    }
    let sets = sets_in(path);
    if !sets.is_empty() {
        return sets;
    }
    let inside = if is_map(path) { Vec::new() } else { maps_inside(path) };
    if inside.is_empty() { vec![path.to_owned()] } else { inside }
}

/// True if the path is a map, or a folder that is meant as one: what lies deeper does not stand for it. A folder whose only
/// map lies in a subfolder is that map, unless there are others beside it.
fn is_map(path: &Path) -> bool {
    Skybox::open_lenient(path).map_or_else(|_| is_meant_as_map(path), |skybox| stands_for(path, &skybox))
}

/// True if a path stands for the map that it opened as.
pub fn stands_for(path: &Path, skybox: &Skybox) -> bool {
    let lies_here = |image: &FaceImage| image.file().parent() == Some(path);
    !path.is_dir() || skybox.images.iter().all(lies_here) || maps_inside(path).len() <= 1
}

/// The maps in a folder of maps and its subfolders, sorted. A subfolder that is neither a map nor holds one, and an archive
/// that cannot be read, is listed too: its line says what is wrong. A link to a folder is followed only if that is a map.
fn maps_inside(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    let mut maps = Vec::new();
    for path in paths {
        if path.is_dir() {
            let is_other_link = path.is_symlink() && sets_in(&path).is_empty() && !is_map(&path);
            maps.extend(if is_other_link { Vec::new() } else { maps_at(&path) });
            continue;
        }
        let is_archive = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("zip"));
        let is_passed_over = path.file_name().is_some_and(|name| is_passed_over(&name.to_string_lossy()));
        if is_archive || (!is_passed_over && is_map(&path)) {
            maps.push(path);
        }
    }
    maps
}

/// Runs a command on a map or on every map of a folder, each with its own place in the output folder. A map that fails does
/// not stop the others.
pub fn for_each_map(
    path: &Path,
    output: Option<&Path>,
    run: impl Fn(&Path, Option<&Path>) -> Result<Outcome>,
) -> Result<Outcome> {
    let maps = maps_at(path);
    if maps == [path] {
        return run(path, output);
    }
    if let Some(output) = output {
        refuse_inside(path, output)?;
        refuse_shared_places(path, &maps)?;
    }
    let (mut faults, mut failed) = (false, 0);
    for map in &maps {
        tell(format_args!("{}:\n", map.display()));
        let place = output.map(|output| output.join(place_of(path, map)));
        match run(map, place.as_deref()) {
            Ok(Outcome::Clean) => {}
            Ok(Outcome::Faults) => faults = true,
            Ok(Outcome::Interrupted) => return Ok(Outcome::Interrupted),
            Err(error) => {
                remark(format_args!("error: {error}\n"));
                failed += 1;
            }
        }
    }
    match failed {
        0 => Ok(if faults { Outcome::Faults } else { Outcome::Clean }),
        _ => Err(Error::new(format!("{failed} of {} maps failed", maps.len()))),
    }
}

/// The path of a map inside its library, without the extension of an archive or picture.
pub fn place_of(library: &Path, map: &Path) -> PathBuf {
    let inside = map.strip_prefix(library).unwrap_or(map);
    if map.is_file() { inside.with_extension("") } else { inside.to_path_buf() }
}

/// An error if two maps would be written to one place, as `Meadow` and `Meadow.zip`.
fn refuse_shared_places(library: &Path, maps: &[PathBuf]) -> Result<()> {
    let mut places = BTreeMap::new();
    for map in maps {
        if let Some(other) = places.insert(place_of(library, map), map) {
            return Err(Error::new(format!("this map and {} would be written to one place", other.display()))
                .in_file(map)
                .help("rename one of them, or name them one by one"));
        }
    }
    Ok(())
}

/// The path without links, as far as it exists.
pub fn resolved(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let existing = path.ancestors().find_map(|above| Some((above, above.canonicalize().ok()?)));
    existing
        .map_or_else(|| path.clone(), |(above, found)| found.join(path.strip_prefix(above).unwrap_or(Path::new(""))))
}

/// True if a path lies in a folder, or is that folder, whatever links lead there.
pub fn lies_inside(path: &Path, folder: &Path) -> bool {
    resolved(path).starts_with(resolved(folder))
}

/// An error if the output would lie among the maps, where the next run would take it for one; or is standard output.
fn refuse_inside(library: &Path, output: &Path) -> Result<()> {
    if is_standard_stream(output) {
        return Err(Error::new("standard output takes one picture, and this is a folder of maps").in_file(library));
    }
    if lies_inside(output, library) {
        return Err(Error::new("this folder lies inside the folder of maps")
            .in_file(output)
            .help("name another one with -o"));
    }
    Ok(())
}
