//! Interpolation and textures against values worked out by hand.

use proptest::prelude::*;

use super::pictures::{grey, rgb8_bytes, srgb8};
use crate::math::Vec3;
use crate::picture::{Filter, Footprint, Format, Header, Picture, Texels, Texture, Wrap};

/// Two by two: black, white over codes 50 and 188.
fn four_greys() -> Picture {
    srgb8(2, 2, [0_u8, 255, 50, 188].into_iter().flat_map(|code| [code; 3]).collect())
}

fn linear_ramp(width: usize, height: usize) -> Picture {
    let colours = (0..width * height).map(|index| Vec3::new((index % width) as f32, (index / width) as f32, 1.0));
    let header = Header { width, height, format: Format::Exr, bit_depth: 32, alpha: false };
    Picture::new(header, Texels::Linear(colours.collect()))
}

fn close(found: Vec3, expected: Vec3) -> bool {
    (found - expected).abs().max_element() < 1e-6
}

#[test]
fn texel_centres_are_at_half_integers() {
    let texture = Texture::new(four_greys(), Filter::Bilinear, Wrap::Clamp);
    for (u, v, code) in [(0.25, 0.25, 0), (0.75, 0.25, 255), (0.25, 0.75, 50), (0.75, 0.75, 188)] {
        assert_eq!(texture.sample(u, v), grey(code));
    }
    // Between the centres the mean is of linear light, not of codes.
    assert!(close(texture.sample(0.5, 0.25), Vec3::splat(0.5)));
    assert!(close(texture.sample(0.5, 0.5), (grey(0) + grey(255) + grey(50) + grey(188)) / 4.0));
    assert!(close(texture.sample(0.375, 0.25), Vec3::splat(0.25)));
}

#[test]
fn the_border_is_clamped() {
    let texture = Texture::new(four_greys(), Filter::Bilinear, Wrap::Clamp);
    assert_eq!(texture.sample(0.0, 0.0), grey(0));
    assert_eq!(texture.sample(1.0, 1.0), grey(188));
    assert_eq!(texture.sample(5.0, -3.0), grey(255));
    assert_eq!(texture.sample(f32::NEG_INFINITY, f32::INFINITY), grey(50));
    assert_eq!(texture.sample(f32::NAN, f32::NAN), grey(0));
}

#[test]
fn repetition_goes_across_the_border() {
    let texture = Texture::new(four_greys(), Filter::Bilinear, Wrap::Repeat);
    assert!(close(texture.sample(0.0, 0.25), Vec3::splat(0.5)));
    assert!(close(texture.sample(1.0, 0.25), Vec3::splat(0.5)));
    assert!(close(texture.sample(-2.75, 7.75), grey(50)));
    let texture = Texture::new(four_greys(), Filter::Nearest, Wrap::Repeat);
    assert_eq!(texture.sample(-0.01, 1.01), grey(255));
}

#[test]
fn nearest_takes_the_texel_around_the_point() {
    let texture = Texture::new(linear_ramp(4, 3), Filter::Nearest, Wrap::Clamp);
    assert_eq!(texture.sample(0.49, 0.34), Vec3::new(1.0, 1.0, 1.0));
    assert_eq!(texture.sample(0.51, 0.99), Vec3::new(2.0, 2.0, 1.0));
    assert_eq!(texture.sample(1.0, 1.0), Vec3::new(3.0, 2.0, 1.0));
}

#[test]
fn the_footprint_is_what_is_drawn() {
    let footprint = Footprint::new(2.75, 1.0, 4, 3);
    assert_eq!(footprint.columns, [2, 3]);
    assert_eq!(footprint.rows, [0, 1]);
    let expected = [(2, 0, 0.375), (3, 0, 0.125), (2, 1, 0.375), (3, 1, 0.125)];
    assert_eq!(footprint.weighted_texels(), expected);
    // Beyond the top right corner its texel counts alone.
    let corner = Footprint::new(9.0, -1.0, 4, 3);
    assert_eq!(corner.weighted_texels(), [(2, 0, 0.0), (3, 0, 1.0), (2, 1, 0.0), (3, 1, 0.0)]);
    // One texel is its own neighbour.
    assert_eq!(
        Footprint::new(0.7, 0.2, 1, 1),
        Footprint { columns: [0, 0], rows: [0, 0], horizontal: 0.0, vertical: 0.0 }
    );
}

proptest! {
    #[test]
    fn a_ramp_is_reproduced(x in 0.5_f32..6.5, y in 0.5_f32..4.5) {
        let found = linear_ramp(7, 5).bilinear(x, y);
        prop_assert!((found - Vec3::new(x - 0.5, y - 0.5, 1.0)).abs().max_element() < 1e-5, "{found}");
    }

    #[test]
    fn any_number_is_allowed(u in any::<f32>(), v in any::<f32>(), width in 1_usize..6, height in 1_usize..6) {
        let bytes = srgb8(width, height, rgb8_bytes(width, height));
        for picture in [bytes, linear_ramp(width, height)] {
            let (lowest, highest) = range(&picture);
            for filter in [Filter::Nearest, Filter::Bilinear] {
                for wrap in [Wrap::Clamp, Wrap::Repeat] {
                    let found = Texture::new(picture.clone(), filter, wrap).sample(u, v);
                    prop_assert!(found.cmpge(lowest - 1e-5).all() && found.cmple(highest + 1e-5).all(), "{found}");
                }
            }
        }
    }

    #[test]
    fn weights_and_bilinear_agree(x in -3.0_f32..10.0, y in -3.0_f32..8.0) {
        let picture = srgb8(7, 5, rgb8_bytes(7, 5));
        let texels = Footprint::new(x, y, 7, 5).weighted_texels();
        let sum: Vec3 = texels.iter().map(|&(column, row, weight)| picture.texel(column, row) * weight).sum();
        prop_assert!((texels.iter().map(|texel| texel.2).sum::<f32>() - 1.0).abs() < 1e-6);
        prop_assert!((sum - picture.bilinear(x, y)).abs().max_element() < 1e-6);
    }
}

fn range(picture: &Picture) -> (Vec3, Vec3) {
    let raster = picture.to_raster();
    let colours = || raster.pixels().iter().copied();
    (colours().reduce(Vec3::min).unwrap(), colours().reduce(Vec3::max).unwrap())
}
