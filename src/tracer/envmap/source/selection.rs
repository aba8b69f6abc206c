//! Choosing the six faces among the files of one directory.

use super::naming::{self, Family, Reading};
use super::passing_over::is_readable_format;
use crate::envmap::Face;

/// For every face the files found for it, as indices into the list of names.
pub(super) type Found = [Vec<usize>; 6];

/// What the names of one directory yield.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Selection {
    /// One file for each face.
    Six([usize; 6]),
    /// Six files whose names number them in an order that is not known.
    Numbered([usize; 6]),
    /// Six pictures whose names say nothing, in the order of their names.
    Unnamed([usize; 6]),
    /// More than one complete set.
    Several(Vec<Found>),
    /// Faces are missing, or have several files. No face at all if every list is empty.
    Unclear(Found),
}

/// Chooses among file names (without directories).
///
/// 1. Names that differ only in the name of the face (`sky_ft`, `sky_bk`, ...) belong together.
/// 2. Otherwise names of one family, each by itself (`01-front`, `02-back`, ...).
/// 3. Otherwise any names that stand by themselves, if there is one for each face.
/// 4. Otherwise six names that differ only in a number, or six pictures of which at most a few are named.
pub(super) fn select(names: &[&str]) -> Selection {
    let readings: Vec<Vec<Reading>> = names.iter().map(|name| naming::readings(name)).collect();
    let alike =
        complete_sets(names, groups(&readings, &|reading| (Some(reading.family), &reading.prefix, &reading.suffix)));
    if !alike.is_empty() {
        return judge(alike);
    }
    let separate = last_separate(&readings);
    let families = groups(&separate, &|reading| (Some(reading.family), "", ""));
    let complete = complete_sets(names, families.clone());
    if !complete.is_empty() {
        return judge(complete);
    }
    let mixture = groups(&last_of_all(&separate), &|_| (None, "", "")).pop().unwrap_or_default();
    let mixture = prefer_readable(names, mixture);
    if let Some(six) = single_files(&mixture) {
        return Selection::Six(six);
    }
    if let Some(numbered) = numbered(names) {
        return numbered;
    }
    let found = most_faces(names, families, mixture);
    let pictures: Vec<usize> = (0..names.len()).filter(|&file| is_readable_format(names[file])).collect();
    match <[usize; 6]>::try_from(pictures) {
        Ok(mut six) if named_by_more_than_initials(&separate) <= MOSTLY_UNNAMED => {
            six.sort_by_key(|&file| names[file]);
            Selection::Unnamed(six)
        }
        _ => Selection::Unclear(found),
    }
}

/// Files with the name of a face up to which six pictures count as not named.
const MOSTLY_UNNAMED: usize = 2;

/// Files whose names contain a face name of more than one letter.
fn named_by_more_than_initials(separate: &[Vec<Reading>]) -> usize {
    separate.iter().filter(|all| all.iter().any(|reading| !reading.family.is_of_initials())).count()
}

/// Six names that differ only in a number that counts from one to the next.
fn numbered<'a>(names: &[&'a str]) -> Option<Selection> {
    let numbers = |(file, name): (usize, &&'a str)| naming::number(name).map(|found| (found, file));
    let readable = names.iter().enumerate().filter(|(_, name)| is_readable_format(name));
    let mut files: Vec<((&str, u32, &str), usize)> = readable.filter_map(numbers).collect();
    files.sort_by_key(|&((prefix, number, suffix), _)| (prefix, suffix, number));
    let mut sets = files.chunk_by(|(one, _), (other, _)| (one.0, one.2) == (other.0, other.2)).filter_map(|files| {
        let counts = files.windows(2).all(|pair| pair[1].0.1 == pair[0].0.1 + 1);
        let six: [usize; 6] = files.iter().map(|&(_, file)| file).collect::<Vec<_>>().try_into().ok()?;
        counts.then_some((files[0].0.0, six))
    });
    let (Some((prefix, files)), None) = (sets.next(), sets.next()) else { return None };
    Some(match naming::numbered_order(prefix) {
        Some(order) => Selection::Six(order.map(|place| files[place])),
        None => Selection::Numbered(files),
    })
}

/// What the names of a set have in common at their beginning, without separators at its end.
pub(super) fn common_prefix<'a>(names: &[&'a str]) -> &'a str {
    let mut prefix = names.first().copied().unwrap_or_default();
    while !names.iter().all(|name| name.starts_with(prefix)) {
        let last = prefix.char_indices().next_back().map_or(0, |(index, _)| index);
        prefix = &prefix[..last];
    }
    without_separators(prefix)
}

