//! Right maps stay right, and damaged ones are recovered: orientations wrong face by face, on all faces, with images that
//! changed places; as PNG and as JPEG of quality 50; small and large.
//!
//! `cargo test --release --test validator damage_and_recover -- --ignored --nocapture` prints the whole table.

use super::pictures::{self, Storage};
use super::recovery::{Damage, Outcome, Recovery, Tally};
use skycube::envmap::Face;
use skycube::validate::{Check, Names, Seam, Verdict};

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
    let mut failures = 0;
    for (name, original) in pictures::right_maps() {
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

/// From here on the report calls a seam rough.
const ROUGH: f64 = 3.0;

/// The mean score of the four seams of a face.
fn roughness(seams: &[Seam], face: Face) -> f64 {
    seams.iter().filter(|seam| seam.edge.touches(face)).map(|seam| seam.score).sum::<f64>() / 4.0
}

/// Each face in each wrong orientation, in a map of 64 texels at JPEG quality 50: what is not recovered, by the face, with the
/// check of the damaged map.
fn not_recovered(name: &str, original: &pictures::Map) -> Vec<(Outcome, Face, Check)> {
    let map = original.stored(&Storage::jpeg(64));
    let recovery = Recovery::of(&map, Names::Trusted);
    let damages = Damage::of_one_face();
    let outcomes = recovery.outcomes(&damages);
    let others = damages.iter().zip(outcomes).zip(0..).filter(|((_, outcome), _)| *outcome != Outcome::Recovered);
    others
        .map(|((damage, outcome), number)| {
            let (face, check) =
                (Face::ALL[number / 7], map.damaged(&damage.images, &damage.orientations).check(Names::Trusted));
            println!("{name}: {outcome:?}, {} in {:?}", face.name(), damage.orientations[face.index()].formulas());
            (outcome, face, check)
        })
        .collect()
}

#[test]
fn compressed_maps_of_64_texels_are_recovered_face_by_face() {
    // Mirrored about the horizon; a chart of which only the background reaches the borders; single stars over a black ground;
    // a plain sky over a plain beach; and the open question below.
    let partly = ["clouds-dusk", "openexr/OrientationCube.exr", "night", "seaside", "city-upside-down"];
    for (name, original) in pictures::right_maps() {
        for (outcome, face, check) in not_recovered(name, original) {
            let what = format!("{name}, {}: {outcome:?}, {:?}", face.name(), check.verdict);
            assert!(partly.contains(name), "{what}");
            // Flipped left-right, two faces of the seaside fit noticeably but not decisively worse, though the right map decides
            // them: there the cheapest arrangement with such a face is tried, in which others change, too.
            assert!(outcome == Outcome::Tied || outcome == Outcome::Undecided && *name == "seaside", "{what}");
            // What is left as it is, is unseen; or it is called undecidable, and hardly seen.
            let [before, after] = [&check.seams, &check.fix.seams_after].map(|seams| roughness(seams, face));
            match check.verdict {
                Verdict::Undecidable => assert!(before < 2.0 * ROUGH, "{what}: {before}"),
                _ => assert!(after < ROUGH && outcome == Outcome::Tied, "{what}: {after}"),
            }
        }
    }
}

#[test]
#[ignore = "open question: a street flipped top-bottom is tied after strong compression, for no reason that the eye can see"]
fn open_question_a_compressed_street_flipped_top_bottom_is_recovered() {
    for (name, original) in pictures::right_maps().iter().filter(|(name, _)| *name == "city-upside-down") {
        assert!(not_recovered(name, original).is_empty());
    }
}

#[test]
#[ignore = "whole table: minutes"]
fn png_and_jpeg_whole_table() {
    run(&[Storage::png(64), Storage::jpeg(64)], [30, 20], true);
}

#[test]
#[ignore = "whole table: many minutes at full size"]
fn large_maps_whole_table() {
    run(&[Storage::png(2048), Storage::jpeg(2048)], [4, 3], true);
}
