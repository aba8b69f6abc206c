//! Finding the six faces among the files of a folder or archive, with its subfolders.

use std::collections::{BTreeMap, BTreeSet};

use super::passing_over::{is_passed_over, is_readable_format};
use super::selection::{self, Found, Selection};
use crate::envmap::Face;
use crate::error::{Error, Result};

/// How many names an error lists before it counts the rest.
const LISTED: usize = 12;

/// The six faces of a folder or archive, as indices into the list of its files, and what was passed over.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Located {
    pub six: [usize; 6],
    pub passed_over: Vec<String>,
}

/// The files of one directory by their place in the whole list.
struct Directory<'a> {
    name: &'a str,
    files: Vec<usize>,
}

/// Finds the six faces among paths (parts separated by `/`). The outermost directory wins over its subfolders; of the
/// subfolders exactly one may hold six faces.
pub(super) fn find_faces(paths: &[String]) -> Result<Located> {
    let directories = directories(paths);
    let selections: Vec<Selection> =
        directories.iter().map(|directory| globally(select_in(paths, directory), directory)).collect();
    let chosen: Vec<usize> = (0..directories.len()).filter(|&index| !is_unclear(&selections[index])).collect();
    let outermost = directories.iter().position(|directory| directory.name.is_empty());
    match (outermost, &chosen[..]) {
        (Some(outermost), _) if covers_all(&selections[outermost]) => settle(paths, &selections[outermost]),
        (_, &[only]) => settle(paths, &selections[only]),
        (_, &[]) => Err(no_complete_set(paths, &selections)),
        (_, several) => Err(several_folders(several.iter().map(|&index| directories[index].name))),
    }
}

/// The directories that hold files which may be faces, in the order of their names.
fn directories(paths: &[String]) -> Vec<Directory<'_>> {
    let mut directories: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (index, path) in paths.iter().enumerate().filter(|(_, path)| !is_passed_over(path)) {
        directories.entry(split(path).0).or_default().push(index);
    }
    directories.into_iter().map(|(name, files)| Directory { name, files }).collect()
}

/// Directory and file name of a path.
fn split(path: &str) -> (&str, &str) {
    path.rsplit_once('/').unwrap_or(("", path))
}

fn select_in(paths: &[String], directory: &Directory) -> Selection {
    let names: Vec<&str> = directory.files.iter().map(|&file| split(&paths[file]).1).collect();
    selection::select(&names)
}

/// A selection within one directory, in terms of the whole list.
fn globally(selection: Selection, directory: &Directory) -> Selection {
    let found = |found: Found| found.map(|files| files.into_iter().map(|file| directory.files[file]).collect());
    match selection {
        Selection::Six(six) => Selection::Six(six.map(|file| directory.files[file])),
        Selection::Several(sets) => Selection::Several(sets.into_iter().map(found).collect()),
        Selection::Unclear(files) => Selection::Unclear(found(files)),
    }
}

fn is_unclear(selection: &Selection) -> bool {
    matches!(selection, Selection::Unclear(_))
}

/// True if every face has a file, so that the directory is meant even if it needs tidying.
fn covers_all(selection: &Selection) -> bool {
    match selection {
        Selection::Unclear(found) => selection::missing(found).is_empty(),
        _ => true,
    }
}

/// The answer for the directory that is meant.
fn settle(paths: &[String], selection: &Selection) -> Result<Located> {
    match selection {
        Selection::Six(six) => Ok(Located { six: *six, passed_over: all_but(paths, six) }),
        Selection::Several(sets) => Err(several_sets(paths, sets)),
        Selection::Unclear(found) => Err(unclear(paths, found)),
    }
}

/// The paths that are not among the given ones, sorted.
fn all_but(paths: &[String], used: &[usize]) -> Vec<String> {
    let others: BTreeSet<&String> =
        paths.iter().enumerate().filter(|(index, _)| !used.contains(index)).map(|(_, path)| path).collect();
    others.into_iter().cloned().collect()
}

/// No directory has all six: shows the one that comes nearest.
fn no_complete_set(paths: &[String], selections: &[Selection]) -> Error {
    let mut nearest: Option<&Found> = None;
    for selection in selections {
        let Selection::Unclear(found) = selection else { continue };
        if nearest.is_none_or(|nearest| selection::missing(found).len() < selection::missing(nearest).len()) {
            nearest = Some(found);
        }
    }
    match nearest {
        Some(found) if selection::missing(found).len() < 6 => unclear(paths, found),
        _ => no_faces(paths),
    }
}

