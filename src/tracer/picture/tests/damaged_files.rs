//! Broken files give an error, or at worst a picture of the size they claim, and never a panic.

use std::io::Cursor;
use std::path::Path;

use image::{DynamicImage, ImageBuffer, ImageFormat};

use super::pictures::{radiant, rgb8_bytes, smooth};
use crate::picture::{Format, OutputFormat, PngDepth, WriteOptions, decode, encode, exr_environment, read_header};

/// One small file of every format, by the name it has on disk.
fn files() -> Vec<(&'static str, Vec<u8>)> {
    let rgb = ImageBuffer::from_raw(24, 20, rgb8_bytes(24, 20)).map(DynamicImage::ImageRgb8).unwrap();
    let made = |format| {
        let mut bytes = Cursor::new(Vec::new());
        rgb.write_to(&mut bytes, format).unwrap();
        bytes.into_inner()
    };
    let options = WriteOptions { png_depth: PngDepth::Sixteen, ..WriteOptions::default() };
    let ours = |format| encode(&radiant(24, 20), format, &options).unwrap();
    vec![
        ("a.jpg", encode(&smooth(40, 30), OutputFormat::Jpeg, &options).unwrap()),
        ("a.png", made(ImageFormat::Png)),
        ("sixteen.png", ours(OutputFormat::Png)),
        ("a.tga", made(ImageFormat::Tga)),
        ("a.bmp", made(ImageFormat::Bmp)),
        ("a.webp", made(ImageFormat::WebP)),
        ("a.tiff", made(ImageFormat::Tiff)),
        ("a.hdr", ours(OutputFormat::Hdr)),
        ("a.exr", ours(OutputFormat::Exr)),
    ]
}

/// Decodes and checks what must hold of any answer.
fn decode_safely(bytes: &[u8], name: &Path) -> bool {
    let header = read_header(bytes, name);
    let _ = exr_environment(bytes);
    match decode(bytes, name) {
        Ok(picture) => {
            assert_eq!(header.as_ref(), Ok(&picture.header()));
            true
        }
        Err(error) => {
            assert!(error.to_string().contains(&name.display().to_string()), "{error}");
            false
        }
    }
}

#[test]
fn a_truncated_file_is_an_error() {
    for (name, file) in files() {
        assert!(decode_safely(&file, Path::new(name)), "{name} is whole");
        // Some formats end with bytes that carry no pixels: a footer, a last checksum.
        let padding = match Format::of_extension(Path::new(name)) {
            Some(Format::Png) => 16,
            Some(Format::WebP) => 1,
            Some(Format::Tga) => 26,
            Some(Format::Tiff) => file.len(),
            _ => 0,
        };
        for length in 0..file.len() {
            let decodes = decode_safely(&file[..length], Path::new(name));
            assert!(!decodes || length + padding >= file.len(), "{name} cut to {length} of {} bytes", file.len());
        }
    }
}

#[test]
fn a_changed_byte_is_survived() {
    for (name, file) in files() {
        // Every byte of the headers, a sample of those behind.
        for position in (0..file.len()).filter(|position| *position < 360 || position % 7 == 0) {
            let mut changed = file.clone();
            changed[position] ^= [0x01, 0x80, 0xFF, 0x10][position % 4];
            decode_safely(&changed, Path::new(name));
        }
    }
}

#[test]
fn an_absurd_size_is_an_error_and_not_an_allocation() {
    let mut png = files()[1].1.clone();
    png[16..24].copy_from_slice(&[0, 0, 0xEA, 0x60, 0, 0, 0xEA, 0x60]);
    let mut tga = files()[3].1.clone();
    tga[12..16].copy_from_slice(&[0x60, 0xEA, 0x60, 0xEA]);
    let hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n".to_vec();
    for (name, file) in [("a.tga", tga), ("a.hdr", hdr)] {
        let error = decode(&file, Path::new(name)).unwrap_err();
        assert!(error.problem().contains("60000 x 60000"), "{error}");
    }
    // The checksum of the header is wrong too: any error will do.
    assert!(decode(&png, Path::new("a.png")).is_err());
}
