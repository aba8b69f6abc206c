//! The loops over pixels of the file formats, compiled for speed.

use std::io::Cursor;

use exr::prelude::f16;
use image::codecs::bmp::BmpDecoder;
use image::codecs::hdr::HdrDecoder;
use image::codecs::tga::TgaDecoder;
use image::{ImageDecoder, ImageResult};
use skycube_files::picture::{PixelLoops, SampleKind, Stretch};

use super::{Format, jpeg_data};

/// The loops of this package, which is optimised.
pub(super) struct Optimised;

impl PixelLoops for Optimised {
    fn decoder<'a>(&self, format: Format, encoded: &'a [u8]) -> Option<ImageResult<Box<dyn ImageDecoder + 'a>>> {
        let bytes = Cursor::new(encoded);
        match format {
            Format::Bmp => Some(boxed(BmpDecoder::new(bytes))),
            Format::Tga => Some(boxed(TgaDecoder::new(bytes))),
            // Files that begin with `#?RGBE` are as common as those with `#?RADIANCE`, but need the lenient reader.
            Format::Hdr => Some(boxed(HdrDecoder::new_nonstrict(bytes))),
            _ => None,
        }
    }

    fn damage(&self, format: Format, encoded: &[u8]) -> Option<String> {
        if format == Format::Jpeg { jpeg_data::damage(encoded) } else { None }
    }

    fn store(&self, stretch: &Stretch, colours: &mut [[f32; 3]]) {
        let colours = &mut colours[stretch.start..];
        match stretch.kind {
            SampleKind::Half => store(stretch, colours, |bytes| f16::from_ne_bytes(bytes).to_f32()),
            SampleKind::Float => store(stretch, colours, f32::from_ne_bytes),
            SampleKind::Unsigned => store(stretch, colours, |bytes| u32::from_ne_bytes(bytes) as f32),
        }
    }
}

fn boxed<'a>(decoder: ImageResult<impl ImageDecoder + 'a>) -> ImageResult<Box<dyn ImageDecoder + 'a>> {
    decoder.map(|decoder| Box::new(decoder) as Box<dyn ImageDecoder>)
}

/// Stores samples of `SIZE` bytes in the first of the colours.
fn store<const SIZE: usize>(stretch: &Stretch, colours: &mut [[f32; 3]], sample: impl Fn([u8; SIZE]) -> f32) {
    let (samples, _) = stretch.bytes.as_chunks::<SIZE>();
    for component in (0..3).filter(|&component| stretch.components[component]) {
        for (colour, &bytes) in colours.iter_mut().zip(samples) {
            colour[component] = sample(bytes);
        }
    }
}
