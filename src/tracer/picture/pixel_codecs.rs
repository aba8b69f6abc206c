//! The formats that the `image` crate decodes: all but OpenEXR.

use std::io::Cursor;

use image::codecs::hdr::HdrDecoder;
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};

use super::decode::{MEMORY_LIMIT, check_size, damaged};
use super::{Format, Header, Picture, Texels, jpeg_extent};
use crate::colour::decode_srgb16;
use crate::error::Result;
use crate::math::Vec3;

/// Decodes a picture of the given format, which is not OpenEXR.
pub fn decode(encoded: &[u8], format: Format) -> Result<Picture> {
    if format == Format::Jpeg && !jpeg_extent::is_complete(encoded) {
        return Err(damaged(format, "it is truncated, its end marker is missing"));
    }
    let decoder = open(encoded, format)?;
    let header = header_of(&decoder, encoded, format)?;
    let image = DynamicImage::from_decoder(decoder).map_err(|error| explain(format, &error))?;
    Ok(Picture::new(header, texels_of(image)))
}

/// The header of a picture of the given format, which is not OpenEXR.
pub fn read_header(encoded: &[u8], format: Format) -> Result<Header> {
    header_of(&open(encoded, format)?, encoded, format)
}

fn open(encoded: &[u8], format: Format) -> Result<Box<dyn ImageDecoder + '_>> {
    let bytes = Cursor::new(encoded);
    let image_format = match format {
        // Files that begin with `#?RGBE` are as common as those with `#?RADIANCE`, but need the lenient reader.
        Format::Hdr => {
            let decoder = HdrDecoder::new_nonstrict(bytes).map_err(|error| explain(format, &error))?;
            return Ok(Box::new(decoder));
        }
        Format::Jpeg => ImageFormat::Jpeg,
        Format::Png => ImageFormat::Png,
        Format::Tga => ImageFormat::Tga,
        Format::Bmp => ImageFormat::Bmp,
        Format::WebP => ImageFormat::WebP,
        Format::Tiff => ImageFormat::Tiff,
        Format::Exr => unreachable!("OpenEXR has a decoder of its own"),
    };
    let mut reader = ImageReader::with_format(bytes, image_format);
    let mut limits = Limits::default();
    limits.max_alloc = Some(2 * MEMORY_LIMIT);
    reader.limits(limits);
    Ok(Box::new(reader.into_decoder().map_err(|error| explain(format, &error))?))
}

/// The header; an error if the picture is too large to decode.
fn header_of(decoder: &dyn ImageDecoder, encoded: &[u8], format: Format) -> Result<Header> {
    let (width, height) = decoder.dimensions();
    let (width, height) = (width as usize, height as usize);
    let colour = decoder.color_type();
    let eight_bits = colour.bytes_per_pixel() == colour.channel_count();
    check_size(width, height, if eight_bits { 4 } else { std::mem::size_of::<Vec3>() })?;
    let bit_depth = bit_depth(encoded, format, decoder.original_color_type());
    Ok(Header { width, height, format, bit_depth, alpha: colour.has_alpha() })
}

/// Bits a channel. The codecs widen small depths, so PNG and BMP are asked for theirs here; the colours of a palette
/// have 8 bits, whatever the width of its indices.
fn bit_depth(encoded: &[u8], format: Format, colour: ExtendedColorType) -> u8 {
    const PNG_PALETTE: u8 = 3;
    match format {
        Format::Png => match (encoded.get(24), encoded.get(25)) {
            (Some(&depth), Some(&colour_type)) if colour_type != PNG_PALETTE => depth,
            _ => 8,
        },
        Format::Bmp if encoded.get(28..30) == Some(&[16, 0]) => 5,
        Format::Hdr => 8,
        _ => match colour {
            ExtendedColorType::Rgb5x1 => 5,
            _ => (colour.bits_per_pixel() / u16::from(colour.channel_count().max(1))) as u8,
        },
    }
}

/// The texels of a decoded image: bytes stay bytes, all else becomes linear.
fn texels_of(image: DynamicImage) -> Texels {
    match image {
        DynamicImage::ImageRgb8(pixels) => Texels::Srgb8(pixels.into_raw()),
        DynamicImage::ImageRgba8(pixels) => Texels::Srgb8(without_alpha(&pixels)),
        DynamicImage::ImageLuma8(pixels) => Texels::Srgb8(pixels.iter().flat_map(|&grey| [grey; 3]).collect()),
        DynamicImage::ImageLumaA8(pixels) => {
            Texels::Srgb8(pixels.chunks_exact(2).flat_map(|texel| [texel[0]; 3]).collect())
        }
        DynamicImage::ImageRgb16(pixels) => linear(&pixels, 3, decode_srgb16_texel),
        DynamicImage::ImageRgba16(pixels) => linear(&pixels, 4, decode_srgb16_texel),
        DynamicImage::ImageLuma16(pixels) => linear(&pixels, 1, |texel| Vec3::splat(decode_srgb16(texel[0]))),
        DynamicImage::ImageLumaA16(pixels) => linear(&pixels, 2, |texel| Vec3::splat(decode_srgb16(texel[0]))),
        DynamicImage::ImageRgb32F(pixels) => linear(&pixels, 3, Vec3::from_slice),
        DynamicImage::ImageRgba32F(pixels) => linear(&pixels, 4, Vec3::from_slice),
        other => Texels::Srgb8(other.into_rgb8().into_raw()),
    }
}

fn without_alpha(pixels: &[u8]) -> Vec<u8> {
    let mut colours = Vec::with_capacity(pixels.len() / 4 * 3);
    pixels.chunks_exact(4).for_each(|texel| colours.extend_from_slice(&texel[..3]));
    colours
}

fn linear<T>(samples: &[T], channels: usize, colour: impl Fn(&[T]) -> Vec3) -> Texels {
    Texels::Linear(samples.chunks_exact(channels).map(colour).collect())
}

fn decode_srgb16_texel(texel: &[u16]) -> Vec3 {
    Vec3::new(decode_srgb16(texel[0]), decode_srgb16(texel[1]), decode_srgb16(texel[2]))
}

/// Our error for one of the codec.
fn explain(format: Format, error: &ImageError) -> crate::error::Error {
    match error {
        ImageError::IoError(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
            damaged(format, "it is truncated, the file ends too early")
        }
        error => damaged(format, error),
    }
}
