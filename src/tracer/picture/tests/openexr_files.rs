//! OpenEXR files of every sample type, compression and layout, read back.

use std::io::Cursor;
use std::path::Path;

use exr::meta::attribute::EnvironmentMap;
use exr::prelude::*;

use super::pictures::{colours_of, radiant};
use crate::math::Vec3;
use crate::picture::{EnvironmentLayout, Format, decode, exr_environment, read_header};

const WIDTH: usize = 19;
const HEIGHT: usize = 37;

const COMPRESSIONS: [Compression; 8] = [
    Compression::Uncompressed,
    Compression::RLE,
    Compression::ZIP1,
    Compression::ZIP16,
    Compression::PIZ,
    Compression::PXR24,
    Compression::B44,
    Compression::B44A,
];

/// An image of one layer with any channels.
type FlatImageLayer = Image<Layer<AnyChannels<FlatSamples>>>;

fn colour(x: usize, y: usize) -> Vec3 {
    radiant(WIDTH, HEIGHT).pixel(x, y)
}

fn encoded(image: &FlatImageLayer) -> Vec<u8> {
    let mut bytes = Vec::new();
    image.write().non_parallel().to_buffered(Cursor::new(&mut bytes)).unwrap();
    bytes
}

/// A file of one layer with the named channels, each of the given samples.
fn file_of(channels: Vec<(&str, FlatSamples)>, encoding: Encoding, attributes: LayerAttributes) -> Vec<u8> {
    let list = channels.into_iter().map(|(name, samples)| AnyChannel::new(name, samples)).collect();
    encoded(&Image::from_layer(Layer::new((WIDTH, HEIGHT), attributes, encoding, AnyChannels::sort(list))))
}

fn component(index: usize) -> Vec<f32> {
    (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| colour(x, y)[index])).collect()
}

fn halves(index: usize) -> FlatSamples {
    FlatSamples::F16(component(index).into_iter().map(f16::from_f32).collect())
}

fn floats(index: usize) -> FlatSamples {
    FlatSamples::F32(component(index))
}

fn assert_close(file: &[u8], tolerance: f32, what: &str) {
    let picture = decode(file, Path::new("a.exr")).unwrap();
    assert_eq!((picture.width(), picture.height(), picture.header().format), (WIDTH, HEIGHT, Format::Exr));
    assert_eq!(read_header(file, Path::new("a.exr")).unwrap(), picture.header());
    for (index, found) in colours_of(&picture).iter().enumerate() {
        let expected = colour(index % WIDTH, index / WIDTH);
        let difference = (*found - expected).abs();
        assert!(difference.cmple(expected * tolerance).all(), "{what}, texel {index}: {found} against {expected}");
    }
}

#[test]
fn every_compression_and_block_layout_is_read() {
    for compression in COMPRESSIONS {
        for blocks in [Blocks::ScanLines, Blocks::Tiles(Vec2(8, 5))] {
            let encoding = Encoding { compression, blocks, line_order: LineOrder::Increasing };
            let what = format!("{compression:?} {blocks:?}");
            let file = |samples: fn(usize) -> FlatSamples| {
                file_of(
                    vec![("R", samples(0)), ("G", samples(1)), ("B", samples(2))],
                    encoding,
                    LayerAttributes::default(),
                )
            };
            // A half has 11 bits; B44 keeps about 6 of them, relative to the largest of 4 x 4 pixels.
            let lossy = matches!(compression, Compression::B44 | Compression::B44A);
            if !lossy {
                assert_close(&file(halves), 1.0 / 2048.0, &what);
            }
            // PXR24 keeps 16 bits of a float; all others keep it as it is.
            assert_close(&file(floats), if compression == Compression::PXR24 { 1.0 / 32768.0 } else { 0.0 }, &what);
        }
    }
}

