//! Reading OpenEXR files block by block in the calling thread.

use std::collections::HashSet;
use std::io::Cursor;

use exr::block::UncompressedBlock;
use exr::block::reader::{ChunksReader, Reader};
use exr::meta::attribute::EnvironmentMap;
use exr::meta::header::Header as Layer;

use super::channels::{ColourChannels, kind_of};
use crate::error::{Error, Result};
use crate::guard::guarded;
use crate::picture::header::{check_size, damaged};
use crate::picture::{ColourSpace, Decoded, Format, Header, PixelLoops, Samples, Stretch};

/// How an OpenEXR file says that it wraps around the viewer (attribute `envmap`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnvironmentLayout {
    /// Six square faces, one below the other: +X, -X, +Y, -Y, +Z, -Z.
    Cube,
    /// Longitude along the width, latitude along the height.
    LatitudeLongitude,
}

/// What the `envmap` attribute of an OpenEXR file says; `None` if it has none or is not a readable OpenEXR file.
pub fn exr_environment(encoded: &[u8]) -> Option<EnvironmentLayout> {
    let reader = guarded("", || open(encoded)).ok()?;
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
pub fn decode(encoded: &[u8], loops: &dyn PixelLoops) -> Result<Decoded> {
    let reader = open(encoded)?;
    let layer = first_layer(&reader)?.clone();
    let channels = ColourChannels::find(&layer.channels)?;
    let header = header_of(&layer, channels)?;
    let mut canvas = Canvas::new(header, &layer, channels);
    reader
        .filter_chunks(true, |_, tile, block| block.layer == 0 && tile.level_index == exr::math::Vec2(0, 0))
        .and_then(|chunks| {
            chunks.decompress_sequential(false, |_, block| {
                canvas.draw(&layer, &block, loops);
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
        return Err(Error::new("this OpenEXR picture holds deep data").expected("one colour per pixel"));
    }
    Ok(layer)
}

fn header_of(layer: &Layer, channels: ColourChannels) -> Result<Header> {
    let texel_size = 3 * size_of::<f32>();
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
    colours: Vec<[f32; 3]>,
    /// Column and row of the data window's first pixel in the display window.
    origin: (i64, i64),
    /// Top left corners of the blocks that came, and how many pixels they cover.
    blocks: HashSet<(usize, usize)>,
    covered: usize,
}

impl Canvas {
    fn new(header: Header, layer: &Layer, channels: ColourChannels) -> Self {
        let data = layer.own_attributes.layer_position;
        let display = layer.shared_attributes.display_window.position;
        Self {
            header,
            channels,
            colours: vec![[0.0; 3]; header.width * header.height],
            origin: (i64::from(data.0) - i64::from(display.0), i64::from(data.1) - i64::from(display.1)),
            blocks: HashSet::new(),
            covered: 0,
        }
    }

    fn draw(&mut self, layer: &Layer, block: &UncompressedBlock, loops: &dyn PixelLoops) {
        if self.blocks.insert((block.index.pixel_position.0, block.index.pixel_position.1)) {
            self.covered += block.index.pixel_size.area();
        }
        for line in block.lines(&layer.channels).filter(|line| self.channels.contain(line.location.channel)) {
            let kind = kind_of(layer.channels.list[line.location.channel].sample_type);
            let columns = line.value.len() / kind.size();
            let Some(visible) = self.visible(line.location.position.0, line.location.position.1, columns) else {
                continue;
            };
            let bytes = &line.value[visible.skipped * kind.size()..(visible.skipped + visible.count) * kind.size()];
            let components = self.channels.components(line.location.channel);
            loops.store(&Stretch { start: visible.start, components, kind, bytes }, &mut self.colours);
        }
    }

    /// The part of a line of the data window that lies in the display window; `None` if nothing does.
    fn visible(&self, column: usize, row: usize, count: usize) -> Option<Visible> {
        let row = usize::try_from(self.origin.1 + row as i64).ok().filter(|&row| row < self.header.height)?;
        let first = self.origin.0 + column as i64;
        let (from, to) = (first.max(0), (first + count as i64).min(self.header.width as i64));
        (from < to).then(|| Visible {
            start: row * self.header.width + from as usize,
            skipped: (from - first) as usize,
            count: (to - from) as usize,
        })
    }

    fn finish(self, layer: &Layer) -> Result<Decoded> {
        if self.covered != layer.layer_size.area() {
            return Err(damaged(Format::Exr, "some of its blocks are missing"));
        }
        let mut picture = Decoded::plain(self.header, Samples::Floats(3, self.colours.into_flattened()));
        if let Some(given) = layer.shared_attributes.chromaticities {
            let primaries = [given.red, given.green, given.blue, given.white].map(|at| [at.0, at.1].map(f64::from));
            match ColourSpace::linear(primaries, 1.0) {
                Ok(space) => picture.space = space,
                Err(note) => picture.notes.push(note),
            }
        }
        Ok(picture)
    }
}

/// A part of a line: the number of its first pixel in the picture, the samples left out before it, and how many there are.
struct Visible {
    start: usize,
    skipped: usize,
    count: usize,
}
