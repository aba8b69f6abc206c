//! OpenEXR pictures, written by the `exr` crate.

use std::io::Cursor;

use exr::image::{Blocks, FlatSamples, Image, Layer};
use exr::prelude::*;

use super::{HEIGHT, Kind, Right, WIDTH, pixels, sample};

fn light(x: usize, y: usize, channel: usize) -> f32 {
    sample(x, y, channel, 10) as f32 / 16.0
}

fn values(channel: usize) -> Vec<f32> {
    pixels(|x, y| light(x, y, channel))
}

fn halves(channel: usize) -> FlatSamples {
    FlatSamples::F16(values(channel).into_iter().map(f16::from_f32).collect())
}

fn floats(channel: usize) -> FlatSamples {
    FlatSamples::F32(values(channel))
}

fn numbers(channel: usize) -> FlatSamples {
    FlatSamples::U32(values(channel).into_iter().map(|value| value as u32).collect())
}

type Part = Layer<AnyChannels<FlatSamples>>;

fn layer(name: Option<&str>, channels: &[(&str, FlatSamples)], encoding: Encoding) -> Part {
    let list = channels.iter().map(|(name, samples)| AnyChannel::new(*name, samples.clone())).collect();
    let attributes = LayerAttributes { layer_name: name.map(Text::from), ..LayerAttributes::default() };
    Layer::new((WIDTH, HEIGHT), attributes, encoding, AnyChannels::sort(list))
}

fn written(layers: Vec<Part>) -> Vec<u8> {
    let mut bytes = Vec::new();
    let image = Image::from_layers(ImageAttributes::new(IntegerBounds::from_dimensions((WIDTH, HEIGHT))), layers);
    image.write().non_parallel().to_buffered(Cursor::new(&mut bytes)).unwrap();
    bytes
}

fn rgb(samples: fn(usize) -> FlatSamples) -> Vec<(&'static str, FlatSamples)> {
    vec![("R", samples(0)), ("G", samples(1)), ("B", samples(2))]
}

/// The value of an attribute, changed.
fn patched(mut file: Vec<u8>, attribute: &[u8], change: impl Fn(&mut [u8])) -> Vec<u8> {
    let place = file.windows(attribute.len()).position(|bytes| bytes == attribute).unwrap() + attribute.len();
    let length = u32::from_le_bytes(*file[place..].first_chunk().unwrap()) as usize;
    change(&mut file[place + 4..place + 4 + length]);
    file
}

/// Every kind of picture.
pub fn kinds() -> Vec<Kind> {
    let mut kinds = Vec::new();
    let shown = |tolerance| Right::Light(pixels(|x, y| [0, 1, 2].map(|channel| light(x, y, channel))), tolerance);
    let grey = |tolerance| Right::Light(pixels(|x, y| [light(x, y, 0); 3]), tolerance);
    let plain = Encoding {
        compression: Compression::Uncompressed,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let file = |channels: &[(&str, FlatSamples)], encoding| written(vec![layer(None, channels, encoding)]);
    for (compression, tolerance) in [
        (Compression::Uncompressed, 1e-3),
        (Compression::RLE, 1e-3),
        (Compression::ZIP1, 1e-3),
        (Compression::ZIP16, 1e-3),
        (Compression::PIZ, 1e-3),
        (Compression::PXR24, 1e-3),
    ] {
        for blocks in [Blocks::ScanLines, Blocks::Tiles(Vec2(8, 5)), Blocks::Tiles(Vec2(64, 64))] {
            for line_order in [LineOrder::Increasing, LineOrder::Decreasing, LineOrder::Unspecified] {
                let encoding = Encoding { compression, blocks, line_order };
                let tiled = blocks != Blocks::ScanLines;
                if !tiled && line_order == LineOrder::Unspecified {
                    continue;
                }
                let name = format!("{compression}, {blocks:?}, {line_order:?}");
                kinds.push(Kind::new(format!("halves, {name}"), file(&rgb(halves), encoding), shown(tolerance)));
                kinds.push(Kind::new(format!("floats, {name}"), file(&rgb(floats), encoding), shown(tolerance)));
            }
        }
    }
    let mixed =
        [("R", halves(0)), ("G", floats(1)), ("B", halves(2)), ("A", halves(0)), ("Z", floats(1)), ("id", numbers(2))];
    kinds.push(Kind::new("mixed channels", file(&mixed, plain), shown(1e-3)));
    kinds.push(Kind::new("grey", file(&[("Y", halves(0))], plain), grey(1e-3)));
    kinds.push(Kind::new("grey and alpha", file(&[("Y", floats(0)), ("A", floats(1))], plain), grey(1e-6)));
    let whole = Right::Light(pixels(|x, y| [0, 1, 2].map(|channel| light(x, y, channel).floor())), 0.0);
    kinds.push(Kind::new("whole numbers", file(&rgb(numbers), plain), whole));
    let parts = vec![layer(Some("beauty"), &rgb(halves), plain), layer(Some("depth"), &[("Z", floats(0))], plain)];
    kinds.push(Kind::new("two parts", written(parts), shown(1e-3)));
    let parts = vec![layer(Some("depth"), &[("Z", floats(0))], plain), layer(Some("beauty"), &rgb(halves), plain)];
    kinds.push(Kind::new("two parts, depth first", written(parts), Right::Refused));
    kinds.push(Kind::new(
        "channels of a layer",
        file(&[("left.R", halves(0)), ("left.G", halves(1))], plain),
        Right::Refused,
    ));
    let chroma = [("Y", halves(0)), ("RY", halves(1)), ("BY", halves(2))];
    kinds.push(Kind::new("luminance and chroma", file(&chroma, plain), Right::Refused));
    // What the crate does not write: the number of another compression, and samples of every second pixel.
    let zip = Encoding { compression: Compression::ZIP16, ..plain };
    for (number, name) in [(8, "DWAA"), (9, "DWAB"), (10, "HTJ2K"), (77, "unknown compression")] {
        let file = patched(file(&rgb(halves), zip), b"compression\0compression\0", |value| value[0] = number);
        kinds.push(Kind::new(name, file, Right::Refused));
    }
    let subsampled = patched(file(&rgb(halves), plain), b"channels\0chlist\0", |value| value[10] = 2);
    kinds.push(Kind::new("every second sample", subsampled, Right::Refused));
    kinds
}
