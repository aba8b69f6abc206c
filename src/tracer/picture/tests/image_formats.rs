//! Files made by the `image` crate, of every format and colour type, read back.

use std::io::Cursor;
use std::path::Path;

use image::{DynamicImage, ImageBuffer, ImageFormat};

use super::pictures::{bytes_of, colours_of, rgb8_bytes};
use crate::colour::{decode_srgb8, decode_srgb16};
use crate::math::Vec3;
use crate::picture::{Format, Header, decode, read_header};

const WIDTH: usize = 7;
const HEIGHT: usize = 5;

fn encoded(image: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, format).unwrap();
    bytes.into_inner()
}

fn rgb8() -> DynamicImage {
    ImageBuffer::from_raw(WIDTH as u32, HEIGHT as u32, rgb8_bytes(WIDTH, HEIGHT)).map(DynamicImage::ImageRgb8).unwrap()
}

fn header(format: Format, bit_depth: u8, alpha: bool) -> Header {
    Header { width: WIDTH, height: HEIGHT, format, bit_depth, alpha }
}

#[test]
fn lossless_rgb_files_keep_every_byte() {
    let files = [
        (ImageFormat::Png, Format::Png),
        (ImageFormat::Tga, Format::Tga),
        (ImageFormat::Bmp, Format::Bmp),
        (ImageFormat::WebP, Format::WebP),
        (ImageFormat::Tiff, Format::Tiff),
    ];
    for (written, expected) in files {
        let file = encoded(&rgb8(), written);
        // The name says nothing, or the wrong thing: the content counts.
        for name in ["picture", if expected == Format::Tga { "picture.TGA" } else { "picture.jpg" }] {
            let picture = decode(&file, Path::new(name)).unwrap();
            assert_eq!(bytes_of(&picture), rgb8_bytes(WIDTH, HEIGHT), "{expected:?}");
            assert_eq!(picture.header(), header(expected, 8, false));
            assert_eq!(read_header(&file, Path::new(name)).unwrap(), picture.header());
        }
    }
}

#[test]
fn jpeg_is_read_within_its_loss() {
    let flat = ImageBuffer::from_pixel(WIDTH as u32, HEIGHT as u32, image::Rgb([200, 100, 50]));
    let picture = decode(&encoded(&DynamicImage::ImageRgb8(flat), ImageFormat::Jpeg), Path::new("a.png")).unwrap();
    assert_eq!(picture.header(), header(Format::Jpeg, 8, false));
    for texel in bytes_of(&picture).chunks_exact(3) {
        let difference = [200, 100, 50].into_iter().zip(texel).map(|(a, &b): (i32, _)| (a - i32::from(b)).abs()).max();
        assert!(difference <= Some(4), "{texel:?}");
    }
}

#[test]
fn grey_and_alpha_become_three_bytes() {
    let bytes = rgb8_bytes(WIDTH, HEIGHT);
    let count = WIDTH * HEIGHT;
    let (width, height) = (WIDTH as u32, HEIGHT as u32);
    let grey: Vec<u8> = bytes[..count].to_vec();
    let expected_grey: Vec<u8> = grey.iter().flat_map(|&code| [code; 3]).collect();
    let grey_alpha: Vec<u8> = grey.iter().enumerate().flat_map(|(index, &code)| [code, (index * 7) as u8]).collect();
    let rgba: Vec<u8> = bytes.chunks_exact(3).flat_map(|texel| [texel[0], texel[1], texel[2], texel[0] / 2]).collect();
    let images = [
        (DynamicImage::ImageLuma8(ImageBuffer::from_raw(width, height, grey).unwrap()), expected_grey.clone(), false),
        (DynamicImage::ImageLumaA8(ImageBuffer::from_raw(width, height, grey_alpha).unwrap()), expected_grey, true),
        (DynamicImage::ImageRgba8(ImageBuffer::from_raw(width, height, rgba).unwrap()), bytes, true),
    ];
    for (image, expected, alpha) in images {
        let picture = decode(&encoded(&image, ImageFormat::Png), Path::new("a.png")).unwrap();
        assert_eq!(bytes_of(&picture), expected);
        assert_eq!(picture.header(), header(Format::Png, 8, alpha));
    }
}

