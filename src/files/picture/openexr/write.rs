//! Writing OpenEXR files.

use std::io::Cursor;

use exr::image::Blocks;
use exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes, LineOrder, Text,
    WritableImage,
};

use crate::error::{Error, Result};

/// An OpenEXR file of channels by name, every bit of them kept (32-bit floats, ZIP compression by 16 lines). Each has
/// `size.0 * size.1` samples, row by row from the top. The comment goes into the attribute of that name.
pub fn encode(size: (usize, usize), channels: Vec<(String, Vec<f32>)>, comment: Option<&str>) -> Result<Vec<u8>> {
    let encoding =
        Encoding { compression: Compression::ZIP16, line_order: LineOrder::Increasing, blocks: Blocks::ScanLines };
    let channel = |(name, samples): (String, _)| AnyChannel::new(Text::new_or_panic(name), FlatSamples::F32(samples));
    let channels: Vec<_> = channels.into_iter().map(channel).collect();
    let attributes = LayerAttributes { comments: comment.map(Text::new_or_panic), ..LayerAttributes::default() };
    let layer = Layer::new(size, attributes, encoding, AnyChannels::sort(channels.into()));
    let mut encoded = Vec::new();
    Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(Cursor::new(&mut encoded))
        .map_err(|error| Error::new(format!("cannot encode as OpenEXR: {error}")))?;
    Ok(encoded)
}
