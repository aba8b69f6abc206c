//! Pictures on the faces of a cube map: tiny, huge, and with texels of any brightness.

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, faults_of, worst_of};
use crate::envmap::{CubeFilter, CubeMap, Face, LazyImage, Lookup, Preset};
use crate::limits::{FACE_SIZE, Range};
use crate::math::Vec3;
use crate::picture::{Format, Header, Picture, Texels};
use crate::random::Random;

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Lookup,
        name: "texels",
        swept: "texels along a face",
        error: "position that the bilinear filter reads, in texels",
        unit: "texel",
        bound: 1.0 / 256.0,
        promised: FACE_SIZE.range,
        sweep: texels,
    },
    Subject {
        group: Group::Lookup,
        name: "seams",
        swept: "texels along a face",
        error: "step of the seamless filter across edges and corners, of full contrast",
        unit: "",
        bound: 1.0 / 256.0,
        promised: Range::new(1.0, 256.0),
        sweep: seams,
    },
    Subject {
        group: Group::Lookup,
        name: "brightness",
        swept: "brightness of texels",
        error: "colours not between those of the texels around, per million, all filters",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1e-30, 65_504.0),
        sweep: brightness,
    },
    Subject {
        group: Group::Lookup,
        name: "bad-texels",
        swept: "texels from a bad one",
        error: "colours that are not numbers beyond the reach of the filter, per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1.0, 100.0),
        sweep: bad_texels,
    },
];

/// A cube map of float pictures; `texel` tells the colour from image, column and row.
pub(super) fn cube_map(
    [width, height]: [usize; 2],
    lookup: Lookup,
    filter: CubeFilter,
    texel: impl Fn(usize, usize, usize) -> Vec3,
) -> CubeMap {
    let image = |image: Face| {
        let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        let colours = places.map(|(column, row)| texel(image.index(), column, row)).collect();
        let header = Header { width, height, format: Format::Exr, bit_depth: 32, alpha: false };
        LazyImage::ready(Picture::new(header, Texels::Linear(colours)))
    };
    CubeMap::new(Face::ALL.map(image), lookup, filter)
}

/// A direction to a place of a face, `across` and `up` in `[-1, 1]` along its axes of u and v.
fn towards(lookup: &Lookup, face: Face, across: f32, up: f32) -> Vec3 {
    let row = lookup.row(face);
    face.normal() + row.u.direction() * across + row.v.direction() * up
}

/// Faces of two rows whose colour is the number of the column: what is read tells where. Six whole faces of 16384 texels a
/// side would take 19 GB; the arithmetic is that of any height.
fn texels(effort: Effort) -> Vec<Measurement> {
    let lookup = Preset::Opengl.lookup();
    let of_size = |size: usize| {
        // Counted from the middle, so that the numbers themselves are exact.
        let middle = size as f32 / 2.0;
        let map =
            cube_map([size, 2], lookup, CubeFilter::Bilinear, |_, column, _| Vec3::splat(column as f32 + 0.5 - middle));
        let (error, across) = worst_of(effort.share(5e-4), size as u64, |random| {
            let across = (2.0 * random.unit() - 1.0) as f32;
            let direction = towards(&lookup, Face::ALL[random.below(6)], across, random.unit() as f32 * 0.9);
            let truth = (f64::from(across) * size as f64 / 2.0).abs().min((size as f64 - 1.0) / 2.0);
            ((f64::from(map.sample(direction).x.abs()) - truth).abs(), across)
        });
        Measurement::new(size as f64, error, format!("u axis at {across:.6}"))
    };
    (0..=19).map(|power| of_size(1 << power)).collect()
}

