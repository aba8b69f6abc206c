//! Maps with several faces that do not belong: the pixels cannot decide what is right, and nothing right is changed. And
//! right maps that look a little like them: they fit.

use super::pictures::{Map, Storage, computed, display, project_map, right_maps};
use skycube::envmap::Face;
use skycube::picture::Picture;
use skycube::stress::Random;
use skycube::validate::{Check, Names, Note, Outlier, Reason, Verdict};

fn changed(picture: &Picture, change: impl Fn(usize, usize, [f32; 3]) -> [f32; 3]) -> Picture {
    computed(picture.width(), |x, y| change(x, y, display(picture, x, y)))
}

fn with(map: &Map, faces: &[usize], picture: impl Fn(usize) -> Picture) -> Map {
    let replaced = |face: usize| if faces.contains(&face) { picture(face) } else { map.pictures()[face].clone() };
    Map::new(std::array::from_fn(replaced))
}

fn named(name: &str, storage: &Storage) -> Option<Map> {
    right_maps().iter().find(|map| map.0 == name).map(|map| map.1.stored(storage))
}

/// A picture that no map holds: bricks of random colours, with noise.
fn patchwork(size: usize, seed: u64) -> Picture {
    let mut random = Random(seed);
    let brick = size / 12 + 1;
    let colours: Vec<[f32; 3]> = (0..144).map(|_| [(); 3].map(|()| 255.0 * random.unit() as f32)).collect();
    computed(size, |x, y| colours[12 * (y / brick) + x / brick].map(|code| code * (0.9 + 0.1 * ((x * y) % 3) as f32)))
}

fn rough_but_fitting(check: &Check) -> bool {
    check.notes.iter().any(|note| matches!(note, Note::Rough { .. }))
}

#[test]
fn two_faces_of_another_scene_do_not_fit_and_change_nothing() {
    for (name, size) in [("compass", 256), ("courtyard", 256), ("courtyard", 128), ("studio-garden", 256)] {
        let Some(map) = named(name, &Storage::png(size)) else { continue };
        for faces in [[0, 1], [0, 5], [4, 5]] {
            let check = with(&map, &faces, |face| patchwork(size, face as u64)).check(Names::Auto);
            assert_ne!(check.verdict, Verdict::Fits, "{name} {size} {faces:?}");
            assert!(check.fix.changes == 0 && !rough_but_fitting(&check), "{name} {size} {faces:?}: {:?}", check.fix);
        }
    }
}

/// At 32 texels and JPEG quality 25 few borders tell anything, but nobody overlooks a black face.
#[test]
fn a_face_of_one_colour_stands_out_where_compression_leaves_little_of_the_others() {
    let map = project_map("hall").stored(&Storage::png(32));
    for (face, code) in (0..6).flat_map(|face| [0.0, 200.0].map(|code| (face, code))) {
        let check = with(&map, &[face], |_| computed(32, |_, _| [code; 3]))
            .stored(&Storage::jpeg_of_quality(32, 25))
            .check(Names::Auto);
        let outliers: Vec<Outlier> = vec![Outlier { face: Face::ALL[face], reason: Reason::Flat }];
        assert_eq!((check.verdict, check.outliers), (Verdict::Broken, outliers), "face {face}, colour {code}");
        assert_eq!(check.fix.changes, 0, "face {face}, colour {code}");
    }
}

#[test]
fn copies_do_not_make_right_faces_wrong() {
    for name in ["courtyard", "meadow", "studio-garden"] {
        let Some(map) = named(name, &Storage::png(256)) else { continue };
        for (faces, original) in [([0, 1], 5), ([4, 5], 0), ([0, 4], 1)] {
            let check = with(&map, &faces, |_| map.pictures()[original].clone()).check(Names::Auto);
            assert_eq!(check.fix.changes, 0, "{name}, {faces:?} are {original}: {:?} {:?}", check.fix, check.outliers);
            assert_ne!(check.verdict, Verdict::Fits, "{name}, {faces:?} are {original}");
        }
    }
}

