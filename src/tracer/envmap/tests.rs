use super::*;
use crate::error::Error;
use crate::math::Vec3;
use crate::picture::{Footprint, Format, Header, Picture, Texels};
use proptest::prelude::*;

proptest! {
    #[test]
    fn direction_is_the_inverse_of_locate(preset in 0..5_usize, face in 0..6_usize, u in 0.001..0.999_f32, v in 0.001..0.999_f32) {
        let lookup = Preset::ALL[preset].lookup();
        let point = FacePoint { face: Face::ALL[face], u, v };
        let back = lookup.locate(lookup.direction(point) * 3.0);
        prop_assert_eq!(back.face, point.face);
        prop_assert!((back.u - u).abs() < 1e-6 && (back.v - v).abs() < 1e-6);
    }

    #[test]
    fn every_direction_has_a_face_and_coordinates_in_range(x: f32, y: f32, z: f32) {
        let point = Preset::Course.lookup().locate(Vec3::new(x, y, z));
        prop_assert!((0.0..=1.0).contains(&point.u) && (0.0..=1.0).contains(&point.v));
    }
}

#[test]
fn ties_go_to_x_then_to_y() {
    let face = |x, y, z| Preset::Opengl.lookup().locate(Vec3::new(x, y, z)).face;
    assert_eq!(face(1.0, 1.0, 1.0), Face::PosX);
    assert_eq!(face(-1.0, 1.0, 1.0), Face::NegX);
    assert_eq!(face(0.5, -1.0, 1.0), Face::NegY);
    assert_eq!(face(0.5, 0.5, -1.0), Face::NegZ);
}

const FILTERS: [CubeFilter; 3] = [CubeFilter::Nearest, CubeFilter::Bilinear, CubeFilter::Seamless];

/// A picture of noise, of bytes or of floats among which infinities and NaN occur.
fn noise(width: usize, height: usize, floats: bool, seed: u32) -> Picture {
    let mut state = seed.wrapping_mul(2_654_435_769).wrapping_add(1);
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        state >> 8
    };
    let (format, bit_depth) = if floats { (Format::Exr, 32) } else { (Format::Png, 8) };
    let mut float = || match next() % 50 {
        0 => f32::INFINITY,
        1 => f32::NAN,
        value => value as f32 - 20.0,
    };
    let texels = if floats {
        Texels::Linear((0..width * height).map(|_| Vec3::new(float(), float(), float())).collect())
    } else {
        Texels::Srgb8((0..3 * width * height).map(|_| next() as u8).collect())
    };
    Picture::new(Header { width, height, format, bit_depth, alpha: false }, texels)
}

/// All kinds of directions in no order: more than a block, and not a whole number of blocks.
fn scattered_directions() -> Vec<Vec3> {
    let special = [0.0, -0.0, 1.0, -1.0, 1e-30, -1e30, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.999_999_9];
    let cube = |values: &[f32], index: usize| {
        let count = values.len();
        Vec3::new(values[index % count], values[index / count % count], values[index / count / count % count])
    };
    let steps: Vec<f32> = (0..11).map(|step| step as f32 * 0.2 - 1.0).collect();
    let ordered: Vec<Vec3> =
        (0..1000).map(|index| cube(&special, index)).chain((0..1331).map(|index| cube(&steps, index))).collect();
    // 1051 is prime to the count.
    (0..ordered.len()).map(|index| ordered[index * 1051 % ordered.len()]).collect()
}

fn bits(colours: &[Vec3]) -> Vec<[u32; 3]> {
    // The bits of a NaN that an operation makes are the compiler's choice.
    let bits = |value: f32| if value.is_nan() { f32::NAN.to_bits() } else { value.to_bits() };
    colours.iter().map(|colour| colour.to_array().map(bits)).collect()
}

#[test]
fn all_at_once_is_one_by_one() {
    let directions = scattered_directions();
    for preset in Preset::ALL {
        for filter in FILTERS {
            for (size, floats) in [(1, false), (1, true), (2, false), (5, false), (5, true), (64, false)] {
                let images = std::array::from_fn(|image| LazyImage::ready(noise(size, size, floats, image as u32)));
                let map = CubeMap::new(images, preset.lookup(), filter);
                let one_by_one: Vec<Vec3> = directions.iter().map(|&direction| map.sample(direction)).collect();
                for count in [0, 1, 31, 32, 33, directions.len()] {
                    let mut colours = vec![Vec3::NAN; count];
                    map.sample_all(&directions[..count], &mut colours);
                    assert_eq!(bits(&colours), bits(&one_by_one[..count]), "{preset:?} {filter:?} {size} {floats}");
                }
            }
        }
    }
}

/// An independent way to the same texels: the footprint and the weighted sum of the four.
#[test]
fn bilinear_colours_are_the_weighted_sum_of_the_footprint() {
    let directions = scattered_directions();
    let pictures: [Picture; 6] = std::array::from_fn(|image| noise(5, 5, false, image as u32));
    let map = CubeMap::new(pictures.clone().map(LazyImage::ready), Preset::Course.lookup(), CubeFilter::Bilinear);
    let mut colours = vec![Vec3::NAN; directions.len()];
    map.sample_all(&directions, &mut colours);
    let expected: Vec<Vec3> = directions
        .iter()
        .map(|&direction| {
            let place = map.lookup().image_point(map.lookup().locate(direction));
            let picture = &pictures[place.image.index()];
            let (x, y) = place.texels(picture);
            Footprint::new(x, y, 5, 5).interpolate(|column, row| picture.texel(column, row))
        })
        .collect();
    assert_eq!(bits(&colours), bits(&expected));
}

#[test]
fn all_at_once_decodes_what_is_reached_and_is_black_where_that_fails() {
    let images = std::array::from_fn(|image| {
        let decode = move || if image == 2 { Err(Error::new("damaged")) } else { Ok(noise(4, 4, false, image as u32)) };
        LazyImage::new(Box::new(decode))
    });
    let map = CubeMap::new(images, Preset::Opengl.lookup(), CubeFilter::Bilinear);
    let mut colours = [Vec3::NAN; 3];
    map.sample_all(&[Vec3::X, Vec3::Y, Vec3::X], &mut colours);
    assert_eq!(map.looked_at(), [Face::PosX, Face::PosY]);
    assert_eq!((map.errors().count(), colours[1]), (1, Vec3::ZERO));
    assert!(colours[0] == colours[2] && colours[0] != Vec3::ZERO);
}