/// Just beside an edge of the cube, on either side.
fn seams(effort: Effort) -> Vec<Measurement> {
    let of_size = |size: usize| {
        let mut random = Random(size as u64);
        let noise: Vec<f32> = (0..6 * size * size).map(|_| random.unit() as f32).collect();
        let map = cube_map([size, size], Preset::Course.lookup(), CubeFilter::Seamless, |image, column, row| {
            Vec3::splat(noise[(image * size + row) * size + column])
        });
        let (error, along) = worst_of(effort.share(2e-4), size as u64, |random| {
            let (first, second) = (random.below(3), random.below(2));
            let second = (first + 1 + second) % 3;
            let along = if random.unit() < 0.1 { 1.0 } else { (2.0 * random.unit() - 1.0) as f32 };
            let mut direction = Vec3::splat(along);
            direction[first] = if random.unit() < 0.5 { -1.0 } else { 1.0 };
            direction[second] = 1.0;
            let mut beside = direction;
            beside[second] = 1.0_f32.next_up();
            direction[second] = 1.0_f32.next_down();
            (f64::from((map.sample(direction) - map.sample(beside)).abs().max_element()), along)
        });
        Measurement::new(size as f64, error, format!("along the edge {along:.6}"))
    };
    (0..=9).map(|power| of_size(1 << power)).collect()
}

/// Texels of one brightness and black ones.
fn brightness(effort: Effort) -> Vec<Measurement> {
    let filters = [CubeFilter::Nearest, CubeFilter::Bilinear, CubeFilter::Seamless];
    let of_value = |value: f64| {
        let bright = value as f32;
        let maps = filters.map(|filter| {
            cube_map([4, 4], Preset::Course.lookup(), filter, |image, column, row| {
                Vec3::new(bright, if (image + column + row) % 2 == 0 { bright } else { 0.0 }, 0.0)
            })
        });
        let (faults, first) = faults_of(effort.share(2e-4), value.to_bits(), |random| {
            let filter = random.below(3);
            let direction = random.direction().as_vec3();
            let colour = maps[filter].sample(direction);
            // Red is the same everywhere, to the rounding of the weights.
            let even = (f64::from(colour.x) / f64::from(bright) - 1.0).abs() < 1e-6 || bright < 1e-37;
            let between = (0.0..=bright * 1.000_001).contains(&colour.y) && colour.z == 0.0;
            (!(even && between && colour.is_finite())).then_some(filters[filter])
        });
        let input = first.map_or("none".to_owned(), |filter| format!("{filter:?}").to_lowercase());
        Measurement::new(value, faults, input)
    };
    let mut values: Vec<f64> = decades(-45, 38).step_by(3).chain([65_504.0, f64::from(f32::MAX)]).collect();
    values.sort_by(f64::total_cmp);
    values.into_iter().map(of_value).collect()
}

/// One texel of infinity or NaN in the middle of a face of 256 texels: it may spoil what reads it, and nothing else.
fn bad_texels(effort: Effort) -> Vec<Measurement> {
    let lookup = Preset::Opengl.lookup();
    let maps = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY].map(|bad| {
        cube_map([256, 256], lookup, CubeFilter::Bilinear, |image, column, row| {
            Vec3::splat(if (image, column, row) == (0, 128, 128) { bad } else { 1.0 })
        })
    });
    let of_distance = |texels: f64| {
        let (faults, first) = faults_of(effort.share(2e-4), texels.to_bits(), |random| {
            // Texel 128 covers 0 to 1/128 of the half face; its middle is at half of that.
            let angle = crate::math::functions::sin_cos_turns(random.unit());
            let away = (texels + 0.01) / angle.0.abs().max(angle.1.abs());
            let place = |offset: f64| ((0.5 + offset * away) / 128.0) as f32;
            let direction = towards(&lookup, Face::PosX, place(angle.0), place(angle.1));
            let map = random.below(3);
            (!maps[map].sample(direction).is_finite()).then_some(map)
        });
        Measurement::new(texels, faults, first.map_or("none", |map| ["NaN", "infinity", "-infinity"][map]))
    };
    [0.5, 1.0, 2.0, 4.0, 10.0, 30.0, 100.0].into_iter().map(of_distance).collect()
}
