//! The pictures in a page: without loss if they are small, else as JPEG, reduced until they fit.

use crate::colour::encode_srgb8;
use crate::envmap::{CubeMap, Face};
use crate::error::Result;
use crate::picture::{Picture, Raster, Samples, Texels, encode_jpeg, encode_png};

/// What base64 makes of three bytes.
const BASE64: usize = 4;
const QUALITY: u8 = 90;

/// Media type and bytes of each image, in the order of [`Face::ALL`], in base64 not longer than `limit` in all.
pub fn embedded(map: &CubeMap, limit: usize) -> Result<Vec<(&'static str, Vec<u8>)>> {
    let pictures = Face::ALL.map(|face| map.picture(face));
    let pictures: Vec<&Picture> = pictures.into_iter().collect::<Result<_>>()?;
    let encoded = |factor: usize, lossless: bool| -> Result<Vec<(&'static str, Vec<u8>)>> {
        pictures.iter().map(|picture| one(picture, factor, lossless)).collect()
    };
    let fits =
        |images: &[(&str, Vec<u8>)]| images.iter().map(|(_, bytes)| bytes.len() * BASE64 / 3).sum::<usize>() <= limit;
    // PNG files of photographs take a byte and more a texel: not tried where that is hopeless.
    let texels: usize = pictures.iter().map(|picture| picture.width() * picture.height()).sum();
    if texels <= limit {
        let images = encoded(1, true)?;
        if fits(&images) {
            return Ok(images);
        }
    }
    let smallest = pictures.iter().map(|picture| picture.width().min(picture.height())).min().unwrap_or(1);
    let mut factor = 1;
    loop {
        let images = encoded(factor, false)?;
        if fits(&images) || 2 * factor > smallest {
            return Ok(images);
        }
        factor *= 2;
    }
}

fn one(picture: &Picture, factor: usize, lossless: bool) -> Result<(&'static str, Vec<u8>)> {
    let reduced: Raster;
    let (width, height, bytes) = match picture.texels() {
        Texels::Srgb8(bytes) if factor == 1 => (picture.width(), picture.height(), bytes.clone()),
        _ => {
            reduced = picture.to_raster().reduced(factor);
            let bytes = reduced.pixels().iter().flat_map(|colour| colour.to_array().map(encode_srgb8)).collect();
            (reduced.width(), reduced.height(), bytes)
        }
    };
    if lossless {
        return Ok(("image/png", encode_png(width, height, Samples::Rgb8(&bytes))?));
    }
    Ok(("image/jpeg", encode_jpeg(width, height, &bytes, QUALITY)?))
}
