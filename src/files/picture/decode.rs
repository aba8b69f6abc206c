//! Decoding of every supported file format.

use std::path::Path;

use super::{Decoded, Format, Header, PixelLoops, netpbm, openexr, still, unsupported};
use crate::error::Result;
use crate::guard::guarded;
use crate::notes::note;
use crate::plain_file::read_plain_file;

/// What to do with a file that a decoder fails at.
const SAVE_AGAIN: &str = "save it again as PNG with an image editor, or download it again";

/// Decodes a picture from the bytes of its file. `name` is what errors call it.
///
/// The format is found from the content, so a PNG named `.jpg` is read. Never spawns or waits for threads.
pub fn decode(encoded: &[u8], name: &Path, loops: &dyn PixelLoops) -> Result<Decoded> {
    let format = format_of(encoded, name)?;
    let header = read_header(encoded, name, loops)?;
    let _claim = header.claim(encoded).map_err(|error| error.in_file(name))?;
    let picture = guarded(SAVE_AGAIN, || match format {
        Format::Exr => openexr::decode(encoded, loops),
        Format::Ppm | Format::Pfm => netpbm::decode(encoded),
        format => still::decode(encoded, format, loops),
    });
    picture
        .inspect(|picture| picture.notes.iter().for_each(|text| note(name, text)))
        .map_err(|error| error.in_file(name))
}

/// What the file says of its picture, without decoding the pixels.
pub fn read_header(encoded: &[u8], name: &Path, loops: &dyn PixelLoops) -> Result<Header> {
    let format = format_of(encoded, name)?;
    let header = guarded(SAVE_AGAIN, || match format {
        Format::Exr => openexr::read_header(encoded),
        Format::Ppm | Format::Pfm => netpbm::read_header(encoded),
        format => still::read_header(encoded, format, loops),
    });
    header.map_err(|error| error.in_file(name))
}

/// Reads and decodes a picture file.
pub fn read(path: &Path, loops: &dyn PixelLoops) -> Result<Decoded> {
    let encoded = read_plain_file(path, "a picture file")?;
    decode(&encoded, path, loops)
}

/// What a picture file says of its picture, without decoding the pixels.
pub fn read_file_header(path: &Path, loops: &dyn PixelLoops) -> Result<Header> {
    let encoded = read_plain_file(path, "a picture file")?;
    read_header(&encoded, path, loops)
}

fn format_of(encoded: &[u8], name: &Path) -> Result<Format> {
    Format::of_content(encoded, name).ok_or_else(|| unsupported::not_a_picture(encoded).in_file(name))
}
