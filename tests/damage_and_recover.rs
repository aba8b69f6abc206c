//! Right maps stay right, and damaged ones are recovered: laid wrongly face by face, on all faces, with images that
//! changed places; as PNG and as JPEG of quality 50; small and large.
//!
//! `cargo test --release --test damage_and_recover -- --ignored --nocapture` prints the whole table.

mod common;
#[path = "damage/pictures.rs"]
mod pictures;
#[path = "support/random.rs"]
mod random;

use pictures::{Map, Storage};
use random::Random;
use skycube::envmap::{Face, Laying};
use skycube::validate::{Names, Verdict};

/// How a damaged map came back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Recovered,
    /// What is wrong is called undecided.
    Undecided,
    Wrong,
}

/// What was done to a map: per face the image and the laying of that image.
#[derive(Debug, Clone, Copy)]
struct Damage {
    images: [usize; 6],
    layings: [Laying; 6],
}

impl Damage {
    const NONE: Self = Self { images: [0, 1, 2, 3, 4, 5], layings: [Laying::IDENTITY; 6] };

    /// Each of the seven wrong layings on each face.
    fn of_one_face() -> Vec<Self> {
        let wrong = |face: usize| Laying::ALL[1..].iter().map(move |&laying| (face, laying));
        let damage = |(face, laying): (usize, Laying)| {
            let mut damage = Self::NONE;
            damage.layings[face] = laying;
            damage
        };
        (0..6).flat_map(wrong).map(damage).collect()
    }

    fn random_layings(count: usize) -> Vec<Self> {
        let mut random = Random(7);
        (0..count).map(|_| Self { layings: [(); 6].map(|()| Laying::ALL[random.below(8)]), ..Self::NONE }).collect()
    }

    fn swaps(count: usize) -> Vec<Self> {
        let mut random = Random(11);
        let mut swap = || {
            let mut damage = Self::NONE;
            let (one, other) = (random.below(6), random.below(5));
            damage.images.swap(one, if other >= one { other + 1 } else { other });
            damage
        };
        (0..count).map(|_| swap()).collect()
    }
}

/// Damages a map, checks it and says whether the fix undoes the damage.
fn try_out(map: &Map, damage: &Damage, names: Names) -> Outcome {
    let damaged = map.damaged(&damage.images, &damage.layings);
    let check = damaged.check(names);
    assert_undecided_are_left_alone(&check);
    let mut seen_undecided = false;
    for face in check.fix.faces {
        // What the face shows after the fix: which original image, laid how.
        let source = damage.images[face.image.index()];
        let laying = damage.layings[face.image.index()].after(face.laying);
        let right = map.looks_alike(source, laying, face.face.index());
        if !right && face.decided {
            return equivalent_or_wrong(map, damage, &check, names);
        }
        seen_undecided |= !right;
    }
    if seen_undecided { Outcome::Undecided } else { Outcome::Recovered }
}

/// A guess is no fix: a face that is not decided keeps its laying, but where a convention explains all six.
fn assert_undecided_are_left_alone(check: &skycube::validate::Check) {
    for fix in check.fix.faces.iter().filter(|fix| !fix.decided && check.fix.convention.is_none()) {
        let kept = fix.laying == Laying::IDENTITY;
        let moved = fix.image != check.lookup.row(fix.face).image;
        assert!(kept || moved, "{} is undecided and changed: {:?}", fix.face.name(), check.fix);
    }
}