/// A PNG with a palette of four colours and two-bit indices, 4 x 1, put together by hand.
fn palette_png() -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1A\n".to_vec();
    let mut chunk = |kind: &[u8; 4], data: &[u8]| {
        file.extend((data.len() as u32).to_be_bytes());
        let body = [kind.as_slice(), data].concat();
        file.extend(&body);
        file.extend(crc32(&body).to_be_bytes());
    };
    chunk(b"IHDR", &[0, 0, 0, 4, 0, 0, 0, 1, 2, 3, 0, 0, 0]);
    chunk(b"PLTE", &[255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 8, 7]);
    // zlib: one stored block of two bytes, the filter "none" and the indices 3 2 1 0.
    chunk(b"IDAT", &[0x78, 0x01, 1, 2, 0, 0xFD, 0xFF, 0, 0b1110_0100, 0x00, 0xE6, 0x00, 0xE5]);
    chunk(b"IEND", &[]);
    file
}

fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { 0xEDB8_8320 ^ (crc >> 1) } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

#[test]
fn palettes_are_looked_up() {
    let picture = decode(&palette_png(), Path::new("palette.png")).unwrap();
    assert_eq!(bytes_of(&picture), [9, 8, 7, 0, 0, 255, 0, 255, 0, 255, 0, 0]);
    assert_eq!(picture.header(), Header { width: 4, height: 1, format: Format::Png, bit_depth: 8, alpha: false });
}

#[test]
fn sixteen_bits_are_decoded_by_the_srgb_curve() {
    let codes: Vec<u16> = (0..WIDTH * HEIGHT * 4).map(|index| (index * 2741 % 65536) as u16).collect();
    let image: ImageBuffer<image::Rgba<u16>, _> =
        ImageBuffer::from_raw(WIDTH as u32, HEIGHT as u32, codes.clone()).unwrap();
    let rgba = DynamicImage::ImageRgba16(image);
    for format in [ImageFormat::Png, ImageFormat::Tiff] {
        let picture = decode(&encoded(&rgba, format), Path::new("a")).unwrap();
        let expected: Vec<Vec3> = codes
            .chunks_exact(4)
            .map(|texel| Vec3::new(decode_srgb16(texel[0]), decode_srgb16(texel[1]), decode_srgb16(texel[2])))
            .collect();
        assert_eq!(colours_of(&picture), expected);
        assert_eq!((picture.header().bit_depth, picture.header().alpha), (16, true));
    }
    let grey = ImageBuffer::from_raw(1, 1, vec![0x8080_u16]).map(DynamicImage::ImageLuma16).unwrap();
    let picture = decode(&encoded(&grey, ImageFormat::Png), Path::new("a")).unwrap();
    assert_eq!(colours_of(&picture), [decode_srgb8([0x80; 3])]);
}

#[test]
fn float_tiff_is_taken_as_linear() {
    let values: Vec<f32> = (0..WIDTH * HEIGHT * 3).map(|index| index as f32 * 0.37 - 2.0).collect();
    let image =
        ImageBuffer::from_raw(WIDTH as u32, HEIGHT as u32, values.clone()).map(DynamicImage::ImageRgb32F).unwrap();
    let picture = decode(&encoded(&image, ImageFormat::Tiff), Path::new("a.tif")).unwrap();
    let expected: Vec<Vec3> = values.chunks_exact(3).map(Vec3::from_slice).collect();
    assert_eq!(colours_of(&picture), expected);
    assert_eq!(picture.header(), header(Format::Tiff, 32, false));
}

#[test]
fn both_signatures_of_hdr_are_read() {
    for signature in ["#?RADIANCE", "#?RGBE"] {
        let mut file = format!("{signature}\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n").into_bytes();
        file.extend([128, 64, 0, 129, 255, 1, 2, 136]);
        let picture = decode(&file, Path::new("a.hdr")).unwrap();
        // mantissa / 256 * 2^(exponent - 128)
        assert_eq!(colours_of(&picture), [Vec3::new(1.0, 0.5, 0.0), Vec3::new(255.0, 1.0, 2.0)]);
        assert_eq!(picture.header(), Header { width: 2, height: 1, format: Format::Hdr, bit_depth: 8, alpha: false });
    }
}