/// B44 is lossy by block, so it is compared with what the crate itself decodes.
#[test]
fn lossy_halves_agree_with_the_crate() {
    for compression in [Compression::B44, Compression::B44A] {
        let encoding = Encoding { compression, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing };
        let channels = vec![("R", halves(0)), ("G", halves(1)), ("B", halves(2))];
        let file = file_of(channels, encoding, LayerAttributes::default());
        let image =
            read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer().all_attributes();
        let image = image.non_parallel().from_buffered(Cursor::new(&file)).unwrap();
        let picture = decode(&file, Path::new("a.exr")).unwrap();
        for (name, component) in [("R", 0), ("G", 1), ("B", 2)] {
            let channel = image.layer_data.channel_data.list.iter().find(|channel| channel.name == *name).unwrap();
            let found: Vec<f32> = colours_of(&picture).iter().map(|colour| colour[component]).collect();
            assert_eq!(channel.sample_data.values_as_f32().collect::<Vec<_>>(), found, "{compression:?} {name}");
        }
    }
}

#[test]
fn whole_numbers_grey_alpha_and_other_channels() {
    let numbers = FlatSamples::U32((0..(WIDTH * HEIGHT) as u32).collect());
    let depth = ("Z", floats(1));
    let file = file_of(vec![("Y", numbers), ("A", halves(0)), depth], Encoding::default(), LayerAttributes::default());
    let picture = decode(&file, Path::new("grey.exr")).unwrap();
    let expected: Vec<Vec3> = (0..WIDTH * HEIGHT).map(|index| Vec3::splat(index as f32)).collect();
    assert_eq!(colours_of(&picture), expected);
    assert_eq!((picture.header().bit_depth, picture.header().alpha), (32, true));
}

#[test]
fn a_file_without_colour_says_what_it_has() {
    let file = file_of(vec![("Z", floats(0)), ("id", floats(1))], Encoding::default(), LayerAttributes::default());
    let error = decode(&file, Path::new("depth.exr")).unwrap_err();
    insta::assert_snapshot!(error, @r"
    depth.exr: the first layer has no colour, its channels are Z, id
      expected: channels R, G and B, or Y alone
    ");
}

#[test]
fn a_small_data_window_is_placed_in_the_display_window() {
    for (left, top) in [(3, 2), (-4, -7), (100, 0)] {
        let attributes = LayerAttributes { layer_position: Vec2(left, top), ..LayerAttributes::default() };
        let channels = AnyChannels::sort(
            [("R", 0), ("G", 1), ("B", 2)]
                .map(|(name, index)| AnyChannel::new(name, floats(index)))
                .into_iter()
                .collect(),
        );
        let layer = Layer::new((WIDTH, HEIGHT), attributes, Encoding::FAST_LOSSLESS, channels);
        let window = IntegerBounds::new((-1, 1), (30, 20));
        let file = encoded(&Image { attributes: ImageAttributes::new(window), layer_data: layer });
        let picture = decode(&file, Path::new("window.exr")).unwrap();
        assert_eq!((picture.width(), picture.height()), (30, 20));
        for y in 0..20 {
            for x in 0..30 {
                let (column, row) = (x as i32 - 1 - left, y as i32 + 1 - top);
                let inside = (0..WIDTH as i32).contains(&column) && (0..HEIGHT as i32).contains(&row);
                let expected = if inside { colour(column as usize, row as usize) } else { Vec3::ZERO };
                assert_eq!(picture.texel(x, y), expected, "pixel {x} {y}, data window at {left} {top}");
            }
        }
    }
}

#[test]
fn the_envmap_attribute_is_told() {
    let layouts = [
        (None, None),
        (Some(EnvironmentMap::Cube), Some(EnvironmentLayout::Cube)),
        (Some(EnvironmentMap::LatitudeLongitude), Some(EnvironmentLayout::LatitudeLongitude)),
    ];
    for (environment_map, expected) in layouts {
        let attributes = LayerAttributes { environment_map, ..LayerAttributes::default() };
        let file = file_of(vec![("Y", floats(0))], Encoding::default(), attributes);
        assert_eq!(exr_environment(&file), expected);
    }
    assert_eq!(exr_environment(b"no picture"), None);
}
