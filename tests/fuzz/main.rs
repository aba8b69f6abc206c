//! Damaged input of every kind: whatever the bytes are, a loader gives an answer or an error, soon, and in bounded memory.
//!
//! A plain harness that runs everywhere: seeds made here, changed at random, a moment for each target. `SKYCUBE_FUZZ_SECONDS`
//! makes it longer, and `SKYCUBE_FUZZ_ROUND` takes other changes (overflows are checked in test builds). CI takes a minute a
//! target; before a release:
//!
//! ```text
//! SKYCUBE_FUZZ_SECONDS=3600 cargo test --test fuzz -- --nocapture
//! ```

mod allocations;
mod faces;
mod mutation;
#[path = "../support/picture_files/mod.rs"]
mod picture_files;
mod seeds;

use std::path::Path;
use std::time::{Duration, Instant};

use mutation::Mutation;
use skycube::compare::Comparison;
use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Face, LazyImage, Preset, SignedAxis};
use skycube::grade::{Grader, ShotFrame};
use skycube::picture::Picture;
use skycube::render::AxisShot;
use skycube::scene::{Scene, read_lookup_file};
use skycube::shapes::mesh::ObjFile;
use skycube::validate::{CheckOptions, ImageFacts};

/// No input may take longer.
const LONGEST: Duration = Duration::from_secs(5);

/// The time that work takes to compute, where the system says it: on a busy machine anything may take seconds.
fn time_of<T>(work: impl FnOnce() -> T) -> Duration {
    let computed = || {
        let text = std::fs::read_to_string("/proc/self/stat").ok()?;
        let (_, fields) = text.rsplit_once(')')?;
        // By the process and by the system for it, in hundredths of a second.
        let ticks = fields.split_ascii_whitespace().skip(11).take(2).map(|field| field.parse::<u64>());
        Some(Duration::from_millis(10 * ticks.sum::<Result<u64, _>>().ok()?))
    };
    let (started, before) = (Instant::now(), computed());
    work();
    computed().zip(before).map_or_else(|| started.elapsed(), |(now, before)| now - before)
}

/// The most memory that is in use at once while an input is read: so many bytes for each byte that the input has or says it
/// has, and what tables and buffers of codecs take (the `exr` crate: up to 24 MiB for a damaged file).
const MEMORY: (usize, usize) = (16, 32 << 20);

/// Feeds changed seeds to a target until its time is over, and says how many. The target gives the size that the input says it
/// has, in bytes.
fn fuzz(name: &str, seeds: &[Vec<u8>], mut target: impl FnMut(&[u8]) -> usize) {
    let seconds = std::env::var("SKYCUBE_FUZZ_SECONDS").ok().and_then(|text| text.parse().ok()).unwrap_or(0.3);
    let round = std::env::var("SKYCUBE_FUZZ_ROUND").unwrap_or_default();
    let mut mutation = Mutation::new(&format!("{name}{round}"));
    let (started, mut count, mut most) = (Instant::now(), 0u64, 0);
    while started.elapsed().as_secs_f64() < seconds {
        let input = mutation.changed(seeds);
        let begun = Instant::now();
        let run = || allocations::peak_of(|| target(&input));
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run));
        let slow = begun.elapsed() > LONGEST;
        let fault = match outcome {
            Err(_) => Some("panic".to_owned()),
            _ if slow && time_of(|| target(&input)) > LONGEST => Some("too slow".to_owned()),
            Ok((declared, taken)) => {
                most = most.max(taken);
                let allowed = MEMORY.0 * (input.len() + declared) + MEMORY.1;
                (taken > allowed).then(|| format!("{taken} bytes of memory instead of {allowed}"))
            }
        };
        if let Some(fault) = fault {
            let file = std::env::temp_dir().join(format!("skycube-fuzz-{name}{round}-{count}"));
            std::fs::write(&file, &input).unwrap();
            panic!("{name}: {fault} on {}", file.display());
        }
        count += 1;
    }
    println!("{name}: {count} inputs, at most {most} bytes");
}