/// A name without the separators at its end.
pub(super) fn without_separators(name: &str) -> &str {
    name.trim_end_matches(['_', '-', '.', ' '])
}

/// What two names of one set have in common: family, prefix and suffix.
type Affixes<'a> = (Option<Family>, &'a str, &'a str);

/// The files of each group by face, each file once; the groups in the order of what their names have in common.
fn groups(readings: &[Vec<Reading>], affixes: &dyn Fn(&Reading) -> Affixes<'_>) -> Vec<Found> {
    let indexed = readings.iter().enumerate().flat_map(|(index, all)| all.iter().map(move |one| (index, one)));
    let mut files: Vec<(usize, &Reading)> = indexed.collect();
    files.sort_by(|(_, one), (_, other)| affixes(one).cmp(&affixes(other)));
    let alike = files.chunk_by(|(_, one), (_, other)| affixes(one) == affixes(other));
    alike.map(by_face).collect()
}

fn by_face(files: &[(usize, &Reading)]) -> Found {
    let mut found = Found::default();
    for &(index, reading) in files {
        let files = &mut found[reading.face.index()];
        if !files.contains(&index) {
            files.push(index);
        }
    }
    found
}

/// The groups that have every face, each different set once.
fn complete_sets(names: &[&str], groups: Vec<Found>) -> Vec<Found> {
    let mut sets = Vec::new();
    for found in groups.into_iter().filter(|found| found.iter().all(|files| !files.is_empty())) {
        let found = prefer_readable(names, found);
        if !sets.contains(&found) {
            sets.push(found);
        }
    }
    sets
}

/// One complete set is the answer unless a face has several files; several sets are for the user to choose from. Where the
/// same six files are named twice, `Front+Z` to `Left+X` say, the family that comes first counts: axes before words.
fn judge(mut sets: Vec<Found>) -> Selection {
    let files = |found: &Found| {
        let mut files = found.concat();
        files.sort_unstable();
        files
    };
    if sets.iter().any(|set| files(set) != files(&sets[0])) {
        return Selection::Several(sets);
    }
    let found = sets.remove(0);
    single_files(&found).map_or(Selection::Unclear(found), Selection::Six)
}

/// The one file of each face, if each has exactly one and no file stands for two.
pub(super) fn single_files(found: &Found) -> Option<[usize; 6]> {
    let mut six = [0; 6];
    for (file, files) in six.iter_mut().zip(found) {
        let [only] = files[..] else { return None };
        *file = only;
    }
    let distinct = (1..6).all(|index| !six[..index].contains(&six[index]));
    distinct.then_some(six)
}

/// Of each file and family the last reading that stands by itself: the face's name is nearest to the end.
fn last_separate(readings: &[Vec<Reading>]) -> Vec<Vec<Reading>> {
    let last = |all: &Vec<Reading>| {
        let mut kept: Vec<&Reading> = Vec::new();
        for reading in all.iter().filter(|reading| reading.separate) {
            match kept.iter_mut().find(|kept| kept.family == reading.family) {
                Some(kept) if reading.prefix.len() <= kept.prefix.len() => {}
                Some(kept) => *kept = reading,
                None => kept.push(reading),
            }
        }
        kept.into_iter().cloned().collect()
    };
    readings.iter().map(last).collect()
}

/// Of each file the last reading of any family.
fn last_of_all(readings: &[Vec<Reading>]) -> Vec<Vec<Reading>> {
    let last =
        |all: &Vec<Reading>| all.iter().max_by_key(|reading| reading.prefix.len()).cloned().into_iter().collect();
    readings.iter().map(last).collect()
}

/// Where a face has files in a format that can be read, its other files (layered originals, say) are left out.
fn prefer_readable(names: &[&str], mut found: Found) -> Found {
    for files in &mut found {
        if files.iter().any(|&file| is_readable_format(names[file])) {
            files.retain(|&file| is_readable_format(names[file]));
        }
    }
    found
}

/// The family with the most faces, or the mixture if that has more: the best thing to show when faces are missing.
fn most_faces(names: &[&str], families: Vec<Found>, mixture: Found) -> Found {
    let faces = |found: &Found| found.iter().filter(|files| !files.is_empty()).count();
    let mut best = Found::default();
    for found in families.into_iter().map(|found| prefer_readable(names, found)).chain([mixture]) {
        if faces(&found) > faces(&best) {
            best = found;
        }
    }
    best
}

