//! Every format that is written, read back.

use std::path::Path;

use super::pictures::{bytes_of, colours_of, radiant, rgb8_bytes, smooth, srgb8};
use crate::colour::{ToneMap, decode_srgb8};
use crate::math::Vec3;
use crate::picture::{
    OutputFormat, PngDepth, Raster, Samples, WriteOptions, decode, encode, encode_png, read, write, write_png,
};

fn round_trip(raster: &Raster, format: OutputFormat, options: &WriteOptions) -> Raster {
    decode(&encode(raster, format, options).unwrap(), Path::new("memory")).unwrap().to_raster()
}

fn largest_difference(one: &Raster, other: &Raster) -> f32 {
    assert_eq!((one.width(), one.height()), (other.width(), other.height()));
    one.pixels().iter().zip(other.pixels()).map(|(a, b)| (*a - *b).abs().max_element()).fold(0.0, f32::max)
}

#[test]
fn eight_bit_png_keeps_what_came_from_eight_bits() {
    let raster = srgb8(31, 17, rgb8_bytes(31, 17)).to_raster();
    assert_eq!(round_trip(&raster, OutputFormat::Png, &WriteOptions::default()), raster);
}

#[test]
fn sixteen_bit_png_is_within_half_a_code() {
    let options = WriteOptions { png_depth: PngDepth::Sixteen, ..WriteOptions::default() };
    let raster = smooth(31, 17);
    // The curve rises fastest at 1, where a code is 2.4 / 1.055 / 65535 wide.
    let half_a_code = 0.5 * 2.4 / 1.055 / 65535.0;
    assert!(largest_difference(&round_trip(&raster, OutputFormat::Png, &options), &raster) < 1.02 * half_a_code);
}

#[test]
fn jpeg_is_close_and_its_quality_counts() {
    let raster = smooth(64, 48);
    // In linear light, where a code near white is 0.009 wide: at most 13 codes, 4 and 2.
    let sizes = [(30, 0.12), (92, 0.036), (100, 0.018)].map(|(jpeg_quality, tolerance)| {
        let options = WriteOptions { jpeg_quality, ..WriteOptions::default() };
        let difference = largest_difference(&round_trip(&raster, OutputFormat::Jpeg, &options), &raster);
        assert!(difference < tolerance, "quality {jpeg_quality}: {difference}");
        encode(&raster, OutputFormat::Jpeg, &options).unwrap().len()
    });
    assert!(sizes.is_sorted(), "{sizes:?}");
    let options = WriteOptions { jpeg_quality: 0, ..WriteOptions::default() };
    assert!(encode(&raster, OutputFormat::Jpeg, &options).is_err());
}

#[test]
fn exr_keeps_every_bit() {
    let mut raster = radiant(33, 21);
    raster.set(0, 0, Vec3::new(f32::INFINITY, -1.5, f32::MIN_POSITIVE / 8.0));
    assert_eq!(round_trip(&raster, OutputFormat::Exr, &WriteOptions::default()), raster);
}

#[test]
fn hdr_is_within_its_shared_exponent() {
    for raster in [radiant(33, 21), radiant(5, 3)] {
        let read = round_trip(&raster, OutputFormat::Hdr, &WriteOptions::default());
        for (found, expected) in read.pixels().iter().zip(raster.pixels()) {
            // The largest channel has at least 128 steps, so one step is at most its 128th part.
            let step = expected.max_element() / 128.0;
            assert!((*found - *expected).abs().max_element() <= step, "{found} against {expected}");
        }
    }
}

#[test]
fn display_formats_clamp_or_compress_as_told() {
    let raster = Raster::filled(2, 2, Vec3::splat(3.0));
    let clamped = round_trip(&raster, OutputFormat::Png, &WriteOptions::default());
    assert_eq!(clamped.pixel(0, 0), Vec3::ONE);
    let options = WriteOptions { tone_map: ToneMap::Reinhard, ..WriteOptions::default() };
    let compressed = round_trip(&raster, OutputFormat::Png, &options).pixel(0, 0);
    assert!((compressed - Vec3::splat(0.75)).abs().max_element() < 0.005, "{compressed}");
    let not_a_number = Raster::filled(1, 1, Vec3::new(f32::NAN, -1.0, f32::INFINITY));
    let found = round_trip(&not_a_number, OutputFormat::Png, &WriteOptions::default()).pixel(0, 0);
    assert_eq!(found, Vec3::new(0.0, 0.0, 1.0));
}

#[test]
fn written_files_are_found_where_they_belong() {
    let folder = tempfile::tempdir().unwrap();
    let raster = smooth(8, 8);
    for name in ["a.png", "b.JPG", "c.jpeg", "d.hdr", "e.Exr"] {
        let path = folder.path().join(name);
        write(&raster, &path, &WriteOptions::default()).unwrap();
        assert!(largest_difference(&read(&path).unwrap().to_raster(), &raster) < 0.06, "{name}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 5);
}

#[test]
fn targets_that_cannot_be_written_are_refused() {
    let raster = smooth(2, 2);
    let refused = |path: &str| write(&raster, Path::new(path), &WriteOptions::default()).unwrap_err();
    insta::assert_snapshot!(refused("picture.gif"), @r"
    picture.gif: cannot write a picture with the extension .gif
      expected: .png, .jpg, .jpeg, .hdr or .exr
    ");
    insta::assert_snapshot!(refused("picture"), @r"
    picture: the name has no extension that tells the picture format
      expected: .png, .jpg, .jpeg, .hdr or .exr
    ");
    insta::assert_snapshot!(refused("no/such/folder/picture.png"), @r"
    no/such/folder/picture.png: cannot write: the folder no/such/folder does not exist
      help: create it, or choose another place
    ");
}

#[test]
fn raw_samples_become_png_without_loss() {
    let bytes = rgb8_bytes(9, 4);
    let picture = decode(&encode_png(9, 4, Samples::Rgb8(&bytes)).unwrap(), Path::new("a")).unwrap();
    assert_eq!(bytes_of(&picture), bytes);

    let picture =
        decode(&encode_png(1, 2, Samples::Rgba8(&[1, 2, 3, 0, 5, 6, 7, 99])).unwrap(), Path::new("a")).unwrap();
    assert_eq!((bytes_of(&picture), picture.header().alpha), ([1, 2, 3, 5, 6, 7].as_slice(), true));

    let picture = decode(&encode_png(1, 1, Samples::Rgb16(&[257, 514, 65535])).unwrap(), Path::new("a")).unwrap();
    assert_eq!(colours_of(&picture), [decode_srgb8([1, 2, 255])]);

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("raw.png");
    write_png(&path, 9, 4, Samples::Rgb8(&bytes)).unwrap();
    assert_eq!(bytes_of(&read(&path).unwrap()), bytes);
    assert!(write_png(&path, 9, 5, Samples::Rgb8(&bytes)).is_err());
}
