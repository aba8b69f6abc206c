//! Damaged input of every kind: whatever the bytes are, a loader gives an answer or an error, and soon.
//!
//! A plain harness that runs everywhere: seeds made here, changed at random, a moment for each target. `SKYCUBE_FUZZ_SECONDS`
//! makes it longer, as before a release (overflows are checked in test builds):
//!
//! ```text
//! SKYCUBE_FUZZ_SECONDS=3600 cargo test --test fuzz -- --nocapture
//! ```

mod mutation;
mod seeds;

use std::path::Path;
use std::time::{Duration, Instant};

use mutation::Mutation;
use skycube::compare::Comparison;
use skycube::envmap::source::Skybox;
use skycube::scene::{Scene, read_lookup_file};
use skycube::shapes::mesh::ObjFile;

/// No input may take longer.
const LONGEST: Duration = Duration::from_secs(5);

/// Feeds changed seeds to a target until its time is over, and says how many.
fn fuzz(name: &str, seeds: &[Vec<u8>], mut target: impl FnMut(&[u8])) {
    let seconds = std::env::var("SKYCUBE_FUZZ_SECONDS").ok().and_then(|text| text.parse().ok()).unwrap_or(0.3);
    let started = Instant::now();
    let mut mutation = Mutation::new(name);
    let mut count = 0u64;
    while started.elapsed().as_secs_f64() < seconds {
        let input = mutation.changed(seeds);
        let begun = Instant::now();
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| target(&input)));
        let slow = begun.elapsed() > LONGEST;
        if outcome.is_err() || slow {
            let file = std::env::temp_dir().join(format!("skycube-fuzz-{name}-{count}"));
            std::fs::write(&file, &input).unwrap();
            panic!("{name}: {} on {}", if slow { "too slow" } else { "panic" }, file.display());
        }
        count += 1;
    }
    println!("{name}: {count} inputs");
}

/// The same for what is read from a file of a name.
fn fuzz_file(name: &str, file: &str, seeds: &[Vec<u8>], mut target: impl FnMut(&Path)) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(file);
    fuzz(name, seeds, |bytes| {
        std::fs::write(&path, bytes).unwrap();
        target(&path);
    });
}

#[test]
fn pictures() {
    for (name, file) in seeds::pictures() {
        fuzz(name, &[file], |bytes| {
            let path = Path::new(name);
            let header = skycube::picture::read_header(bytes, path);
            // A header may claim any size; what it claims is bounded before it is decoded.
            if header.is_ok_and(|header| header.width * header.height < 1 << 20) {
                let _ = skycube::picture::decode(bytes, path);
            }
        });
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
    });
    fuzz_file("lookup", "a.toml", &seeds::lookups(), |path| drop(read_lookup_file(path)));
}

#[test]
fn small_pictures_that_are_compared() {
    let seeds: Vec<Vec<u8>> =
        seeds::pictures().into_iter().filter(|(name, _)| *name == "ppm").map(|(_, file)| file).collect();
    let expected = skycube::picture::decode(&seeds[0], Path::new("ppm")).unwrap();
    fuzz("compare", &seeds, |bytes| {
        let Ok(mine) = skycube::picture::decode(bytes, Path::new("ppm")) else { return };
        if mine.width() * mine.height() < 1 << 14 {
            drop(Comparison::of(&mine, &expected));
            drop(Comparison::of(&expected, &mine));
        }
    });
}