/// Nothing is named like a face.
fn no_faces(paths: &[String]) -> Error {
    let pictures: Vec<&String> =
        paths.iter().filter(|path| !is_passed_over(path) && is_readable_format(path)).collect();
    let problem = if paths.is_empty() { "no files in it" } else { "no file in it is named like a face of a cube" };
    let error = Error::new(format!("{problem}{}", passed_over_line(&all_but(paths, &[]))));
    match pictures[..] {
        [one] => error.help(format!("if {one} holds all six faces as a cross or strip, give that file itself")),
        _ => error,
    }
    .expected(NAMES)
}

/// The names that a user may give the files.
const NAMES: &str = "six pictures named posx negx posy negy posz negz, or px nx ..., or +x -x ..., or right left top bottom \
                     front back, or rt lf up dn ft bk, with any prefix, case and extension";

/// Faces are missing or have several files.
fn unclear(paths: &[String], found: &Found) -> Error {
    let (missing, doubled) = (selection::missing(found), selection::doubled(found));
    let counted = [(missing, "without a file"), (doubled, "with several files")];
    let parts: Vec<String> = counted
        .into_iter()
        .filter(|(faces, _)| !faces.is_empty())
        .map(|(faces, what)| format!("{} {what}", names_of(&faces)))
        .collect();
    let problem = if parts.is_empty() { "one file stands for two faces".to_owned() } else { parts.join("; ") };
    let used: Vec<usize> = found.iter().flatten().copied().collect();
    let rest = passed_over_line(&all_but(paths, &used));
    Error::new(format!("{problem}{}{rest}", table(paths, found)))
        .expected("one picture for each of the six faces")
        .help(
            "rename files, or move those that do not belong out of the way; a scene may also name the six files itself",
        )
}

fn names_of(faces: &[Face]) -> String {
    faces.iter().map(|face| face.name()).collect::<Vec<_>>().join(", ")
}

/// One line for each face with what was found for it.
fn table(paths: &[String], found: &Found) -> String {
    let line = |face: Face| {
        let files: Vec<&str> = found[face.index()].iter().map(|&file| paths[file].as_str()).collect();
        let files = if files.is_empty() { "nothing".to_owned() } else { shortened(&files) };
        format!("\n  {}: {files}", face.name())
    };
    Face::ALL.map(line).concat()
}

/// A line with the files that are no face; nothing if there are none.
fn passed_over_line(names: &[String]) -> String {
    if names.is_empty() { String::new() } else { format!("\n  passed over: {}", shortened(names)) }
}

/// A list that stays readable when a folder holds thousands of files.
fn shortened(names: &[impl AsRef<str>]) -> String {
    let shown: Vec<&str> = names.iter().take(LISTED).map(AsRef::as_ref).collect();
    let more = if names.len() > LISTED { format!(" and {} more", names.len() - LISTED) } else { String::new() };
    format!("{}{more}", shown.join(", "))
}

/// One directory holds several complete sets.
fn several_sets(paths: &[String], sets: &[Found]) -> Error {
    let list = |found: &Found| {
        let files: Vec<&str> = found.iter().flatten().map(|&file| paths[file].as_str()).collect();
        format!("\n  {}", shortened(&files))
    };
    let lists: String = sets.iter().map(list).collect();
    Error::new(format!("{} complete sets of six faces{lists}", sets.len()))
        .expected("one set")
        .help("move all sets but one into folders of their own; a scene may also name the six files itself")
}

