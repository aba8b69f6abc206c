//! Finding the six faces among the files of a folder or archive, with its subfolders.

use super::listing_errors::{no_complete_set, several_folders, several_sets, unclear};
use super::passing_over::{all_but, is_passed_over};
use super::selection::{self, Found, Selection};
use crate::error::Result;

/// The six faces of a folder or archive, as indices into the list of its files, and what was passed over.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Located {
    pub six: [usize; 6],
    pub naming: Naming,
    pub passed_over: Vec<String>,
}

/// What the names of six images say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Naming {
    /// Which face each image is.
    Faces,
    /// They number the images, in an order that is not known.
    Numbers,
    /// Nothing.
    Nothing,
    /// They are cells of a strip or sheet, whose order varies between programs.
    Cells,
}

impl Naming {
    /// True if the images may stand in any order.
    pub fn is_free(self) -> bool {
        self != Self::Faces
    }
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
    let named: Vec<usize> = (0..directories.len()).filter(|&index| names_faces(&selections[index])).collect();
    let ordered = (0..directories.len()).filter(|&index| !is_unclear(&selections[index]));
    let chosen: Vec<usize> = if named.is_empty() { ordered.collect() } else { named };
    let outermost = directories.iter().position(|directory| directory.name.is_empty());
    match (outermost, &chosen[..]) {
        (Some(outermost), _) if covers_all(&selections[outermost]) => settle(paths, &selections[outermost]),
        (_, &[only]) => settle(paths, &selections[only]),
        (_, &[]) => Err(no_complete_set(paths, &selections)),
        (_, several) => Err(several_folders(several.iter().map(|&index| directories[index].name))),
    }
}

/// True if the files of one directory, by their names, are those of more than three faces.
pub(super) fn names_most_faces(names: &[String]) -> bool {
    let faces: Vec<&str> = names.iter().filter(|name| !is_passed_over(name)).map(String::as_str).collect();
    match selection::select(&faces) {
        Selection::Unclear(found) => found.iter().filter(|files| !files.is_empty()).count() > 3,
        Selection::Unnamed(_) => false,
        _ => true,
    }
}

/// The directories that hold files which may be faces, in the order of their names.
fn directories(paths: &[String]) -> Vec<Directory<'_>> {
    let directory = |&file: &usize| split(&paths[file]).0;
    let mut files: Vec<usize> = (0..paths.len()).filter(|&file| !is_passed_over(&paths[file])).collect();
    files.sort_by_key(directory);
    let together = files.chunk_by(|one, other| directory(one) == directory(other));
    together.map(|files| Directory { name: directory(&files[0]), files: files.to_vec() }).collect()
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
        Selection::Numbered(six) => Selection::Numbered(six.map(|file| directory.files[file])),
        Selection::Unnamed(six) => Selection::Unnamed(six.map(|file| directory.files[file])),
        Selection::Several(sets) => Selection::Several(sets.into_iter().map(found).collect()),
        Selection::Unclear(files) => Selection::Unclear(found(files)),
    }
}

fn names_faces(selection: &Selection) -> bool {
    matches!(selection, Selection::Six(_) | Selection::Several(_))
}

fn is_unclear(selection: &Selection) -> bool {
    matches!(selection, Selection::Unclear(_))
}

/// True if every face has a file, so that the directory is meant even if it needs tidying.
fn covers_all(selection: &Selection) -> bool {
    match selection {
        Selection::Unclear(found) => selection::missing(found).is_empty(),
        _ => names_faces(selection),
    }
}

/// The answer for the directory that is meant.
fn settle(paths: &[String], selection: &Selection) -> Result<Located> {
    match selection {
        Selection::Six(six) => Ok(located(paths, *six, Naming::Faces)),
        Selection::Numbered(six) => Ok(located(paths, *six, Naming::Numbers)),
        Selection::Unnamed(six) => Ok(located(paths, *six, Naming::Nothing)),
        Selection::Several(sets) => Err(several_sets(paths, sets)),
        Selection::Unclear(found) => Err(unclear(paths, found)),
    }
}

fn located(paths: &[String], six: [usize; 6], naming: Naming) -> Located {
    Located { six, naming, passed_over: all_but(paths, &six) }
}

/// The sets of six faces in the outermost directory, each with what its names begin with; none unless there are several and
/// their beginnings tell them apart.
pub(super) fn sets(paths: &[String]) -> Vec<(String, Located)> {
    let directories = directories(paths);
    let Some(outermost) = directories.iter().find(|directory| directory.name.is_empty()) else { return Vec::new() };
    let Selection::Several(sets) = globally(select_in(paths, outermost), outermost) else { return Vec::new() };
    let named = |found: Found| {
        let six = selection::single_files(&found)?;
        let names = six.map(|file| paths[file].as_str());
        Some((selection::common_prefix(&names).to_owned(), located(paths, six, Naming::Faces)))
    };
    let sets: Vec<(String, Located)> = sets.into_iter().filter_map(named).collect();
    let distinct = sets
        .iter()
        .enumerate()
        .all(|(index, (prefix, _))| !prefix.is_empty() && sets[..index].iter().all(|(other, _)| other != prefix));
    if distinct { sets } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::Face;

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
          help: name the subfolder after a slash, as in .../Day
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
          ignored: Sky/negx.png, Sky/negy.png, Sky/negz.png, Sky/posx.png, Sky/posy.png, Sky/posz.png
          expected: one picture for each of the six faces
          help: rename files, or move the superfluous ones away; a scene may also name the six files itself
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
          ignored: readme.txt, view.jpg
          expected: one picture for each of the six faces
          help: rename files, or move the superfluous ones away; a scene may also name the six files itself
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
          help: choose a set by the prefix of its files, as in FOLDER/day_; or move the others away; a scene may also name the six files itself
        ");
    }

    #[test]
    fn a_folder_without_faces_says_what_it_looked_for() {
        let paths = ["readme.txt", "storm.jpg"].map(str::to_owned);
        insta::assert_snapshot!(find_faces(&paths).unwrap_err(), @r"
        no file in it has the name of a cube face
          ignored: readme.txt, storm.jpg
          expected: six pictures named posx negx posy negy posz negz, or px nx ..., or +x -x ..., or right left top bottom front back, or rt lf up dn ft bk, or r l u d f b, or numbered, with any prefix, case and extension
          help: if storm.jpg holds all six faces as a cross or strip, give that file itself
        ");
        insta::assert_snapshot!(find_faces(&[]).unwrap_err(), @r"
        no files in it
          expected: six pictures named posx negx posy negy posz negz, or px nx ..., or +x -x ..., or right left top bottom front back, or rt lf up dn ft bk, or r l u d f b, or numbered, with any prefix, case and extension
        ");
    }
}
