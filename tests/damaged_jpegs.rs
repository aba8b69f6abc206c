//! JPEG files with damaged data and every marker in place: what is cut off or long out of step is named, and no whole file
//! is.

mod common;

use std::path::{Path, PathBuf};

use common::shared_map;
use skycube::Random;
use skycube::math::Vec3;
use skycube::picture::{OutputFormat, Raster, WriteOptions, decode, encode};

/// How many bytes of the data are damaged, and how.
const DAMAGES: [(&str, usize); 8] = [
    ("cut off", 0),
    ("bytes left out", 10),
    ("bytes left out", 3000),
    ("zeros", 200),
    ("zeros", 2000),
    ("noise", 20),
    ("noise", 200),
    ("bytes inserted", 10),
];

/// A file whose data are damaged at a part of their length.
fn damaged(file: &[u8], (how, bytes): (&str, usize), part: f64, random: &mut Random) -> Vec<u8> {
    let scan = file.windows(2).position(|pair| pair == [0xFF, 0xDA]).unwrap();
    let (start, end) = (scan + 14, file.len() - 2);
    let from = start + ((end - start) as f64 * part) as usize;
    let to = (from + bytes).min(end);
    let mut noise = |count: usize| (0..count).map(|_| random.below(255) as u8).collect::<Vec<_>>();
    let (inside, rest) = match how {
        "cut off" => (Vec::new(), end),
        "bytes left out" => (Vec::new(), to),
        "zeros" => (vec![0; to - from], to),
        "noise" => (noise(to - from), to),
        _ => (noise(bytes), from),
    };
    [&file[..from], &inside, &file[rest..]].concat()
}

/// A landscape in noise, with waves of many lengths, and a smooth one.
fn own() -> Vec<Vec<u8>> {
    let raster = |rough: f32| {
        let random = std::cell::RefCell::new(Random(7));
        Raster::from_function(400, 300, |x, y| {
            let (x, y) = (x as f32, y as f32);
            let grain = rough * random.borrow_mut().unit() as f32;
            let wave = |a: f32, b: f32| 0.4 + 0.25 * (x / a + y / b).sin() + 0.1 * (x * y / (200.0 * a)).cos() + grain;
            Vec3::new(wave(30.0, 110.0), wave(70.0, 20.0), wave(130.0, 50.0))
        })
    };
    [0.0, 0.1, 0.3].map(|rough| encode(&raster(rough), OutputFormat::Jpeg, &WriteOptions::default()).unwrap()).into()
}

fn is_damaged(file: &[u8]) -> bool {
    decode(file, Path::new("a.jpg")).is_err_and(|error| error.is_damage())
}

/// Of so many damages of each kind, those that were not found.
fn missed(files: &[Vec<u8>], parts: usize) -> Vec<(&'static str, usize, usize)> {
    let random = &mut Random(1);
    let of_kind = |damage: (&'static str, usize)| {
        let mut missed = 0;
        for file in files {
            for part in 0..parts {
                let part = 0.05 + 0.9 * part as f64 / parts as f64;
                missed += usize::from(!is_damaged(&damaged(file, damage, part, random)));
            }
        }
        (damage.0, damage.1, missed)
    };
    DAMAGES.map(of_kind).into()
}

#[test]
fn damaged_data_are_found() {
    let files = own();
    assert!(!files.iter().any(|file| is_damaged(file)));
    let missed = missed(&files, 5);
    // The codes fall into step again after a few bytes; where as many blocks come out by chance, nothing tells the damage. What
    // is cut off or a long way out of step is always found.
    let is_large = |size: usize| size == 0 || size >= 2000;
    assert!(
        missed.iter().all(|&(_, size, count)| count == 0 || !is_large(size)),
        "of {} a kind: {missed:?}",
        5 * files.len()
    );
}

/// All pictures of the real maps are whole; a picture of each is damaged.
#[test]
#[ignore = "whole table: a minute"]
fn damaged_data_of_real_maps_are_found() {
    let maps = ["city-upside-down", "clouds-dusk", "meadow", "miramar-quake", "studio-garden"];
    let mut files = Vec::new();
    for map in maps.into_iter().filter_map(shared_map) {
        let mut paths: Vec<PathBuf> = std::fs::read_dir(map).unwrap().flatten().map(|entry| entry.path()).collect();
        paths.retain(|path| path.extension().is_some_and(|extension| extension == "jpg"));
        paths.sort();
        let read = |path: &PathBuf| std::fs::read(path).unwrap();
        paths.iter().for_each(|path| assert!(!is_damaged(&read(path)), "{}", path.display()));
        files.extend(paths.iter().take(2).map(read));
    }
    let missed = missed(&files, 6);
    println!("of {} a kind: {missed:?}", files.len() * 6);
}
