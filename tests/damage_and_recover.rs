//! Right maps stay right, and damaged ones are recovered: orientations wrong face by face, on all faces, with images that
//! changed places; as PNG and as JPEG of quality 50; small and large.
//!
//! `cargo test --release --test damage_and_recover -- --ignored --nocapture` prints the whole table.

mod common;
#[path = "damage/pictures.rs"]
mod pictures;
#[path = "damage/recovery.rs"]
mod recovery;

use pictures::Storage;
use recovery::{Damage, Recovery, Tally};
use skycube::validate::{Names, Verdict};

fn table_row(name: &str, kind: &str, storage: &Storage, tally: &Tally) {
    println!(
        "{name:38} {kind:14} {:7} {:4} {:4} recovered {:3} tied {:3} undecided {:3} wrong",
        storage.name(),
        storage.size,
        tally.recovered,
        tally.tied,
        tally.undecided,
        tally.wrong.len()
    );
    for wrong in &tally.wrong {
        println!("    wrong: {wrong}");
    }
}

/// Of the orientations of a single face every third, unless the table is to be whole: all are tried on compressed maps.
fn run(storages: &[Storage], counts: [usize; 2], whole: bool) {
    run_on(storages, counts, whole, |name| !whole || name != "night");
}

fn run_on(storages: &[Storage], counts: [usize; 2], whole: bool, chosen: impl Fn(&str) -> bool) {
    let mut failures = 0;
    for (name, original) in pictures::right_maps().into_iter().filter(|(name, _)| chosen(name)) {
        for storage in storages {
            let map = original.stored(storage);
            let verdict = map.check(Names::Auto).verdict;
            if verdict == Verdict::Broken {
                println!("{name} {} {}: the right map is called broken", storage.name(), storage.size);
                failures += 1;
            }
            let step = if whole { 1 } else { 3 };
            let faces: Vec<Damage> = Damage::of_one_face().into_iter().step_by(step).collect();
            let kinds = [
                ("one face", faces.clone(), Names::Trusted),
                ("one face, any", faces.clone(), Names::Auto),
                ("all faces", Damage::random_orientations(counts[0]), Names::Trusted),
                ("all faces, any", Damage::random_orientations(counts[0]), Names::Auto),
                ("two swapped", Damage::swaps(counts[1]), Names::Auto),
            ];
            for (kind, damages, names) in kinds {
                let tally = Recovery::of(&map, names).tally(&damages);
                table_row(&format!("{name} {}", verdict.name()), kind, storage, &tally);
                failures += tally.wrong.len();
            }
        }
    }
    assert_eq!(failures, 0);
}

#[test]
fn small_maps_are_recovered() {
    run(&[Storage::png(64)], [2, 3], false);
}

/// What comes of one face in each wrong orientation, in a map of 64 texels at JPEG quality 50.
fn compressed_faces(name: &str, original: &pictures::Map) -> Tally {
    let map = original.stored(&Storage::jpeg(64));
    let tally = Recovery::of(&map, Names::Trusted).tally(&Damage::of_one_face());
    table_row(name, "one face", &Storage::jpeg(64), &tally);
    tally
}

#[test]
fn compressed_maps_of_64_texels_are_recovered_face_by_face() {
    // Mirrored about the horizon; a chart of which only the background reaches the borders; single stars over a black ground;
    // a plain sky over a plain beach; and the open question below.
    let partly = ["clouds-dusk", "openexr/OrientationCube.exr", "night", "seaside", "city-upside-down"];
    for (name, original) in pictures::right_maps() {
        let tally = compressed_faces(name, &original);
        assert!(tally.wrong.is_empty(), "{name}: {:?}", tally.wrong);
        assert!(tally.recovered == 42 || partly.contains(&name), "{name}: {}", tally.recovered);
    }
}

#[test]
#[ignore = "open question: a street flipped top-bottom is tied after strong compression, for no reason that the eye can see"]
fn a_compressed_street_flipped_top_bottom_is_recovered() {
    for (name, original) in pictures::right_maps().into_iter().filter(|(name, _)| *name == "city-upside-down") {
        assert_eq!(compressed_faces(name, &original).recovered, 42);
    }
}

#[test]
#[ignore = "whole table: minutes"]
fn the_whole_table() {
    run(&[Storage::png(64), Storage::jpeg(64)], [30, 20], true);
}

#[test]
#[ignore = "open question: single stars over a black ground, all six turned or flipped, come back in another arrangement"]
fn the_whole_table_of_the_night() {
    run_on(&[Storage::png(64), Storage::jpeg(64)], [30, 20], true, |name| name == "night");
}

#[test]
#[ignore = "whole table: many minutes at full size"]
fn the_whole_table_of_large_maps() {
    run(&[Storage::png(2048), Storage::jpeg(2048)], [4, 3], true);
}
