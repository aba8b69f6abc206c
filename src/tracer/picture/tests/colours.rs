//! Files that say what their colours mean, and how they are to be turned.

use std::io::Cursor;
use std::path::Path;

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

use super::pictures::{bytes_of, colours_of};
use crate::colour::decode_srgb8;
use crate::math::Vec3;
use crate::picture::decode;

/// A PNG picture of these pixels, two in a row, with chunks behind its header.
fn png(pixels: &[u8], chunks: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let mut file = Vec::new();
    let rows = pixels.len() as u32 / 6;
    PngEncoder::new(Cursor::new(&mut file)).write_image(pixels, 2, rows, ExtendedColorType::Rgb8).unwrap();
    let inserted: Vec<u8> = chunks.iter().flat_map(|(kind, data)| chunk(kind, data)).collect();
    file.splice(33..33, inserted);
    file
}

fn chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let body = [kind.as_slice(), data].concat();
    [&(data.len() as u32).to_be_bytes()[..], &body, &crc32(&body).to_be_bytes()].concat()
}

fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { 0xEDB8_8320 ^ (crc >> 1) } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

fn numbers(numbers: &[u32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_be_bytes()).collect()
}

const PIXELS: [u8; 6] = [200, 100, 50, 255, 0, 0];

fn colours(chunks: &[(&[u8; 4], &[u8])]) -> Vec<Vec3> {
    decode(&png(&PIXELS, chunks), Path::new("a.png")).unwrap().to_raster().pixels().to_vec()
}

fn near(found: &[Vec3], expected: &[Vec3]) {
    assert!(found.iter().zip(expected).all(|(a, b)| (*a - *b).abs().max_element() < 2e-3), "{found:?} {expected:?}");
}

#[test]
fn gamma_and_primaries_of_png() {
    let usual = [decode_srgb8([200, 100, 50]), Vec3::X];
    assert_eq!(colours(&[]), usual);
    assert_eq!(colours(&[(b"gAMA", &numbers(&[45455]))]), usual);
    let power = |code: u8, exponent: f32| (f32::from(code) / 255.0).powf(exponent);
    let of_gamma = |exponent: f32| [Vec3::from([200, 100, 50].map(|code| power(code, exponent))), Vec3::X];
    near(&colours(&[(b"gAMA", &numbers(&[100_000]))]), &of_gamma(1.0));
    near(&colours(&[(b"gAMA", &numbers(&[55_556]))]), &of_gamma(1.8));
    // `sRGB` overrides it.
    assert_eq!(colours(&[(b"sRGB", &[0]), (b"gAMA", &numbers(&[100_000]))]), usual);
    // White, red, green, blue of Display P3: its red is more than the red of a screen, its white is white.
    let p3 = numbers(&[31_270, 32_900, 68_000, 32_000, 26_500, 69_000, 15_000, 6_000]);
    let found = colours(&[(b"cHRM", &p3)]);
    let plain = decode_srgb8([200, 100, 50]);
    let expected = Vec3::new(
        1.2249 * plain.x - 0.2249 * plain.y,
        -0.0420 * plain.x + 1.0420 * plain.y,
        -0.0196 * plain.x - 0.0786 * plain.y + 1.0983 * plain.z,
    );
    near(&found, &[expected.max(Vec3::ZERO), Vec3::X]);
    near(&colours(&[(b"cICP", &[12, 13, 0, 1])]), &found);
}

#[test]
fn exposure_and_primaries_of_hdr() {
    let file = |header: &str| {
        let mut file = format!("#?RADIANCE\n{header}FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n").into_bytes();
        file.extend([128, 64, 32, 129]);
        file
    };
    let read = |header: &str| colours_of(&decode(&file(header), Path::new("a.hdr")).unwrap())[0];
    let plain = Vec3::new(1.0, 0.5, 0.25);
    assert_eq!(read(""), plain);
    assert_eq!(read("EXPOSURE=2\nEXPOSURE= 4.0\n"), plain / 8.0);
    assert_eq!(read("PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.333 0.333\n"), plain);
    let p3 = read("PRIMARIES=0.68 0.32 0.265 0.69 0.15 0.06 0.3127 0.329\n");
    near(&[p3], &[Vec3::new(1.2249 - 0.5 * 0.2249, -0.0420 + 0.5 * 1.0420, -0.0196 - 0.5 * 0.0786 + 0.25 * 1.0983)]);
    let xyz = String::from_utf8_lossy(&file("")).replace("rgbe", "xyze");
    assert!(decode(xyz.as_bytes(), Path::new("a.hdr")).unwrap_err().problem().contains("XYZ"));
}

#[test]
fn the_flag_of_a_camera_turns_the_picture() {
    // EXIF in a PNG chunk: a TIFF directory with the one entry "orientation".
    let exif = |flag: u8| [&b"MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0"[..], &[flag, 0, 0, 0, 0, 0, 0]].concat();
    let pixels: Vec<u8> = (1..=4).flat_map(|number| [number; 3]).collect();
    let seen = |flag: u8| {
        let picture = decode(&png(&pixels, &[(b"eXIf", &exif(flag))]), Path::new("a.png")).unwrap();
        bytes_of(&picture).chunks(3).map(|pixel| pixel[0]).collect::<Vec<_>>()
    };
    assert_eq!([1, 2, 3, 6, 8].map(seen), [[1, 2, 3, 4], [2, 1, 4, 3], [4, 3, 2, 1], [3, 1, 4, 2], [2, 4, 1, 3]]);
}

#[test]
fn bits_from_the_lowest_on_are_refused() {
    let mut file = Cursor::new(Vec::new());
    image::DynamicImage::new_rgb8(4, 4).write_to(&mut file, image::ImageFormat::Tiff).unwrap();
    let mut file = file.into_inner();
    assert!(decode(&file, Path::new("a.tif")).is_ok());
    // An entry that readers pass over (the resolution's unit, 296) becomes the order of bits.
    let tag = |tag: u16| tag.to_le_bytes();
    let entry = file.windows(4).position(|bytes| bytes[..2] == tag(296) && bytes[2..] == tag(3)).unwrap();
    file[entry..entry + 2].copy_from_slice(&tag(266));
    file[entry + 8] = 2;
    assert!(decode(&file, Path::new("a.tif")).unwrap_err().problem().contains("FillOrder 2"));
}
