//! A table of formats and kinds: every kind of file is read right, or refused with a reason.
//!
//! The kinds are those of the BMP suite, PngSuite, the OpenEXR images and libtiff's test pictures; the files are made here.

#[path = "support/picture_files/mod.rs"]
mod picture_files;

use std::fmt::Write;
use std::path::Path;

use picture_files::{HEIGHT, Kind, Right, WIDTH, bmp, exr, png, sample, tga, tiff, webp};
use skycube::colour::encode_srgb;
use skycube::error::Result;
use skycube::math::Vec3;
use skycube::picture::{OutputFormat, Picture, Raster, WriteOptions, decode, encode};

fn tables() -> [(&'static str, Vec<Kind>); 5] {
    [
        ("a.bmp", bmp::kinds()),
        ("a.png", png::kinds()),
        ("a.tga", tga::kinds()),
        ("a.tif", tiff::kinds()),
        ("a.exr", exr::kinds()),
    ]
}

/// What is wrong with how a kind is read; `None` if it is right, or refused.
fn fault(kind: &Kind, found: Result<Picture>) -> Option<String> {
    let (expected, allowed, difference): (_, _, fn(f32, f32) -> f32) = match &kind.right {
        Right::Refused => return found.is_ok().then(|| "read instead of refused".to_owned()),
        Right::Codes(codes, allowed) => (codes, allowed, |found, code| (255.0 * encode_srgb(found) - code).abs()),
        Right::Light(light, allowed) => (light, allowed, |found, light| (found - light).abs() / light.abs().max(1e-3)),
    };
    let raster = found.ok()?.to_raster();
    if raster.pixels().len() != expected.len() {
        return Some(format!("{} pixels", raster.pixels().len()));
    }
    let differs = |(found, expected): (&Vec3, &[f32; 3])| {
        (0..3).any(|channel| difference(found[channel], expected[channel]) > *allowed)
    };
    let wrong = raster.pixels().iter().zip(expected).position(differs)?;
    let codes = raster.pixels()[wrong].to_array().map(|channel| 255.0 * encode_srgb(channel));
    Some(format!("pixel {wrong} is {} (codes {codes:.2?}) instead of {:?}", raster.pixels()[wrong], expected[wrong]))
}

#[test]
fn every_kind_is_right_or_refused() {
    let (mut table, mut faults) = (String::new(), Vec::new());
    for (name, kinds) in &tables() {
        writeln!(table, "{name}: {} kinds, all right but these, which are refused:", kinds.len()).unwrap();
        for kind in kinds {
            let found = decode(&kind.file, Path::new(name));
            if let Err(error) = &found {
                writeln!(table, "  {}: {}", kind.name, error.problem()).unwrap();
            }
            faults.extend(fault(kind, found).map(|fault| format!("{name}: {}: {fault}", kind.name)));
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    insta::assert_snapshot!(table);
}

/// A file cut off anywhere is an error, unless what is missing is no part of the picture: a footer, a checksum, a tag.
#[test]
fn no_truncated_file_shows_another_picture() {
    let mut files: Vec<(&str, String, Vec<u8>)> = Vec::new();
    for (name, kinds) in tables() {
        // Of many similar kinds some; the prime number meets them in all combinations.
        files.extend(kinds.into_iter().step_by(7).map(|kind| (name, kind.name, kind.file)));
    }
    files.extend(webp::files().into_iter().map(|file| ("a.webp", "lossless".to_owned(), file)));
    let raster =
        Raster::from_function(WIDTH, HEIGHT, |x, y| Vec3::new(sample(x, y, 0, 8) as f32 / 255.0, 0.5, y as f32));
    for format in [OutputFormat::Png, OutputFormat::Hdr, OutputFormat::Exr, OutputFormat::Jpeg] {
        let name = if format == OutputFormat::Jpeg { "a.jpg" } else { "a" };
        files.push((name, format!("{format:?}"), encode(&raster, format, &WriteOptions::default()).unwrap()));
    }
    for (kind, white) in
        [("P1", ""), ("P2", "9"), ("P3", "9"), ("P4", ""), ("P5", "255"), ("P6", "999"), ("PF", "1"), ("Pf", "-1")]
    {
        let text = matches!(kind, "P1" | "P2" | "P3");
        let pixels = if text { b"1 0 1 ".repeat(6) } else { vec![b'A'; 72] };
        files.push(("a.ppm", kind.to_owned(), [format!("{kind} 3 2 {white}\n").into_bytes(), pixels].concat()));
    }
    let mut faults = Vec::new();
    for (name, kind, file) in &files {
        let Ok(whole) = decode(file, Path::new(name)) else { continue };
        for length in 0..file.len() {
            if decode(&file[..length], Path::new(name)).is_ok_and(|found| found != whole) {
                faults.push(format!("{name}, {kind}: cut to {length} of {} bytes", file.len()));
            }
        }
    }
    assert!(faults.is_empty(), "{} of {} files:\n{}", faults.len(), files.len(), faults.join("\n"));
}
