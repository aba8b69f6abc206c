//! Decoded files as pictures.

use std::path::Path;

use skycube_files::picture::{self as files, ColourSpace, Decoded, Samples};

use super::pixel_loops::Optimised;
use super::{Header, Picture, Texels};
use crate::colour::decode_srgb16;
use crate::error::Result;
use crate::math::Vec3;
use crate::memory::on_large_pages;

/// Decodes a picture from the bytes of its file. `name` is what errors call it.
///
/// The format is found from the content, so a PNG named `.jpg` is read. Alpha is dropped, not applied. Never spawns or
/// waits for threads.
pub fn decode(encoded: &[u8], name: &Path) -> Result<Picture> {
    files::decode(encoded, name, &Optimised).map(picture)
}

/// Reads and decodes a picture file.
pub fn read(path: &Path) -> Result<Picture> {
    files::read(path, &Optimised).map(picture)
}

/// What the file says of its picture, without decoding the pixels.
pub fn read_header(encoded: &[u8], name: &Path) -> Result<Header> {
    files::read_header(encoded, name, &Optimised)
}

/// What a picture file says of its picture, without decoding the pixels.
pub fn read_file_header(path: &Path) -> Result<Header> {
    files::read_file_header(path, &Optimised)
}

/// Bytes stay bytes, all else becomes linear.
fn picture(Decoded { header, samples, space, .. }: Decoded) -> Picture {
    if let Some(space) = space {
        return Picture::new(header, converted(&samples, &space));
    }
    let texels = match samples {
        Samples::Bytes(3, bytes) => Texels::Srgb8(bytes),
        Samples::Bytes(4, bytes) => Texels::Srgb8(without_alpha(&bytes)),
        Samples::Bytes(channels, bytes) => {
            Texels::Srgb8(bytes.chunks_exact(channels).flat_map(|texel| [texel[0]; 3]).collect())
        }
        Samples::Words(channels @ 3.., words) => {
            linear(&words, channels, |texel| Vec3::from([0, 1, 2].map(|channel| decode_srgb16(texel[channel]))))
        }
        Samples::Words(channels, words) => linear(&words, channels, |texel| Vec3::splat(decode_srgb16(texel[0]))),
        Samples::Floats(channels @ 3.., floats) => linear(&floats, channels, Vec3::from_slice),
        Samples::Floats(channels, floats) => linear(&floats, channels, |texel| Vec3::splat(texel[0])),
    };
    Picture::new(header, texels)
}

/// Samples of another colour space. Colours that Rec. 709 cannot show become the nearest that it can, but those of floats,
/// which stand for light and not for a screen, stay.
fn converted(samples: &Samples, space: &ColourSpace) -> Texels {
    let rows = space.matrix.map(Vec3::from);
    let mixed = |linear: Vec3| Vec3::new(rows[0].dot(linear), rows[1].dot(linear), rows[2].dot(linear));
    let light = |channel: usize, code: usize| {
        space.curves.as_ref().map_or(0.0, |curves| curves[channel].get(code).copied().unwrap_or(0.0))
    };
    let coded = |codes: [usize; 3]| {
        let linear = Vec3::new(light(0, codes[0]), light(1, codes[1]), light(2, codes[2]));
        mixed(linear).clamp(Vec3::ZERO, linear.max(Vec3::ONE))
    };
    let rgb = |channels: usize| if channels >= 3 { [0, 1, 2] } else { [0; 3] };
    match samples {
        Samples::Bytes(channels, bytes) => {
            linear(bytes, *channels, |texel| coded(rgb(*channels).map(|channel| usize::from(texel[channel]))))
        }
        Samples::Words(channels, words) => {
            linear(words, *channels, |texel| coded(rgb(*channels).map(|channel| usize::from(texel[channel]))))
        }
        Samples::Floats(channels, floats) => {
            linear(floats, *channels, |texel| mixed(Vec3::from(rgb(*channels).map(|channel| texel[channel]))))
        }
    }
}

fn without_alpha(bytes: &[u8]) -> Vec<u8> {
    let mut colours = on_large_pages(bytes.len() / 4 * 3);
    bytes.chunks_exact(4).for_each(|texel| colours.extend_from_slice(&texel[..3]));
    colours
}

fn linear<T>(samples: &[T], channels: usize, colour: impl Fn(&[T]) -> Vec3) -> Texels {
    let mut colours = on_large_pages(samples.len() / channels);
    colours.extend(samples.chunks_exact(channels).map(colour));
    Texels::Linear(colours)
}
