//! Encoding of a raster as a file.

use std::path::Path;

use image::codecs::hdr::HdrEncoder;
use image::codecs::jpeg::JpegEncoder;
use image::{ExtendedColorType, ImageError};

use super::remark::with_remark;
use super::{OutputFormat, PngDepth, Raster, Samples, check_target, encode_png, openexr, write_atomically};
use crate::colour::{Encoding, ToneMap};
use crate::error::{Error, Result};
use crate::math::Vec3;
use crate::parallel;

/// What the 8- and 16-bit formats need to know. OpenEXR and HDR hold the linear radiance and ask for nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WriteOptions {
    pub tone_map: ToneMap,
    pub encoding: Encoding,
    pub png_depth: PngDepth,
    /// From 1 (small) to 100 (good).
    pub jpeg_quality: u8,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self {
            tone_map: ToneMap::default(),
            encoding: Encoding::default(),
            png_depth: PngDepth::default(),
            jpeg_quality: 92,
        }
    }
}

/// What a file may hold beside the picture.
#[derive(Debug, Clone, Copy, Default)]
pub struct Extras<'a> {
    /// Only OpenEXR files can hold layers.
    pub layers: &'a [SideLayer<'a>],
    /// A remark for those who look at the file's properties, in ASCII.
    pub remark: Option<&'a str>,
}

/// A raster that lies beside the picture in the same file.
#[derive(Debug, Clone, Copy)]
pub struct SideLayer<'a> {
    pub name: &'a str,
    /// Names of the components that are written, such as `["X", "Y", "Z"]`; one to three.
    pub channels: &'a [&'a str],
    pub raster: &'a Raster,
}

/// Writes a raster as the file format that the extension of `path` names. The file is there whole or not at all.
pub fn write(raster: &Raster, path: &Path, options: &WriteOptions) -> Result<()> {
    write_with(raster, path, options, Extras::default())
}

/// Writes a raster and what belongs to it. An error if there are layers and the format cannot hold them.
pub fn write_with(raster: &Raster, path: &Path, options: &WriteOptions, extras: Extras) -> Result<()> {
    let format = OutputFormat::of_path(path)?;
    check_target(path)?;
    if format != OutputFormat::Exr && !extras.layers.is_empty() {
        return Err(Error::new("this format holds no layers").in_file(path).expected("the extension .exr"));
    }
    let encoded = match format {
        OutputFormat::Exr => openexr::encode(raster, extras.layers, extras.remark),
        _ => encode(raster, format, options),
    };
    let encoded = encoded.map_err(|error| error.in_file(path))?;
    let remarked = match extras.remark {
        Some(remark) => with_remark(encoded, format, remark),
        None => encoded,
    };
    write_atomically(path, &remarked)
}

/// The bytes of a file that holds the raster.
pub fn encode(raster: &Raster, format: OutputFormat, options: &WriteOptions) -> Result<Vec<u8>> {
    let (width, height) = (raster.width(), raster.height());
    if width == 0 || height == 0 {
        return Err(Error::new(format!("the picture is empty ({width} x {height})")));
    }
    match (format, options.png_depth) {
        (OutputFormat::Png, PngDepth::Eight) => encode_png(width, height, Samples::Rgb8(&bytes(raster, options))),
        (OutputFormat::Png, PngDepth::Sixteen) => {
            let numbers = quantised(raster, options, 65535.0, |value| value as u16);
            encode_png(width, height, Samples::Rgb16(&numbers))
        }
        (OutputFormat::Jpeg, _) => encode_jpeg(raster, options),
        (OutputFormat::Hdr, _) => encode_hdr(raster),
        (OutputFormat::Exr, _) => openexr::encode(raster, &[], None),
    }
}

/// The display colours as whole numbers from 0 to `largest`, rounded to nearest.
fn quantised<T: Send + Clone>(
    raster: &Raster,
    options: &WriteOptions,
    largest: f32,
    number: impl Fn(f32) -> T + Sync,
) -> Vec<T> {
    let display = |&colour: &Vec3| options.tone_map.display_as(colour, options.encoding).to_array();
    let numbers = |colour| display(colour).map(|value| number((value * largest).round()));
    let parts =
        parallel::map(raster.pixels().chunks(4096), |pixels| pixels.iter().flat_map(&numbers).collect::<Vec<T>>());
    parts.concat()
}

fn bytes(raster: &Raster, options: &WriteOptions) -> Vec<u8> {
    quantised(raster, options, 255.0, |value| value as u8)
}

fn encode_jpeg(raster: &Raster, options: &WriteOptions) -> Result<Vec<u8>> {
    let (Ok(width), Ok(height)) = (u16::try_from(raster.width()), u16::try_from(raster.height())) else {
        return Err(Error::new(format!("{} x {} is too large for JPEG", raster.width(), raster.height()))
            .expected("at most 65535 x 65535")
            .help("write it as .png or .exr"));
    };
    if !(1..=100).contains(&options.jpeg_quality) {
        return Err(Error::new(format!("JPEG quality {}", options.jpeg_quality)).expected("from 1 to 100"));
    }
    let mut encoded = Vec::new();
    JpegEncoder::new_with_quality(&mut encoded, options.jpeg_quality)
        .encode(&bytes(raster, options), u32::from(width), u32::from(height), ExtendedColorType::Rgb8)
        .map_err(|error| cannot_encode("JPEG", &error))?;
    Ok(encoded)
}

fn encode_hdr(raster: &Raster) -> Result<Vec<u8>> {
    let pixels: Vec<image::Rgb<f32>> = raster.pixels().iter().map(|colour| image::Rgb(colour.to_array())).collect();
    let mut encoded = Vec::new();
    HdrEncoder::new(&mut encoded)
        .encode(&pixels, raster.width(), raster.height())
        .map_err(|error| cannot_encode("HDR", &error))?;
    Ok(encoded)
}

fn cannot_encode(format: &str, error: &ImageError) -> Error {
    Error::new(format!("cannot encode as {format}: {error}"))
}