/// With images that change places the original may come back turned or mirrored as a whole: then its seams are those of
/// the original, pair by pair.
fn equivalent_or_wrong(map: &Map, damage: &Damage, check: &skycube::validate::Check, names: Names) -> Outcome {
    if names == Names::Trusted && damage.images == Damage::NONE.images {
        return Outcome::Wrong;
    }
    let images = check.fix.faces.map(|face| damage.images[face.image.index()]);
    let layings = check.fix.faces.map(|face| damage.layings[face.image.index()].after(face.laying));
    let fixed = map.damaged(&images, &layings);
    // The steps at the twelve seams of an equivalent map are those of the original in another order.
    let steps = |map: &Map| {
        let mut steps: Vec<i64> =
            map.check(Names::Trusted).seams.iter().map(|seam| (seam.step * 1e6).round() as i64).collect();
        steps.sort_unstable();
        steps
    };
    if steps(&fixed) == steps(map) {
        return Outcome::Recovered;
    }
    // Where undecided faces lie otherwise the rest must still be equal: all broken seams are at such faces.
    let undecided: Vec<Face> = check.fix.faces.iter().filter(|face| !face.decided).map(|face| face.face).collect();
    let rest = |map: &Map, without: &[Face]| {
        let seams = map.check(Names::Trusted).seams;
        let kept = seams.iter().filter(|seam| !without.iter().any(|&face| seam.edge.touches(face)));
        kept.map(|seam| (seam.step * 1e6).round() as i64).collect::<Vec<_>>()
    };
    let original = rest(map, &[]);
    let alike = !undecided.is_empty() && rest(&fixed, &undecided).iter().all(|step| original.contains(step));
    if alike { Outcome::Undecided } else { Outcome::Wrong }
}

/// Counts of one row of the table.
#[derive(Debug, Default)]
struct Tally {
    recovered: usize,
    undecided: usize,
    wrong: Vec<String>,
}

fn tally(map: &Map, damages: &[Damage], names: Names) -> Tally {
    let mut tally = Tally::default();
    for damage in damages {
        match try_out(map, damage, names) {
            Outcome::Recovered => tally.recovered += 1,
            Outcome::Undecided => tally.undecided += 1,
            Outcome::Wrong => tally.wrong.push(format!("{damage:?}")),
        }
    }
    tally
}

fn table_row(name: &str, kind: &str, storage: &Storage, tally: &Tally) {
    println!(
        "{name:28} {kind:18} {:10} {:5} {:4} recovered {:3} undecided {:3} wrong",
        storage.name(),
        storage.size,
        tally.recovered,
        tally.undecided,
        tally.wrong.len()
    );
    for wrong in &tally.wrong {
        println!("    wrong: {wrong}");
    }
}

fn run(storages: &[Storage], counts: [usize; 2]) {
    let mut failures = 0;
    for (name, original) in pictures::right_maps() {
        for storage in storages {
            let map = original.stored(storage);
            let verdict = map.check(Names::Auto).verdict;
            if verdict == Verdict::Broken {
                println!("{name} {} {}: the right map is called broken", storage.name(), storage.size);
                failures += 1;
            }
            let kinds = [
                ("one face", Damage::of_one_face(), Names::Trusted),
                ("one face, any", Damage::of_one_face(), Names::Auto),
                ("all faces", Damage::random_layings(counts[0]), Names::Trusted),
                ("all faces, any", Damage::random_layings(counts[0]), Names::Auto),
                ("two swapped", Damage::swaps(counts[1]), Names::Auto),
            ];
            for (kind, damages, names) in kinds {
                let tally = tally(&map, &damages, names);
                table_row(&format!("{name} {}", verdict.name()), kind, storage, &tally);
                failures += tally.wrong.len();
            }
        }
    }
    assert_eq!(failures, 0);
}

#[test]
fn small_maps_are_recovered() {
    run(&[Storage::png(64)], [4, 4]);
}

#[test]
fn compressed_maps_of_64_texels_are_recovered_face_by_face() {
    for (name, original) in pictures::right_maps() {
        let map = original.stored(&Storage::jpeg(64));
        let tally = tally(&map, &Damage::of_one_face(), Names::Trusted);
        assert!(tally.wrong.is_empty(), "{name}: {:?}", tally.wrong);
        // One is the mirror image of itself about the horizon, of the other only the chart's background reaches the borders.
        if !["clouds-dusk", "openexr/OrientationCube.exr"].contains(&name) {
            assert_eq!((tally.recovered, tally.undecided), (42, 0), "{name}");
        }
    }
}

#[test]
#[ignore = "minutes: the whole table"]
fn the_whole_table() {
    run(&[Storage::png(64), Storage::jpeg(64)], [30, 20]);
    run(&[Storage::png(2048), Storage::jpeg(2048)], [8, 6]);
}