/// Several subfolders hold complete sets.
fn several_folders<'a>(folders: impl Iterator<Item = &'a str>) -> Error {
    let folders: Vec<&str> = folders.collect();
    let lines: String = folders.iter().take(LISTED).map(|folder| format!("\n  {folder}")).collect();
    let more = if folders.len() > LISTED { format!("\n  and {} more", folders.len() - LISTED) } else { String::new() };
    Error::new(format!("{} subfolders hold six faces each{lines}{more}", folders.len()))
        .expected("one set of six faces")
        .help(format!("name the subfolder that is meant after a slash, as in .../{}", folders[0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn six_in(directory: &str) -> Vec<String> {
        Face::ALL.map(|face| format!("{directory}{}.png", face.name())).to_vec()
    }

    #[test]
    fn the_outermost_set_wins_over_those_of_subfolders() {
        let paths = [six_in("small/"), six_in("")].concat();
        let located = find_faces(&paths).unwrap();
        assert_eq!(located.six, [6, 7, 8, 9, 10, 11]);
        assert_eq!(located.passed_over.len(), 6);
    }

    #[test]
    fn one_subfolder_serves_whatever_lies_beside_it() {
        let paths = [vec!["front.png".to_owned(), "readme.txt".to_owned()], six_in("Sky/Textures/")].concat();
        assert_eq!(find_faces(&paths).unwrap().six, [2, 3, 4, 5, 6, 7]);
        assert_eq!(find_faces(&paths).unwrap().passed_over, ["front.png", "readme.txt"]);
    }

    #[test]
    fn several_subfolders_are_listed() {
        insta::assert_snapshot!(find_faces(&[six_in("Day/"), six_in("Night/")].concat()).unwrap_err(), @r"
        2 subfolders hold six faces each
          Day
          Night
          expected: one set of six faces
          help: name the subfolder that is meant after a slash, as in .../Day
        ");
    }

    #[test]
    fn a_set_in_a_doubtful_outermost_directory_is_not_replaced_by_a_subfolder() {
        let paths = [six_in(""), six_in("Sky/"), vec!["posx.jpg".to_owned()]].concat();
        insta::assert_snapshot!(find_faces(&paths).unwrap_err(), @r"
        posx with several files
          posx: posx.png, posx.jpg
          negx: negx.png
          posy: posy.png
          negy: negy.png
          posz: posz.png
          negz: negz.png
          passed over: Sky/negx.png, Sky/negy.png, Sky/negz.png, Sky/posx.png, Sky/posy.png, Sky/posz.png
          expected: one picture for each of the six faces
          help: rename files, or move those that do not belong out of the way; a scene may also name the six files itself
        ");
    }

    #[test]
    fn faces_that_are_missing_or_double_are_listed() {
        let paths = ["posx.jpg", "posx.png", "negx.jpg", "posz.jpg", "readme.txt", "view.jpg"].map(str::to_owned);
        insta::assert_snapshot!(find_faces(&paths).unwrap_err(), @r"
        posy, negy, negz without a file; posx with several files
          posx: posx.jpg, posx.png
          negx: negx.jpg
          posy: nothing
          negy: nothing
          posz: posz.jpg
          negz: nothing
          passed over: readme.txt, view.jpg
          expected: one picture for each of the six faces
          help: rename files, or move those that do not belong out of the way; a scene may also name the six files itself
        ");
    }

    #[test]
    fn two_complete_sets_are_listed() {
        let words = ["right", "left", "top", "bottom", "front", "back"].map(|word| format!("{word}.png"));
        insta::assert_snapshot!(find_faces(&[six_in(""), words.to_vec()].concat()).unwrap_err(), @r"
        2 complete sets of six faces
          posx.png, negx.png, posy.png, negy.png, posz.png, negz.png
          right.png, left.png, top.png, bottom.png, front.png, back.png
          expected: one set
          help: move all sets but one into folders of their own; a scene may also name the six files itself
        ");
    }

    #[test]
    fn a_folder_without_faces_says_what_it_looked_for() {
        let paths = ["readme.txt", "storm.jpg"].map(str::to_owned);
        insta::assert_snapshot!(find_faces(&paths).unwrap_err(), @r"
        no file in it is named like a face of a cube
          passed over: readme.txt, storm.jpg
          expected: six pictures named posx negx posy negy posz negz, or px nx ..., or +x -x ..., or right left top bottom front back, or rt lf up dn ft bk, with any prefix, case and extension
          help: if storm.jpg holds all six faces as a cross or strip, give that file itself
        ");
        insta::assert_snapshot!(find_faces(&[]).unwrap_err(), @r"
        no files in it
          expected: six pictures named posx negx posy negy posz negz, or px nx ..., or +x -x ..., or right left top bottom front back, or rt lf up dn ft bk, with any prefix, case and extension
        ");
    }
}
