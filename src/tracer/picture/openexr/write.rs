//! Writing OpenEXR files.

use std::io::Cursor;

use exr::image::Blocks;
use exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes, LineOrder, Text,
    WritableImage,
};

use crate::error::{Error, Result};
use crate::picture::{Raster, SideLayer};

/// A raster as an OpenEXR file, every bit of it kept (32-bit floats, ZIP compression by 16 lines): the channels R, G and B,
/// and those of the side layers, `normal.X` and so on. The comment goes into the attribute of that name.
pub fn encode(raster: &Raster, layers: &[SideLayer], comment: Option<&str>) -> Result<Vec<u8>> {
    let encoding =
        Encoding { compression: Compression::ZIP16, line_order: LineOrder::Increasing, blocks: Blocks::ScanLines };
    let mut channels: Vec<_> = (0..3).map(|index| channel(["R", "G", "B"][index], raster, index)).collect();
    for layer in layers {
        let named = layer.channels.iter().enumerate();
        channels.extend(named.map(|(index, name)| channel(&format!("{}.{name}", layer.name), layer.raster, index)));
    }
    let attributes = LayerAttributes { comments: comment.map(Text::new_or_panic), ..LayerAttributes::default() };
    let size = (raster.width(), raster.height());
    let layer = Layer::new(size, attributes, encoding, AnyChannels::sort(channels.into()));
    let mut encoded = Vec::new();
    Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(Cursor::new(&mut encoded))
        .map_err(|error| Error::new(format!("cannot encode as OpenEXR: {error}")))?;
    Ok(encoded)
}

/// One component of a raster under a name.
fn channel(name: &str, raster: &Raster, component: usize) -> AnyChannel<FlatSamples> {
    let samples = raster.pixels().iter().map(|colour| colour[component]).collect();
    AnyChannel::new(Text::new_or_panic(name), FlatSamples::F32(samples))
}
