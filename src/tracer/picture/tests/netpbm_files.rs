//! PBM, PGM, PPM and PFM files.

use std::path::Path;

use super::pictures::{bytes_of, colours_of};
use crate::math::Vec3;
use crate::picture::{Format, decode, read_header};

fn bytes(file: &[u8]) -> Vec<u8> {
    let picture = decode(file, Path::new("a.ppm")).unwrap();
    assert_eq!(read_header(file, Path::new("a.ppm")).unwrap(), picture.header());
    assert_eq!(picture.header().format, Format::Ppm);
    bytes_of(&picture).to_vec()
}

#[test]
fn every_kind_is_read() {
    assert_eq!(bytes(b"P3\n# a comment\n2 1 255\n1 2 3  4 5 6\n"), [1, 2, 3, 4, 5, 6]);
    assert_eq!(bytes(b"P3 1 1 # white is\n15\n15 0 5"), [255, 0, 85]);
    assert_eq!(bytes(b"P6\n1 2\n255\n\x01\x02\x03\x04\x05\x06"), [1, 2, 3, 4, 5, 6]);
    assert_eq!(bytes(b"P2 2 1 255 7 9"), [7, 7, 7, 9, 9, 9]);
    assert_eq!(bytes(b"P5 2 1 255 \x07\x09"), [7, 7, 7, 9, 9, 9]);
    assert_eq!(bytes(b"P1 3 1\n011"), [255, 255, 255, 0, 0, 0, 0, 0, 0]);
    assert_eq!(bytes(b"P4 3 1\n\x60"), [255, 255, 255, 0, 0, 0, 0, 0, 0]);
    let wide = decode(b"P6 1 1 65535\n\xFF\xFF\x00\x00\x00\x00", Path::new("a")).unwrap();
    assert_eq!((colours_of(&wide), wide.header().bit_depth), (&[Vec3::X][..], 16));
}

#[test]
fn floats_are_light_from_the_bottom_up() {
    for (scale, order) in [("-1", f32::to_le_bytes as fn(f32) -> [u8; 4]), ("2.0", f32::to_be_bytes)] {
        let numbers = (1..=6).flat_map(|number| order(number as f32 / 2.0));
        let file: Vec<u8> = format!("PF\n1 2\n{scale}\n").into_bytes().into_iter().chain(numbers).collect();
        let picture = decode(&file, Path::new("a.pfm")).unwrap();
        assert_eq!(colours_of(&picture), [Vec3::new(2.0, 2.5, 3.0), Vec3::new(0.5, 1.0, 1.5)]);
    }
}

#[test]
fn what_is_wrong_is_named() {
    let problem = |file: &[u8]| decode(file, Path::new("a.ppm")).unwrap_err().problem().to_owned();
    assert!(problem(b"P3 2 2 255 1 2 3").contains("3 numbers of 12"));
    assert!(problem(b"P3 1 1 255 1 2 x").contains("number 3 is \"x\""));
    assert!(problem(b"P3 1 1 100 1 2 200").contains("200"));
    assert!(problem(b"P6 1 1 255\n\x01").contains("1 numbers of 3"));
    assert!(problem(b"P6 0 1 255\n").contains("0 x 1"));
    assert!(problem(b"P3 x 1 255\n").contains("width"));
    assert!(problem(b"P6 60000 60000 255\n").contains("60000 x 60000"));
    assert!(problem(b"PF 1 1 0\n").contains("white 0"));
}
