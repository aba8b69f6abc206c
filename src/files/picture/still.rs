//! The formats that the `image` crate decodes: all but OpenEXR and Netpbm.

use std::io::Cursor;

use image::{
    ColorType, DynamicImage, ExtendedColorType, ImageDecoder, ImageError, ImageFormat, ImageReader, ImageResult, Limits,
};

use super::header::{MEMORY_LIMIT, check_size, damaged};
use super::orientation::Orientation;
use super::{
    ColourSpace, Decoded, Format, Header, PixelLoops, Samples, jpeg_extent, palette, radiance_header, tiff_tags,
};
use crate::error::Result;
use crate::memory::zeros_on_large_pages;

/// Decodes a picture of the given format, which is not OpenEXR or Netpbm.
pub fn decode(encoded: &[u8], format: Format, loops: &dyn PixelLoops) -> Result<Decoded> {
    if format == Format::Jpeg && !jpeg_extent::is_complete(encoded) {
        return Err(damaged(format, "it is truncated, its end marker is missing"));
    }
    let mut decoder = open(encoded, format, loops)?;
    let orientation = Orientation::of(&mut decoder);
    let header = header_of(&decoder, encoded, format, orientation)?;
    if let Some(damage) = loops.damage(format, encoded) {
        return Err(damaged(format, damage));
    }
    let profile = decoder.icc_profile().ok().flatten();
    let stored = decoder.dimensions();
    let samples = match decoder.color_type() {
        ColorType::Rgb8 => read_bytes(decoder),
        _ => DynamicImage::from_decoder(decoder).map(samples_of),
    };
    let samples = samples.map_err(|error| explain(format, &error))?;
    let (space, mut notes) = colours(encoded, format, profile.as_deref(), &samples);
    notes.extend(palette::note(encoded, format, &samples));
    notes.extend(if format == Format::Tiff { tiff_tags::note(encoded) } else { None });
    notes.extend(orientation.note());
    Ok(Decoded { header, samples: orientation.applied(samples, [stored.0 as usize, stored.1 as usize]), space, notes })
}

/// The colour space that a file names, and a note on what is ignored.
fn colours(
    encoded: &[u8],
    format: Format,
    profile: Option<&[u8]>,
    samples: &Samples,
) -> (Option<ColourSpace>, Vec<String>) {
    let codes = match samples {
        Samples::Bytes(..) => 256,
        Samples::Words(..) => 65_536,
        Samples::Floats(..) if format == Format::Hdr => return radiance_header::colours(encoded),
        Samples::Floats(..) => return (None, Vec::new()),
    };
    let grey = matches!(samples, Samples::Bytes(1 | 2, _) | Samples::Words(1 | 2, _));
    let chunks = if format == Format::Png { ColourSpace::of_png(encoded, codes) } else { None };
    match chunks.or_else(|| profile.map(|profile| ColourSpace::of_profile(profile, codes, grey))) {
        Some(Ok(space)) => (space, Vec::new()),
        Some(Err(note)) => (None, vec![note]),
        None => (None, Vec::new()),
    }
}

/// The header of a picture of the given format, which is not OpenEXR or Netpbm.
pub fn read_header(encoded: &[u8], format: Format, loops: &dyn PixelLoops) -> Result<Header> {
    let mut decoder = open(encoded, format, loops)?;
    let orientation = Orientation::of(&mut decoder);
    header_of(&decoder, encoded, format, orientation)
}

fn open<'a>(encoded: &'a [u8], format: Format, loops: &dyn PixelLoops) -> Result<Box<dyn ImageDecoder + 'a>> {
    if format == Format::Tiff && tiff_tags::fill_order(encoded) == Some(2) {
        return Err(damaged(format, "its bits are stored from the lowest to the highest (FillOrder 2)"));
    }
    if format == Format::Tiff && tiff_tags::claims_too_much(encoded) {
        return Err(damaged(format, "one of its tags claims more bytes than the file has"));
    }
    if format == Format::Hdr {
        radiance_header::check(encoded)?;
    }
    let mut decoder = match loops.decoder(format, encoded) {
        Some(decoder) => decoder.map_err(|error| explain(format, &error))?,
        None => Box::new(
            ImageReader::with_format(Cursor::new(encoded), image_format(format))
                .into_decoder()
                .map_err(|error| explain(format, &error))?,
        ),
    };
    let mut limits = Limits::default();
    limits.max_alloc = Some(2 * MEMORY_LIMIT);
    decoder.set_limits(limits).map_err(|error| explain(format, &error))?;
    Ok(decoder)
}

fn image_format(format: Format) -> ImageFormat {
    match format {
        Format::Jpeg => ImageFormat::Jpeg,
        Format::Png => ImageFormat::Png,
        Format::Tga => ImageFormat::Tga,
        Format::Bmp => ImageFormat::Bmp,
        Format::WebP => ImageFormat::WebP,
        Format::Tiff => ImageFormat::Tiff,
        Format::Hdr => ImageFormat::Hdr,
        Format::Exr => ImageFormat::OpenExr,
        Format::Ppm | Format::Pfm => ImageFormat::Pnm,
    }
}

/// The header; an error if the picture is too large to decode.
fn header_of(decoder: &dyn ImageDecoder, encoded: &[u8], format: Format, orientation: Orientation) -> Result<Header> {
    let (width, height) = decoder.dimensions();
    let [width, height] = orientation.size([width as usize, height as usize]);
    let colour = decoder.color_type();
    let eight_bits = colour.bytes_per_pixel() == colour.channel_count();
    check_size(width, height, if eight_bits { 4 } else { 3 * size_of::<f32>() })?;
    let bit_depth = bit_depth(encoded, format, decoder.original_color_type());
    Ok(Header { width, height, format, bit_depth, alpha: colour.has_alpha() })
}

/// Bits per channel. The codecs widen small depths, so PNG and BMP are asked for theirs here; the colours of a palette
/// have 8 bits even if its indices have fewer.
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

/// Three bytes per pixel, in memory for reading at random places.
fn read_bytes(decoder: Box<dyn ImageDecoder + '_>) -> ImageResult<Samples> {
    let mut bytes = zeros_on_large_pages(0, decoder.total_bytes() as usize);
    decoder.read_image_boxed(&mut bytes)?;
    Ok(Samples::Bytes(3, bytes))
}

/// The samples of a decoded image as they are.
fn samples_of(image: DynamicImage) -> Samples {
    let channels = usize::from(image.color().channel_count());
    match image {
        DynamicImage::ImageRgb8(pixels) => Samples::Bytes(channels, pixels.into_raw()),
        DynamicImage::ImageRgba8(pixels) => Samples::Bytes(channels, pixels.into_raw()),
        DynamicImage::ImageLuma8(pixels) => Samples::Bytes(channels, pixels.into_raw()),
        DynamicImage::ImageLumaA8(pixels) => Samples::Bytes(channels, pixels.into_raw()),
        DynamicImage::ImageRgb16(pixels) => Samples::Words(channels, pixels.into_raw()),
        DynamicImage::ImageRgba16(pixels) => Samples::Words(channels, pixels.into_raw()),
        DynamicImage::ImageLuma16(pixels) => Samples::Words(channels, pixels.into_raw()),
        DynamicImage::ImageLumaA16(pixels) => Samples::Words(channels, pixels.into_raw()),
        DynamicImage::ImageRgb32F(pixels) => Samples::Floats(channels, pixels.into_raw()),
        DynamicImage::ImageRgba32F(pixels) => Samples::Floats(channels, pixels.into_raw()),
        other => Samples::Bytes(3, other.into_rgb8().into_raw()),
    }
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
