//! Errors against a sky in closed form: smooth, with waves of a chosen frequency on it in three directions.

use std::f64::consts::PI;

use skycube::envmap::{
    CubeFilter, CubeMap, Equirectangular, Face, LazyImage, Lookup, Preset, SignedAxis, Sky, equirectangular_image,
    face_image,
};
use skycube::math::functions::{cos, sin};
use skycube::math::{DVec3, Vec3};
use skycube::picture::{Format, Header, Picture, Raster, Texels};

const UP: SignedAxis = SignedAxis::POS_Y;

/// The colour of the sky; `frequency` counts radians a radian.
fn sky(direction: DVec3, frequency: f64) -> Vec3 {
    let d = direction.normalize();
    let wave = |x: f64, y: f64, z: f64| 0.3 * sin(frequency * d.dot(DVec3::new(x, y, z)) / 3.0);
    let smooth = 1.0 + 0.3 * d.x * d.y + 0.2 * d.z;
    let waves = wave(1.0, 2.0, 2.0) + wave(2.0, -1.0, 2.0) + wave(2.0, 2.0, -1.0);
    Vec3::new((smooth + waves) as f32, smooth as f32, (0.5 * smooth - 0.3 * waves) as f32)
}

/// A picture whose texels are means of 64 samples of the sky.
fn exact([width, height]: [usize; 2], frequency: f64, direction: impl Fn(f64, f64) -> DVec3) -> Raster {
    Raster::from_function(width, height, |x, y| {
        let place = |index: usize, count: usize| (index as f64 + 0.5) / (8 * count) as f64;
        let sample = |i: usize| sky(direction(place(8 * x + i % 8, width), place(8 * y + i / 8, height)), frequency);
        (0..64).map(sample).sum::<Vec3>() / 64.0
    })
}

fn exact_panorama(height: usize, frequency: f64) -> Raster {
    exact([2 * height, height], frequency, |u, v| {
        // Longitude from -z over +x, latitude from +y down.
        let (longitude, radius) = (2.0 * PI * u, sin(PI * v));
        DVec3::new(radius * sin(longitude), cos(PI * v), -radius * cos(longitude))
    })
}

fn lookup() -> Lookup {
    Preset::HumusYUp.lookup()
}

fn exact_face(face: Face, side: usize, frequency: f64) -> Raster {
    exact([side, side], frequency, |right, down| lookup().image_direction(face, right, down))
}

fn picture(raster: &Raster) -> Picture {
    let header =
        Header { width: raster.width(), height: raster.height(), format: Format::Exr, bit_depth: 32, alpha: false };
    Picture::new(header, Texels::Linear(raster.pixels().to_vec()))
}

fn sky_of(panorama: &Raster) -> Sky {
    Sky::of_equirectangular(&picture(panorama), UP, 0.0)
}

/// A cube map of images as its faces read them.
fn cube_map(faces: impl Fn(Face) -> Raster) -> CubeMap {
    let images = Face::ALL.map(|image| {
        let reads = |face: &Face| lookup().row(*face).image == image;
        let face = Face::ALL.into_iter().find(reads).unwrap();
        LazyImage::ready(picture(&faces(face)))
    });
    CubeMap::new(images, lookup(), CubeFilter::Bilinear)
}

/// The root mean square difference.
fn error(one: &Raster, other: &Raster) -> f64 {
    let squares = one.pixels().iter().zip(other.pixels()).map(|(a, b)| f64::from((*a - *b).length_squared()));
    (squares.sum::<f64>() / one.pixels().len() as f64).sqrt()
}

/// The errors of a face of a panorama: by `face_image`, and by one bilinear sample in the middle of each texel.
fn errors(face: Face, panorama: &Raster, side: usize, frequency: f64) -> [f64; 2] {
    let exact = exact_face(face, side, frequency);
    let map = Equirectangular { image: LazyImage::ready(picture(panorama)), up: UP, turns: 0.0 };
    let bilinear = Raster::from_function(side, side, |x, y| {
        let place = |index: usize| (index as f64 + 0.5) / side as f64;
        map.sample(lookup().image_direction(face, place(x), place(y)).normalize())
    });
    [face_image(&sky_of(panorama), &lookup(), face, side), bilinear].map(|image| error(&image, &exact))
}