/// A right map as it is, grey in one face, exposed face by face, in frames.
fn spoilt(map: &Map, size: usize) -> Vec<(String, Map)> {
    let mut maps = vec![("as it is".to_owned(), map.clone())];
    for grey in 0..6 {
        let picture = |face: usize| changed(&map.pictures()[face], |_, _, c| [(c[0] + 2.0 * c[1] + c[2]) / 4.0; 3]);
        maps.push((format!("grey {grey}"), with(map, &[grey], picture)));
    }
    for factors in [[0.9, 1.1, 1.0, 0.95, 1.05, 0.9], [0.7, 1.2, 1.0, 0.8, 1.3, 0.6]] {
        let picture = |face: usize| changed(&map.pictures()[face], |_, _, c| c.map(|code| code * factors[face]));
        maps.push((format!("exposed {factors:?}"), with(map, &[0, 1, 2, 3, 4, 5], picture)));
    }
    let border = |x: usize, y: usize| x.min(y) == 0 || x.max(y) == size - 1;
    let framed = |face: usize| changed(&map.pictures()[face], |x, y, c| if border(x, y) { [10.0; 3] } else { c });
    maps.push(("framed".to_owned(), with(map, &[0, 1, 2, 3, 4, 5], framed)));
    maps.push(("one frame".to_owned(), with(map, &[3], framed)));
    maps
}

#[test]
fn right_maps_fit_however_they_are_stored_and_spoilt() {
    // Of the chart only its background reaches the borders, which compression leaves nothing of.
    for (name, original) in right_maps().iter().filter(|map| map.0 != "openexr/OrientationCube.exr") {
        for storage in [Storage::png(128), Storage::jpeg(128), Storage::jpeg(64)] {
            // Of single stars compression leaves little, and a frame or other exposures take the rest.
            if *name == "night" && storage.name() != "PNG" {
                continue;
            }
            for (how, map) in spoilt(&original.stored(&storage), storage.size) {
                // A plain sky or sea in grey is one of another colour.
                if *name == "seaside" && how.starts_with("grey") {
                    continue;
                }
                let verdict = map.check(Names::Auto).verdict;
                assert_eq!(verdict, Verdict::Fits, "{name} {} {} {how}", storage.name(), storage.size);
            }
        }
    }
}

/// The verdicts on maps with two random faces of another map: fits, broken, undecidable; and how many maps are changed.
fn two_random_outlier_faces(trials: usize) -> [usize; 4] {
    let maps = right_maps();
    let mut counts = [0; 4];
    for storage in [Storage::png(256), Storage::jpeg(128)] {
        let maps: Vec<(&str, Map)> = maps.iter().map(|(name, map)| (*name, map.stored(&storage))).collect();
        let mut random = Random(3);
        for _ in 0..trials {
            let (own, other) = (random.below(maps.len()), random.below(maps.len() - 1));
            let other = if other >= own { other + 1 } else { other };
            let (one, two) = (random.below(6), random.below(5));
            let faces = [one, if two >= one { two + 1 } else { two }];
            let check = with(&maps[own].1, &faces, |face| maps[other].1.pictures()[face].clone()).check(Names::Auto);
            counts[check.verdict as usize] += 1;
            counts[3] += usize::from(check.fix.changes > 0);
        }
    }
    println!("fits, broken, undecidable, changed: {counts:?}");
    counts
}

#[test]
fn two_random_outlier_faces_change_nothing() {
    assert_eq!(two_random_outlier_faces(30)[3], 0);
}

#[test]
#[ignore = "open question: faces with the same sky or ground, or with nothing along their borders, fit"]
fn open_question_two_random_outlier_faces_never_fit() {
    assert_eq!(two_random_outlier_faces(90)[0], 0);
}
