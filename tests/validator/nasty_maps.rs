//! Maps with the faults and oddities of real ones: what must be found, and what must not be called broken.

use std::sync::LazyLock;

use super::made_up::from_directions;
use super::pictures::{Map, Storage, computed, display, oriented, right_maps};
use skycube::envmap::{Face, Orientation};
use skycube::picture::Picture;
use skycube::stress::Random;
use skycube::validate::{Check, Names, Note, Reason, Verdict};

const SIZE: usize = 256;

fn stars(count: usize) -> Map {
    let mut random = Random(5);
    let mut faces = Vec::new();
    for _ in Face::ALL {
        let mut bright = vec![0.0_f32; SIZE * SIZE];
        for _ in 0..count {
            bright[random.below(SIZE * SIZE)] = 60.0 + 195.0 * random.unit() as f32;
        }
        faces.push(computed(SIZE, |x, y| [bright[y * SIZE + x]; 3]));
    }
    Map::new(faces.try_into().unwrap())
}

fn changed(picture: &Picture, change: impl Fn(usize, usize, [f32; 3]) -> [f32; 3]) -> Picture {
    computed(picture.width(), |x, y| change(x, y, display(picture, x, y)))
}

fn with(map: &Map, face: usize, picture: Picture) -> Map {
    let mut pictures = map.pictures().clone();
    pictures[face] = picture;
    Map::new(pictures)
}

