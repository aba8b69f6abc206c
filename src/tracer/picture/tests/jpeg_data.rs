//! JPEG files whose data are damaged, with every marker in place.

use std::path::Path;

use crate::math::Vec3;
use crate::picture::{OutputFormat, Raster, WriteOptions, decode, encode};

/// Waves of many lengths, so that no block is like another.
fn rough(width: usize, height: usize) -> Raster {
    Raster::from_function(width, height, |x, y| {
        let (x, y) = (x as f32, y as f32);
        let wave = |a: f32, b: f32| 0.5 + 0.25 * (x / a + y / b).sin() + 0.2 * (x * y / (20.0 * a)).cos();
        Vec3::new(wave(3.0, 11.0), wave(7.0, 2.0), wave(13.0, 5.0))
    })
}

/// Whole files: by our own encoder, progressive with subsampled colours, and with restart markers.
fn files() -> [Vec<u8>; 3] {
    [
        encode(&rough(120, 90), OutputFormat::Jpeg, &WriteOptions::default()).unwrap(),
        include_bytes!("fixtures/progressive.jpg").to_vec(),
        include_bytes!("fixtures/restarts.jpg").to_vec(),
    ]
}

/// Where the data of the first scan begin.
fn data_start(file: &[u8]) -> usize {
    let scan = file.windows(2).position(|pair| pair == [0xFF, 0xDA]).unwrap();
    scan + 2 + usize::from(u16::from_be_bytes([file[scan + 2], file[scan + 3]]))
}

fn problem(file: &[u8]) -> Option<String> {
    decode(file, Path::new("posx.jpg")).err().map(|error| error.to_string())
}

#[test]
fn whole_files_are_whole() {
    for file in files() {
        assert_eq!(problem(&file), None);
        // Bytes between the data and the end marker are some writers' way.
        let end = file.len() - 2;
        assert_eq!(problem(&[&file[..end], &[0; 8], &file[end..]].concat()), None);
    }
}

#[test]
fn data_that_end_early_are_named() {
    for file in files() {
        let start = data_start(&file);
        for part in 1..10 {
            let end = start + (file.len() - 2 - start) * part / 10;
            let problem = problem(&[&file[..end], &[0xFF, 0xD9]].concat()).expect("the end is missing");
            assert!(problem.starts_with("posx.jpg: this JPEG picture cannot be decoded: "), "{problem}");
        }
    }
}

#[test]
fn holes_are_named() {
    let [own, ..] = files();
    let start = data_start(&own);
    let length = own.len() - 2 - start;
    for part in 1..20 {
        let from = start + length * part / 25;
        let to = from + length / 8;
        assert!(problem(&[&own[..from], &own[to..]].concat()).is_some(), "cut from {from} to {to}");
        // Other bytes are codes, too, but would have to be exactly as many blocks as were there.
        for filling in [0, 0x55, 0xAA, 0xFE] {
            let hole = [&own[..from], &vec![filling; to - from], &own[to..]].concat();
            assert!(problem(&hole).is_some(), "{filling} from {from} to {to}");
        }
    }
}