/// What is left is the blur of the panorama's own texels, each a mean: half of a bilinear sample's error where the waves are
/// finest, and where many samples lie in a texel, around the poles; a third or less elsewhere.
#[test]
fn faces_of_a_panorama_are_nearer_to_the_truth_than_bilinear_samples() {
    for frequency in [10.0, 20.0, 40.0] {
        let panorama = exact_panorama(128, frequency);
        for face in [Face::PosX, Face::PosY, Face::NegZ] {
            let [ours, bilinear] = errors(face, &panorama, 64, frequency);
            assert!(ours < 0.5 * bilinear, "{frequency} {}: {ours} {bilinear}", face.name());
        }
    }
}

/// A wave of a fifth of a texel is grey: samples in the middle of texels show another wave instead.
#[test]
fn what_is_too_fine_becomes_its_mean() {
    let panorama = exact_panorama(256, 120.0);
    for face in [Face::PosX, Face::PosY] {
        let [ours, bilinear] = errors(face, &panorama, 8, 120.0);
        assert!(bilinear > 0.2 && ours < 0.02, "{}: {ours} {bilinear}", face.name());
    }
}

/// The poles lie in the middle of +Y and -Y, the border of the picture runs down the middle of -Z.
#[test]
fn poles_and_seam_are_no_worse_than_elsewhere() {
    let (side, frequency) = (64, 20.0);
    let sky = sky_of(&exact_panorama(128, frequency));
    let worst = |face: Face, chosen: &dyn Fn(usize, usize) -> bool| {
        let (image, exact) = (face_image(&sky, &lookup(), face, side), exact_face(face, side, frequency));
        let places = (0..side).flat_map(|y| (0..side).map(move |x| (x, y))).filter(|&(x, y)| chosen(x, y));
        places.map(|(x, y)| (image.pixel(x, y) - exact.pixel(x, y)).abs().max_element()).fold(0.0, f32::max)
    };
    let middle = |place: usize| (side / 2 - 3..side / 2 + 3).contains(&place);
    let elsewhere = worst(Face::PosX, &|_, _| true);
    for pole in [Face::PosY, Face::NegY] {
        assert!(worst(pole, &|x, y| middle(x) && middle(y)) <= 1.2 * elsewhere, "{}", pole.name());
    }
    assert!(worst(Face::NegZ, &|x, _| middle(x)) <= 1.2 * elsewhere);
}

#[test]
fn faces_return_from_a_panorama() {
    let frequency = 20.0;
    let faces = cube_map(|face| exact_face(face, 64, frequency));
    let panorama = equirectangular_image(&Sky::of_cube_map(faces).unwrap(), UP, 0.0, 128);
    let there = error(&panorama, &exact_panorama(128, frequency));
    let back = sky_of(&panorama);
    let worst = Face::ALL.map(|face| error(&face_image(&back, &lookup(), face, 64), &exact_face(face, 64, frequency)));
    let worst = worst.into_iter().fold(0.0, f64::max);
    assert!(there < 0.004 && worst < 0.008, "{there} {worst}");
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let sky = sky_of(&exact_panorama(32, 10.0));
    let image = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| face_image(&sky, &lookup(), Face::PosY, 16))
    };
    assert_eq!(image(1), image(4));
}

/// The same places as the scene's own reading of such pictures.
#[test]
fn a_turned_panorama_lies_as_in_a_scene() {
    let panorama = exact_panorama(64, 4.0);
    for (up, turns) in [("+y", 0.0), ("+z", 0.25), ("-x", 0.6)] {
        let up: SignedAxis = up.parse().unwrap();
        let map = Equirectangular { image: LazyImage::ready(picture(&panorama)), up, turns };
        let sky = Sky::of_equirectangular(&picture(&panorama), up, f64::from(turns));
        for d in [DVec3::new(1.0, 0.2, -0.7), DVec3::new(-0.1, 0.9, 0.3), DVec3::new(0.2, 0.1, -1.0), DVec3::NEG_Y] {
            assert!(sky.colour(d).abs_diff_eq(map.sample(d.normalize()), 0.01), "{up} {d}");
        }
    }
}