/// The project's maps and the real ones at hand, as JPEG of quality 50.
fn maps() -> &'static [(&'static str, Map)] {
    static MAPS: LazyLock<Vec<(&'static str, Map)>> =
        LazyLock::new(|| right_maps().iter().map(|(name, map)| (*name, map.stored(&Storage::jpeg(SIZE)))).collect());
    &MAPS
}

/// What was found, for messages.
fn found(check: &Check) -> String {
    let fixes = check.fix.faces.map(|fix| (fix.image.name(), fix.orientation.formulas(), fix.decided));
    format!("{:?} {:?} {fixes:?}", check.verdict, check.outliers)
}

#[track_caller]
fn assert_unbroken(what: &str, map: &Map) {
    let check = map.check(Names::Auto);
    assert!(check.verdict != Verdict::Broken && check.fix.changes == 0, "{what}: {}", found(&check));
}

#[test]
fn stars_are_undecidable() {
    for count in [20, 200, 2000] {
        let map = stars(count);
        assert_eq!(map.check(Names::Auto).verdict, Verdict::Undecidable, "{count} stars");
        assert_eq!(map.stored(&Storage::jpeg(SIZE)).check(Names::Auto).verdict, Verdict::Undecidable, "{count} stars");
    }
}

#[test]
fn unrelated_pictures_never_fit_and_none_is_changed_or_blamed() {
    let maps = maps();
    let mut random = Random(3);
    for trial in 0..20 {
        let pictures: [Picture; 6] = std::array::from_fn(|face| {
            let map = &maps[(trial + face * (1 + trial % 3)) % maps.len()].1;
            oriented(&map.pictures()[random.below(6)], Orientation::ALL[random.below(8)])
        });
        let check = Map::new(pictures).check(Names::Auto);
        assert_ne!(check.verdict, Verdict::Fits, "mixture {trial}: {}", found(&check));
        assert_eq!((check.fix.changes, check.outliers.len()), (0, 0), "mixture {trial}: {}", found(&check));
    }
}

#[test]
fn exposure_frames_and_vignettes_do_not_break_a_right_map() {
    for (name, map) in maps() {
        for factors in [[0.9, 1.1, 1.0, 0.95, 1.05, 0.9], [0.7, 1.2, 1.0, 0.8, 1.3, 0.6]] {
            let exposed = |face: usize| changed(&map.pictures()[face], |_, _, c| c.map(|v| v * factors[face]));
            assert_unbroken(&format!("{name} exposed by {factors:?}"), &Map::new(std::array::from_fn(exposed)));
        }
        let border = |i: usize| i == 0 || i == SIZE - 1;
        let framed =
            |face: usize| changed(&map.pictures()[face], |x, y, c| if border(x) || border(y) { [10.0; 3] } else { c });
        let framed = Map::new(std::array::from_fn(framed));
        assert_unbroken(&format!("{name} framed"), &framed);
        let square = |i: usize| (i as f32 / SIZE as f32 - 0.5).powi(2);
        let vignette = |face: usize| {
            changed(&map.pictures()[face], |x, y, c| c.map(|v| v * (1.0 - 0.5 * (square(x) + square(y)))))
        };
        assert_unbroken(&format!("{name} with vignettes"), &Map::new(std::array::from_fn(vignette)));
    }
}

#[test]
fn dark_frames_and_exposures_together_do_not_break_a_right_map() {
    let factors = [0.8, 1.15, 1.0, 0.9, 1.1, 0.75];
    for (name, original) in right_maps() {
        for (size, dark) in [(64, 0.0), (64, 16.0), (SIZE, 16.0)] {
            let map = original.stored(&Storage::png(size));
            let border = |x: usize, y: usize| x.min(y) == 0 || x.max(y) == size - 1;
            let spoilt = |face: usize| {
                changed(&map.pictures()[face], |x, y, colour| {
                    if border(x, y) { [dark; 3] } else { colour.map(|code| code * factors[face]) }
                })
            };
            let spoilt = Map::new(std::array::from_fn(spoilt));
            assert_unbroken(&format!("{name} {size}, exposed and framed in {dark}"), &spoilt);
            let compressed = spoilt.stored(&Storage::jpeg(size));
            assert_unbroken(&format!("{name} {size}, exposed and framed in {dark}, JPEG"), &compressed);
        }
    }
}

#[test]
fn byte_identical_faces_are_named_and_never_put_wrong() {
    // The four walls of a room are one picture, symmetric about its middle, between a floor and a ceiling.
    let wall = |x: usize, y: usize| {
        let across = x.min(SIZE - 1 - x);
        let bricks = if (across / 16 + y / 12).is_multiple_of(2) { 30.0 } else { 0.0 };
        [90.0 + bricks + y as f32 / 8.0, 80.0 + bricks, 70.0]
    };
    let ring = |x: usize, y: usize, wall_row: usize| {
        // The ring that a texel lies on ends at all four walls in the same way.
        let ring = x.min(y).min(SIZE - 1 - x).min(SIZE - 1 - y);
        let along = if x.min(SIZE - 1 - x) == ring { y } else { x };
        wall(along, wall_row).map(|code| code * (1.0 - ring as f32 / SIZE as f32))
    };
    let picture = |face: usize| match face {
        2 => computed(SIZE, |x, y| ring(x, y, 0)),
        3 => computed(SIZE, |x, y| ring(x, y, SIZE - 1)),
        _ => computed(SIZE, wall),
    };
    let room = Map::new(std::array::from_fn(picture));
    assert_unbroken("a room", &room);
    let check = room.check(Names::Auto);
    let walls = Note::Identical { images: vec![Face::PosX, Face::NegX, Face::PosZ, Face::NegZ] };
    assert_eq!(check.notes.iter().filter(|note| **note == walls).count(), 1, "{:?}", check.notes);
    for orientation in Orientation::ALL {
        let mut orientations = [Orientation::IDENTITY; 6];
        orientations[0] = orientation;
        let check = room.damaged(&[0, 1, 2, 3, 4, 5], &orientations).check(Names::Trusted);
        let [wall, others @ ..] = check.fix.faces;
        assert!(
            others.iter().all(|fix| fix.orientation == Orientation::IDENTITY),
            "{orientation:?}: {}",
            found(&check)
        );
        assert!(
            room.looks_alike(0, orientation.after(wall.orientation), 0) || !wall.decided,
            "{orientation:?}: {}",
            found(&check)
        );
    }
}

#[test]
fn a_copy_in_the_place_of_another_face_is_named() {
    for (name, map) in maps() {
        // In clouds that end alike all around, and above a flat ground, a copy may close the seams.
        if !["courtyard", "meadow"].contains(name) {
            continue;
        }
        for (copy, original) in (0..6).flat_map(|copy| (0..6).map(move |original| (copy, original))) {
            if copy == original {
                continue;
            }
            let check = with(map, copy, map.pictures()[original].clone()).check(Names::Auto);
            let reason = Reason::CopyOf(Face::ALL[original]);
            let named =
                check.outliers.iter().any(|outlier| outlier.face == Face::ALL[copy] && outlier.reason == reason);
            assert!(named, "{name}: {copy} is a copy of {original}: {}", found(&check));
        }
    }
}

#[test]
fn faint_frames_that_only_some_faces_show_do_not_make_outliers() {
    for (name, map) in right_maps() {
        for size in [64, 128, 256] {
            let small = map.stored(&Storage::png(size));
            let border = |x: usize, y: usize| x.min(y) == 0 || x.max(y) == size - 1;
            let half = |face: usize| {
                changed(&small.pictures()[face], |x, y, c| if border(x, y) { c.map(|code| code / 2.0) } else { c })
            };
            let framed = Map::new(std::array::from_fn(half));
            assert_unbroken(&format!("{name} {size} in a faint frame"), &framed);
            assert_unbroken(&format!("{name} {size} in a faint frame, JPEG"), &framed.stored(&Storage::jpeg(size)));
            let dark = changed(&small.pictures()[3], |x, y, c| if border(x, y) { [8.0; 3] } else { c });
            assert_unbroken(&format!("{name} {size}, one face in a frame"), &with(&small, 3, dark));
        }
    }
}

#[test]
fn a_dark_frame_is_named() {
    let map = &maps()[0].1;
    let framed =
        changed(&map.pictures()[3], |x, y, c| if x.min(y) == 0 || x.max(y) == SIZE - 1 { [5.0; 3] } else { c });
    let check = with(map, 3, framed).check(Names::Auto);
    assert_eq!(check.verdict, Verdict::Fits);
    assert!(check.notes.contains(&Note::Framed { images: vec![Face::NegY] }), "{:?}", check.notes);
}

#[test]
fn a_face_that_does_not_belong_is_named() {
    // Those whose every face has detail along its borders.
    let maps: Vec<&(&str, Map)> = maps()
        .iter()
        .filter(|(name, _)| ["compass", "courtyard", "meadow", "studio-garden", "city-upside-down"].contains(name))
        .collect();
    for (index, (name, map)) in maps.iter().enumerate() {
        for face in (index % 2..6).step_by(2) {
            let grey = computed(SIZE, |_, _| [128.0; 3]);
            let another = &maps[(index + 1) % maps.len()].1;
            let cases = [
                (grey, Reason::Flat),
                (map.pictures()[face ^ 1].clone(), Reason::CopyOf(Face::ALL[face ^ 1])),
                (another.pictures()[face].clone(), Reason::AnotherScene),
            ];
            for (picture, reason) in cases {
                let check = with(map, face, picture).check(Names::Auto);
                let outlier: Vec<(Face, Reason)> = check.outliers.iter().map(|one| (one.face, one.reason)).collect();
                assert_eq!(check.verdict, Verdict::Broken, "{name} {face} {reason:?}: {}", found(&check));
                assert_eq!(outlier, [(Face::ALL[face], reason)], "{name}");
                assert_eq!(check.fix.changes, 0, "{name} {face} {reason:?}");
            }
        }
    }
}

#[test]
fn a_flat_face_is_a_note_unless_its_neighbours_end_otherwise() {
    // A sky that fades into one colour at the top, which has a flat picture of that colour.
    let fading = from_directions(SIZE, 1.0, |d| {
        let height = (d.y.max(0.0) / 0.57).min(1.0);
        let ground = 40.0 * (9.0 * d.x).fract() + 30.0 * (7.0 * d.z).fract();
        [90.0 + 60.0 * height + (1.0 - height) * ground, 120.0 + 60.0 * height, 200.0 - (1.0 - height) * ground]
    });
    let sky = with(&fading, 2, computed(SIZE, |_, _| [150.0, 180.0, 200.0]));
    let check = sky.check(Names::Auto);
    assert!(check.verdict != Verdict::Broken && check.outliers.is_empty(), "{}", found(&check));
    assert!(check.notes.contains(&Note::Flat { images: vec![Face::PosY] }), "{:?}", check.notes);
    assert!(!check.fix.faces[2].decided);
    let compass = &maps()[0].1;
    for colour in [[0.0; 3], [255.0; 3], [128.0; 3]] {
        let check = with(compass, 3, computed(SIZE, |_, _| colour)).check(Names::Auto);
        let outlier: Vec<(Face, Reason)> = check.outliers.iter().map(|one| (one.face, one.reason)).collect();
        assert_eq!((check.verdict, outlier), (Verdict::Broken, vec![(Face::NegY, Reason::Flat)]), "{colour:?}");
    }
}

#[test]
fn a_grey_face_among_coloured_ones_belongs_and_a_turned_one_is_found() {
    for (name, map) in maps().iter().filter(|(name, _)| ["compass", "meadow", "studio-garden"].contains(name)) {
        let grey = changed(&map.pictures()[4], |_, _, c| [(c[0] + 2.0 * c[1] + c[2]) / 4.0; 3]);
        assert_unbroken(&format!("{name} with a grey face"), &with(map, 4, grey.clone()));
        let check = with(map, 4, oriented(&grey, Orientation::ALL[4])).check(Names::Trusted);
        let fix = check.fix.faces[4];
        let others =
            check.fix.faces.iter().all(|fix| fix.face == Face::PosZ || fix.orientation == Orientation::IDENTITY);
        assert!(others && (fix.orientation == Orientation::ALL[5] || !fix.decided), "{name}: {}", found(&check));
    }
}

#[test]
fn a_hand_drawn_chart_is_never_mended_wrongly() {
    // Lines and letters in the middle of plain faces: each of another colour, or all white.
    for plain in [false, true] {
        let face = |face: usize| {
            let ground = if plain {
                [250.0; 3]
            } else {
                [[220.0, 60.0, 60.0], [60.0, 220.0, 60.0], [60.0, 60.0, 220.0]][face / 2]
            };
            computed(SIZE, |x, y| {
                let (x, y) = (x as i32 - 128, y as i32 - 128);
                let drawn = (x * x + y * y - 3600).abs() < 500 || (x > 0 && y.abs() < 3 && x < 70 + 8 * face as i32);
                if drawn { [20.0; 3] } else { ground }
            })
        };
        let map = Map::new(std::array::from_fn(face));
        for storage in [Storage::png(SIZE), Storage::jpeg(SIZE), Storage::jpeg(64)] {
            assert_unbroken(
                &format!("chart, plain: {plain}, {} {}", storage.name(), storage.size),
                &map.stored(&storage),
            );
        }
    }
}
