//! Reading OpenEXR files block by block in the calling thread.

use std::collections::BTreeSet;
use std::io::Cursor;

use exr::block::UncompressedBlock;
use exr::block::reader::{ChunksReader, Reader};
use exr::meta::attribute::EnvironmentMap;
use exr::meta::header::Header as Layer;

use super::channels::{ColourChannels, samples};
use crate::error::{Error, Result};
use crate::math::Vec3;
use crate::picture::decode::{check_size, damaged};
use crate::picture::{Format, Header, Picture, Texels};

/// How an OpenEXR file says that it wraps around the viewer (attribute `envmap`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnvironmentLayout {
    /// Six square faces, one below the other: +X, -X, +Y, -Y, +Z, -Z.
    Cube,
    /// Longitude along the width, latitude along the height.
    LatitudeLongitude,
}

/// What the `envmap` attribute of an OpenEXR file says; `None` if it has none or is no readable OpenEXR file.
pub fn exr_environment(encoded: &[u8]) -> Option<EnvironmentLayout> {
    let reader = open(encoded).ok()?;
    Some(match reader.headers().first()?.own_attributes.environment_map? {
        EnvironmentMap::Cube => EnvironmentLayout::Cube,
        EnvironmentMap::LatitudeLongitude => EnvironmentLayout::LatitudeLongitude,
    })
}

/// The header of an OpenEXR file.
pub fn read_header(encoded: &[u8]) -> Result<Header> {
    let reader = open(encoded)?;
    let layer = first_layer(&reader)?;
    header_of(layer, ColourChannels::find(&layer.channels)?)
}

/// Decodes the colour of the first layer. The picture is the display window: what the file has no data for is black,
/// data outside the window are cut off.
pub fn decode(encoded: &[u8]) -> Result<Picture> {
    let reader = open(encoded)?;
    let layer = first_layer(&reader)?.clone();
    let channels = ColourChannels::find(&layer.channels)?;
    let header = header_of(&layer, channels)?;
    let mut canvas = Canvas::new(header, &layer, channels);
    reader
        .filter_chunks(true, |_, tile, block| block.layer == 0 && tile.level_index == exr::math::Vec2(0, 0))
        .and_then(|chunks| {
            chunks.decompress_sequential(false, |_, block| {
                canvas.draw(&layer, &block);
                Ok(())
            })
        })
        .map_err(|error| explain(&error))?;
    canvas.finish(&layer)
}

fn open(encoded: &[u8]) -> Result<Reader<Cursor<&[u8]>>> {
    Reader::read_from_buffered(Cursor::new(encoded), false).map_err(|error| explain(&error))
}

fn first_layer<'a>(reader: &'a Reader<Cursor<&[u8]>>) -> Result<&'a Layer> {
    let layer = reader.headers().first().ok_or_else(|| damaged(Format::Exr, "it has no layer"))?;
    if layer.deep {
        return Err(Error::new("this OpenEXR picture holds deep data").expected("one colour a pixel"));
    }
    Ok(layer)
}

fn header_of(layer: &Layer, channels: ColourChannels) -> Result<Header> {
    let texel_size = std::mem::size_of::<Vec3>();
    let window = layer.shared_attributes.display_window.size;
    check_size(layer.layer_size.0, layer.layer_size.1, texel_size)?;
    check_size(window.0, window.1, texel_size)?;
    let alpha = layer.channels.list.iter().any(|channel| channel.name == *"A");
    let bit_depth = channels.bit_depth(&layer.channels);
    Ok(Header { width: window.0, height: window.1, format: Format::Exr, bit_depth, alpha })
}

fn explain(error: &exr::error::Error) -> Error {
    match error {
        exr::error::Error::Io(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
            damaged(Format::Exr, "it is truncated, the file ends too early")
        }
        error => damaged(Format::Exr, error),
    }
}

/// The display window while the blocks of the data window are drawn into it.
struct Canvas {
    header: Header,
    channels: ColourChannels,
    colours: Vec<Vec3>,
    /// Column and row of the data window's first pixel in the display window.
    origin: (i64, i64),
    /// Top left corners of the blocks that came, and how many pixels they cover.
    blocks: BTreeSet<(usize, usize)>,
    covered: usize,
}

impl Canvas {
    fn new(header: Header, layer: &Layer, channels: ColourChannels) -> Self {
        let data = layer.own_attributes.layer_position;
        let display = layer.shared_attributes.display_window.position;
        Self {
            header,
            channels,
            colours: vec![Vec3::ZERO; header.width * header.height],
            origin: (i64::from(data.0) - i64::from(display.0), i64::from(data.1) - i64::from(display.1)),
            blocks: BTreeSet::new(),
            covered: 0,
        }
    }

    fn draw(&mut self, layer: &Layer, block: &UncompressedBlock) {
        if self.blocks.insert((block.index.pixel_position.0, block.index.pixel_position.1)) {
            self.covered += block.index.pixel_size.area();
        }
        for line in block.lines(&layer.channels).filter(|line| self.channels.contain(line.location.channel)) {
            let kind = layer.channels.list[line.location.channel].sample_type;
            let first_column = self.origin.0 + line.location.position.0 as i64;
            let Some(row) = self.row(line.location.position.1) else { continue };
            for (column, sample) in (first_column..).zip(samples(line.value, kind)) {
                if let Some(colour) =
                    usize::try_from(column).ok().and_then(|column| self.colours[row.clone()].get_mut(column))
                {
                    self.channels.store(line.location.channel, sample, colour);
                }
            }
        }
    }

    /// The pixels of the display window that lie in this row of the data window; `None` above and below the window.
    fn row(&self, data_row: usize) -> Option<std::ops::Range<usize>> {
        let row = usize::try_from(self.origin.1 + data_row as i64).ok()?;
        (row < self.header.height).then(|| row * self.header.width..(row + 1) * self.header.width)
    }

    fn finish(self, layer: &Layer) -> Result<Picture> {
        if self.covered != layer.layer_size.area() {
            return Err(damaged(Format::Exr, "some of its blocks are missing"));
        }
        Ok(Picture::new(self.header, Texels::Linear(self.colours)))
    }
}
