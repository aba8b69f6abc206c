//! Encoding of a raster as a file.

use std::path::Path;

use skycube_files::picture::{self as files, with_remark};

use super::{OutputFormat, PngDepth, Raster, Samples, encode_png, write_atomically};
use crate::colour::{Encoding, ToneMap};
use crate::error::{Error, Result};
use crate::math::Vec3;
use crate::parallel;

/// What the 8- and 16-bit formats need to know. OpenEXR and HDR hold the linear radiance and ask for nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WriteOptions {
    /// How radiance above 1 is brought into `[0, 1]`.
    pub tone_map: ToneMap,
    /// The curve applied after that.
    pub encoding: Encoding,
    /// Bits per channel of PNG files.
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
    /// Its name, which comes before the names of its channels in the file.
    pub name: &'a str,
    /// Names of the written components, for instance `["X", "Y", "Z"]`; one to three.
    pub channels: &'a [&'a str],
    /// As large as the picture.
    pub raster: &'a Raster,
}

/// Writes a raster as the file format that the extension of `path` names. The file is there whole or not at all.
pub fn write(raster: &Raster, path: &Path, options: &WriteOptions) -> Result<()> {
    write_with(raster, path, options, Extras::default())
}

/// Writes a raster and what belongs to it.
pub fn write_with(raster: &Raster, path: &Path, options: &WriteOptions, extras: Extras) -> Result<()> {
    let encoded = encode_with(raster, OutputFormat::of_path(path)?, options, extras);
    write_atomically(path, &encoded.map_err(|error| error.in_file(path))?)
}

/// The bytes of a file that holds the raster and what belongs to it. An error if there are layers and the format cannot hold
/// them.
pub fn encode_with(raster: &Raster, format: OutputFormat, options: &WriteOptions, extras: Extras) -> Result<Vec<u8>> {
    if format != OutputFormat::Exr && !extras.layers.is_empty() {
        return Err(Error::new("this format has no layers").expected("OpenEXR"));
    }
    let encoded = match format {
        OutputFormat::Exr => encode_exr(raster, extras.layers, extras.remark)?,
        _ => encode(raster, format, options)?,
    };
    Ok(match extras.remark {
        Some(remark) => with_remark(encoded, format, remark),
        None => encoded,
    })
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
            let display = |colour| options.tone_map.display_as(colour, options.encoding).to_array();
            let numbers = quantised(raster, |colour| display(colour).map(|value| (value * 65535.0).round() as u16));
            encode_png(width, height, Samples::Rgb16(&numbers))
        }
        (OutputFormat::Jpeg, _) => files::encode_jpeg(width, height, &bytes(raster, options), options.jpeg_quality),
        (OutputFormat::Hdr, _) => {
            files::encode_hdr(width, height, raster.pixels().iter().map(|colour| colour.to_array()))
        }
        (OutputFormat::Exr, _) => encode_exr(raster, &[], None),
    }
}

/// The numbers that the colours become, one after the other.
fn quantised<T: Send + Clone>(raster: &Raster, numbers: impl Fn(Vec3) -> [T; 3] + Sync) -> Vec<T> {
    let parts = parallel::map(raster.pixels().chunks(4096), |pixels| {
        pixels.iter().flat_map(|&colour| numbers(colour)).collect::<Vec<T>>()
    });
    parts.concat()
}

fn bytes(raster: &Raster, options: &WriteOptions) -> Vec<u8> {
    quantised(raster, |colour| options.tone_map.bytes_as(colour, options.encoding))
}

/// A raster and its side layers as an OpenEXR file: the channels R, G and B, and those of the layers, `normal.X` and so on.
fn encode_exr(raster: &Raster, layers: &[SideLayer], comment: Option<&str>) -> Result<Vec<u8>> {
    let mut channels: Vec<_> = (0..3).map(|index| channel(["R", "G", "B"][index].to_owned(), raster, index)).collect();
    for layer in layers {
        let named = layer.channels.iter().enumerate();
        channels.extend(named.map(|(index, name)| channel(format!("{}.{name}", layer.name), layer.raster, index)));
    }
    files::encode_openexr((raster.width(), raster.height()), channels, comment)
}

/// One component of a raster under a name.
fn channel(name: String, raster: &Raster, component: usize) -> (String, Vec<f32>) {
    (name, raster.pixels().iter().map(|colour| colour[component]).collect())
}
