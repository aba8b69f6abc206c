use super::*;
use crate::error::Error;
use crate::math::Vec3;
use crate::picture::{Format, Header, Picture, Texels};
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

/// The lesson's five lines, in double precision: the four texels around the point, clamped at the border, and their mean.
#[test]
fn a_sample_is_what_the_lesson_computes() {
    let pictures: [Picture; 6] = std::array::from_fn(|image| noise(5, 5, false, image as u32));
    for preset in Preset::ALL {
        let map = CubeMap::new(pictures.clone().map(LazyImage::ready), preset.lookup(), CubeFilter::Bilinear);
        for direction in scattered_directions().into_iter().filter(|direction| direction.is_finite()) {
            let point = map.lookup().locate(direction);
            let down = if map.lookup().v_origin() == VOrigin::Top { point.v } else { 1.0 - point.v };
            let (x, y) = (f64::from(point.u) * 5.0 - 0.5, f64::from(down) * 5.0 - 0.5);
            let picture = &pictures[map.lookup().row(point.face).image.index()];
            let texel =
                |x: f64, y: f64| picture.texel(x.clamp(0.0, 4.0) as usize, y.clamp(0.0, 4.0) as usize).as_dvec3();
            let (left, top) = (x.floor(), y.floor());
            let mix = |row: f64| texel(left, row) * (1.0 - (x - left)) + texel(left + 1.0, row) * (x - left);
            let expected = mix(top) * (1.0 - (y - top)) + mix(top + 1.0) * (y - top);
            let found = map.sample(direction).as_dvec3();
            assert!((found - expected).abs().max_element() < 1e-5, "{preset:?} {direction}: {found}, not {expected}");
        }
    }
}

#[test]
fn a_sample_decodes_what_it_reaches_and_is_black_where_that_fails() {
    let images = std::array::from_fn(|image| {
        let decode = move || if image == 2 { Err(Error::new("damaged")) } else { Ok(noise(4, 4, false, image as u32)) };
        LazyImage::new(Box::new(decode))
    });
    let map = CubeMap::new(images, Preset::Opengl.lookup(), CubeFilter::Bilinear);
    let colours = [Vec3::X, Vec3::Y, Vec3::X].map(|direction| map.sample(direction));
    assert_eq!(map.looked_at(), [Face::PosX, Face::PosY]);
    assert_eq!((map.errors().count(), colours[1]), (1, Vec3::ZERO));
    assert!(colours[0] == colours[2] && colours[0] != Vec3::ZERO);
}

/// The table that students read is the one that the tracer uses.
#[test]
fn the_presets_are_the_table_of_the_conventions() {
    let page = include_str!("conventions.md").replace('\u{2212}', "-");
    let rows: Vec<Vec<&str>> = page.lines().map(|line| line.split('|').map(str::trim).collect()).collect();
    for preset in [Preset::Opengl, Preset::Exercise, Preset::Course] {
        let name = format!("`{}`", preset.name());
        let row = rows.iter().find(|row| row.len() == 10 && row[1] == name).expect("a row of eight cells");
        let lookup = preset.lookup();
        assert_eq!(row[2], if lookup.v_origin() == VOrigin::Top { "top" } else { "bottom" }, "{name}");
        for face in Face::ALL {
            let FaceLookup { image, u, v } = lookup.row(face);
            assert_eq!((row[3 + face.index()], image), (format!("{u}, {v}").as_str(), face), "{name}");
        }
    }
}
