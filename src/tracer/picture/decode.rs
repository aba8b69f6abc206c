//! Decoding of every file format that is read.

use std::path::Path;

use super::{Format, Header, Picture, foreign, openexr, pixel_codecs};
use crate::error::{Error, Result};

/// The most memory the texels of one picture may take. It holds a 16384 by 8192 panorama in floats and stops a damaged
/// or hostile header before it exhausts the machine.
pub(super) const MEMORY_LIMIT: u64 = 2 << 30;

/// Decodes a picture from the bytes of its file. `name` is what errors call it.
///
/// The format is found from the content, so a PNG named `.jpg` is read. Alpha is dropped, not applied. Never spawns or
/// waits for threads.
pub fn decode(encoded: &[u8], name: &Path) -> Result<Picture> {
    let picture = match format_of(encoded, name)? {
        Format::Exr => openexr::decode(encoded),
        format => pixel_codecs::decode(encoded, format),
    };
    picture.map_err(|error| error.in_file(name))
}

/// What the file says of its picture, without decoding the pixels.
pub fn read_header(encoded: &[u8], name: &Path) -> Result<Header> {
    let header = match format_of(encoded, name)? {
        Format::Exr => openexr::read_header(encoded),
        format => pixel_codecs::read_header(encoded, format),
    };
    header.map_err(|error| error.in_file(name))
}

/// Reads and decodes a picture file.
pub fn read(path: &Path) -> Result<Picture> {
    let encoded = std::fs::read(path).map_err(|error| unreadable(path, &error))?;
    decode(&encoded, path)
}

/// What a picture file says of its picture, without decoding the pixels.
pub fn read_file_header(path: &Path) -> Result<Header> {
    let encoded = std::fs::read(path).map_err(|error| unreadable(path, &error))?;
    read_header(&encoded, path)
}

fn format_of(encoded: &[u8], name: &Path) -> Result<Format> {
    Format::of_content(encoded, name).ok_or_else(|| foreign::not_a_picture(encoded).in_file(name))
}

fn unreadable(path: &Path, error: &std::io::Error) -> Error {
    let error = match error.kind() {
        std::io::ErrorKind::NotFound => Error::new("there is no such file"),
        std::io::ErrorKind::IsADirectory => Error::new("this is a folder").expected("a picture file"),
        _ => Error::new(format!("cannot read: {error}")),
    };
    error.in_file(path)
}

/// An error if a picture of this size is empty or would take more memory than is sensible.
pub(super) fn check_size(width: usize, height: usize, bytes_per_texel: usize) -> Result<()> {
    if width == 0 || height == 0 {
        return Err(Error::new(format!("the picture is empty ({width} x {height})")));
    }
    let bytes = (width as u128) * (height as u128) * (bytes_per_texel as u128);
    if bytes <= u128::from(MEMORY_LIMIT) {
        return Ok(());
    }
    Err(Error::new(format!("the picture claims to be {width} x {height} and would take {} GiB of memory", bytes >> 30))
        .expected(format!("at most {} GiB", MEMORY_LIMIT >> 30))
        .help("scale the picture down, or download it again if it should be smaller"))
}

/// The error for a picture whose data do not decode.
pub(super) fn damaged(format: Format, detail: impl std::fmt::Display) -> Error {
    Error::new(format!("this {} picture cannot be decoded: {detail}", format.name()))
        .help("the file is damaged, incomplete or of an unsupported kind; download it again or save it anew as PNG")
}
