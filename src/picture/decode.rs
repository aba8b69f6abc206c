//! Decoding of every file format that is read.

use std::io::Cursor;
use std::path::Path;

use super::{Format, Header, Picture, Texels};
use crate::error::{Error, Result};

/// Decodes a picture from the bytes of its file. `name` is what errors call it.
pub fn decode(encoded: &[u8], name: &Path) -> Result<Picture> {
    let reader = image::ImageReader::new(Cursor::new(encoded)).with_guessed_format().expect("memory does not fail");
    let decoded = reader.decode().map_err(|error| Error::new(format!("cannot decode: {error}")).in_file(name))?;
    let (width, height) = (decoded.width() as usize, decoded.height() as usize);
    let header = Header { width, height, format: Format::Jpeg, bit_depth: 8, alpha: false };
    Ok(Picture::new(header, Texels::Srgb8(decoded.into_rgb8().into_raw())))
}

/// What the file says of its picture, without decoding the pixels.
pub fn read_header(encoded: &[u8], name: &Path) -> Result<Header> {
    decode(encoded, name).map(|picture| picture.header())
}

/// Reads and decodes a picture file.
pub fn read(path: &Path) -> Result<Picture> {
    let encoded = std::fs::read(path).map_err(|error| Error::new(format!("cannot read: {error}")).in_file(path))?;
    decode(&encoded, path)
}
