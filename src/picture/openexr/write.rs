//! Writing OpenEXR files.

use std::io::Cursor;

use exr::prelude::{Compression, Encoding, Image, LineOrder, SpecificChannels, Vec2, WritableImage};

use crate::error::{Error, Result};
use crate::picture::Raster;

/// A raster as an OpenEXR file: three 32-bit float channels, every bit of them kept (ZIP compression by 16 lines).
pub fn encode(raster: &Raster) -> Result<Vec<u8>> {
    let encoding =
        Encoding { compression: Compression::ZIP16, line_order: LineOrder::Increasing, ..Encoding::default() };
    let encoding = Encoding { blocks: exr::image::Blocks::ScanLines, ..encoding };
    let channels = SpecificChannels::rgb(|position: Vec2<usize>| {
        let colour = raster.pixel(position.0, position.1);
        (colour.x, colour.y, colour.z)
    });
    let mut encoded = Vec::new();
    Image::from_encoded_channels((raster.width(), raster.height()), encoding, channels)
        .write()
        .non_parallel()
        .to_buffered(Cursor::new(&mut encoded))
        .map_err(|error| Error::new(format!("cannot encode as OpenEXR: {error}")))?;
    Ok(encoded)
}