/// The same for what is read from a file of a name.
fn fuzz_file(name: &str, file: &str, seeds: &[Vec<u8>], mut target: impl FnMut(&Path)) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(file);
    fuzz(name, seeds, |bytes| {
        std::fs::write(&path, bytes).unwrap();
        target(&path);
        0
    });
}

/// Decodes what is not too large for a test, and gives the size that the header says: four floats a pixel.
fn decode(bytes: &[u8], name: &Path) -> usize {
    let header = skycube::picture::read_header(bytes, name);
    let Some(pixels) = header.ok().map(|header| header.width * header.height).filter(|&pixels| pixels < 1 << 20) else {
        return 0;
    };
    let _ = skycube::picture::decode(bytes, name);
    16 * pixels
}

#[test]
fn pictures() {
    for (name, files) in seeds::pictures() {
        fuzz(name, &files, |bytes| decode(bytes, Path::new(name)));
    }
}

#[test]
fn meshes() {
    fuzz_file("obj", "a.obj", &seeds::meshes(), |path| drop(ObjFile::read(path)));
    let folder = tempfile::tempdir().unwrap();
    let object = folder.path().join("a.obj");
    std::fs::write(&object, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n").unwrap();
    let object = ObjFile::read(&object).unwrap();
    fuzz("mtl", &seeds::materials(), |bytes| {
        std::fs::write(folder.path().join("a.mtl"), bytes).unwrap();
        drop(object.materials());
        0
    });
}

#[test]
fn archives() {
    fuzz_file("zip", "a.zip", &[seeds::archive()], |path| drop(Skybox::open(path)));
}

#[test]
fn documents() {
    fuzz("scene", &seeds::scenes(), |bytes| {
        drop(Scene::from_text(&String::from_utf8_lossy(bytes), Path::new("lessons/scene.toml")));
        0
    });
    fuzz_file("lookup", "a.toml", &seeds::lookups(), |path| drop(read_lookup_file(path)));
}

#[test]
fn small_pictures_that_are_compared() {
    let seeds = seeds::of("ppm");
    let expected = skycube::picture::decode(&seeds[0], Path::new("ppm")).unwrap();
    fuzz("compare", &seeds, |bytes| {
        let Ok(mine) = skycube::picture::decode(bytes, Path::new("ppm")) else { return 0 };
        if mine.width() * mine.height() < 1 << 14 {
            drop(Comparison::of(&mine, &expected));
            drop(Comparison::of(&expected, &mine));
        }
        16 * mine.width() * mine.height()
    });
}

fn map_of(pictures: [Picture; 6]) -> CubeMap {
    CubeMap::new(pictures.map(LazyImage::ready), Preset::Course.lookup(), CubeFilter::Nearest)
}

#[test]
fn small_maps_that_are_checked() {
    fuzz("check", &[faces::compass()], |bytes| {
        let pictures = faces::pictures(bytes);
        let facts = Face::ALL.map(|face| {
            let skycube::picture::Header { width, height, format, alpha, .. } = pictures[face.index()].header();
            ImageFacts { face, file: format!("{}.png", face.name()), width, height, format, alpha }
        });
        drop(skycube::validate::check(&map_of(pictures), facts.to_vec(), &CheckOptions::default()));
        0
    });
}

#[test]
fn small_shots_that_are_graded() {
    let frame = |shot: AxisShot| ShotFrame { face: shot.direction, right: shot.right(), up: shot.up };
    let frames = AxisShot::all("+z".parse::<SignedAxis>().unwrap()).map(frame);
    let grader = Grader::new(&map_of(faces::pictures(&faces::compass())), frames).unwrap();
    fuzz("grade", &[faces::compass()], |bytes| {
        drop(grader.grade(&faces::pictures(bytes)));
        0
    });
}