/// The faces without a file.
pub(super) fn missing(found: &Found) -> Vec<Face> {
    Face::ALL.into_iter().filter(|face| found[face.index()].is_empty()).collect()
}

/// The faces with more than one file.
pub(super) fn doubled(found: &Found) -> Vec<Face> {
    Face::ALL.into_iter().filter(|face| found[face.index()].len() > 1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(names: &[&str]) -> Vec<String> {
        match select(names) {
            Selection::Six(six) => six.map(|index| names[index].to_owned()).to_vec(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn takes_names_that_differ_only_in_the_face() {
        let names = ["desertbk.tga", "desertdn.tga", "desertft.tga", "desertlf.tga", "desertrt.tga", "desertup.tga"];
        assert_eq!(
            chosen(&names).join(" "),
            "desertrt.tga desertlf.tga desertup.tga desertdn.tga desertft.tga desertbk.tga"
        );
    }

    #[test]
    fn takes_signs_between_other_words() {
        let names = ["a-x-1.png", "a+x-1.png", "a-y-1.png", "a+y-1.png", "a-z-1.png", "a+z-1.png"];
        assert_eq!(chosen(&names).join(" "), "a+x-1.png a-x-1.png a+y-1.png a-y-1.png a+z-1.png a-z-1.png");
    }

    #[test]
    fn axes_count_where_the_same_files_name_a_side_too() {
        // AllSky, as sold for Unity, whose left is +X.
        let names = ["0_Front+Z", "1_Back-Z", "2_Left+X", "3_Right-X", "4_Up+Y", "5_Down-Y"];
        let names = names.map(|name| format!("Overcast_Cam_{name}.png"));
        let chosen = chosen(&names.each_ref().map(String::as_str));
        assert_eq!([2, 3, 4, 5, 0, 1].map(|at| names[at].clone()).to_vec(), chosen);
    }

    #[test]
    fn takes_one_family_with_different_prefixes_and_extensions() {
        let names = ["1 right.jpg", "2 left.png", "3 up.jpg", "4 down.tga", "5 front.jpg", "6 back.jpg", "view.jpg"];
        assert_eq!(chosen(&names).join("|"), "1 right.jpg|2 left.png|3 up.jpg|4 down.tga|5 front.jpg|6 back.jpg");
    }

    #[test]
    fn a_family_with_all_six_wins_over_a_mixture() {
        let names = ["rt.png", "lf.png", "up.png", "dn.png", "ft.png", "bk.png", "front.png", "posx.png"];
        assert_eq!(chosen(&names).join(" "), "rt.png lf.png up.png dn.png ft.png bk.png");
    }

    #[test]
    fn a_mixture_serves_if_nothing_else_does() {
        let names = ["posx.png", "left.png", "+y.png", "ny.png", "ft.png", "sky_back.png"];
        assert_eq!(chosen(&names), names);
    }

    #[test]
    fn layered_originals_are_left_out() {
        let names = ["px.psd", "px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"];
        assert_eq!(chosen(&names)[0], "px.png");
    }

    #[test]
    fn two_complete_sets_are_for_the_user_to_choose_from() {
        let names: Vec<String> = ["day", "night"]
            .iter()
            .flat_map(|time| Face::ALL.map(|face| format!("{time}_{}.png", face.name())))
            .collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        assert!(matches!(select(&names), Selection::Several(sets) if sets.len() == 2));
    }

    #[test]
    fn a_double_face_is_unclear() {
        let names = ["px.png", "px.jpg", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"];
        let Selection::Unclear(found) = select(&names) else { panic!("a double face was chosen") };
        assert_eq!(doubled(&found), [Face::PosX]);
        assert_eq!(found[0], [0, 1]);
    }

    #[test]
    fn a_missing_face_is_unclear() {
        let Selection::Unclear(found) = select(&["px.png", "nx.png", "py.png", "ny.png", "pz.png", "view.png"]) else {
            panic!("five faces were chosen")
        };
        assert_eq!(missing(&found), [Face::NegZ]);
    }

    #[test]
    fn one_file_never_serves_two_faces() {
        let names = ["px.png", "nx.png", "py.png", "ny.png", "front_back.png"];
        let Selection::Unclear(found) = select(&names) else { panic!("five files were chosen") };
        assert_eq!(missing(&found), [Face::PosZ]);
    }
}
