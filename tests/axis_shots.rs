//! The exercise's own test: six shots along the axes show the right face the right way up.

mod common;

use std::path::Path;

use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Environment, EnvironmentKind, Face, Preset, SignedAxis};
use skycube::picture::{OutputFormat, Picture, Raster, WriteOptions, decode, encode};
use skycube::render::{AxisShot, Silent, render};
use skycube::scene::Plan;

use Face::{NegX, NegY, NegZ, PosX, PosY, PosZ};

/// The renaming in `envmap/conventions.md`: the image that each shot shows as it is in the file, in a z-up world through
/// `humus-z-up`.
const Z_UP: [(Face, Face); 6] = [(PosX, PosX), (NegX, NegX), (PosY, PosZ), (NegY, NegZ), (PosZ, PosY), (NegZ, NegY)];

/// In a y-up world through `humus-y-up`: the camera's forward -z reads posz and +z reads negz. The others keep
/// their names, and all six stand as in the file. +y by hand: `opengl` lays posy with u along +x and v (down) along
/// +z; for the direction (x, y, -z) that is right = +x and down = -z, so the top of the image lies at +z, which is the
/// up of that shot, and its right is +y x +z = +x.
const Y_UP: [(Face, Face); 6] = [(PosX, PosX), (NegX, NegX), (PosY, PosY), (NegY, NegY), (PosZ, NegZ), (NegZ, PosZ)];

fn shot(skybox: &Skybox, preset: Preset, filter: CubeFilter, shot: AxisShot, size: usize) -> Raster {
    let map = CubeMap::from_skybox(skybox, preset.lookup(), filter);
    let environment = Environment { kind: EnvironmentKind::CubeMap(Box::new(map)), scale: 1.0 };
    let scene = shot.scene(environment, size);
    render(&scene, &Plan::new(&scene), &Silent).unwrap().raster
}

/// The pixels after writing to a PNG file and reading it again.
fn as_file(raster: &Raster) -> Picture {
    let encoded = encode(raster, OutputFormat::Png, &WriteOptions::default()).unwrap();
    decode(&encoded, Path::new("shot.png")).unwrap()
}

/// Every shot against the file of the image it should show, pixel for pixel.
fn assert_shows_the_files(preset: Preset, world_up: SignedAxis, expected: [(Face, Face); 6]) {
    let compass = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass");
    let skybox = Skybox::open(&compass).unwrap();
    for (direction, image) in expected {
        let file = skybox.image(image).decode().unwrap();
        let raster = shot(&skybox, preset, CubeFilter::Nearest, AxisShot::new(direction, world_up), file.width());
        let seen = as_file(&raster);
        assert!(seen.texels() == file.texels(), "{direction:?} does not show {image:?} as it is in the file");
    }
}

#[test]
fn humus_z_up_shows_each_file_as_it_is() {
    assert_shows_the_files(Preset::HumusZUp, SignedAxis::POS_Z, Z_UP);
}

#[test]
fn humus_y_up_shows_each_file_as_it_is() {
    assert_shows_the_files(Preset::HumusYUp, SignedAxis::POS_Y, Y_UP);
}

/// The mean of the picture over squares of `side` texels, linear.
fn reduced(picture: &Picture, side: usize) -> Raster {
    let mean = |column: usize, row: usize| {
        let texels = (0..side * side).map(|k| picture.texel(column * side + k % side, row * side + k / side));
        texels.sum::<skycube::math::Vec3>() / (side * side) as f32
    };
    Raster::from_function(picture.width() / side, picture.height() / side, mean)
}

/// A shot of two pixels for each eight texels' side looks at places between texels; what it shows is compared in
/// coarse squares, where a turned or mirrored picture is far away.
#[test]
fn a_download_is_seen_upright_and_not_mirrored() {
    seen_upright(&common::project("envmaps/hall"), CubeFilter::Nearest);
}

#[test]
fn a_large_download_is_seen_upright_and_not_mirrored() {
    common::shared_map("Meadow.zip").iter().for_each(|map| seen_upright(map, CubeFilter::Bilinear));
}

fn seen_upright(map: &Path, filter: CubeFilter) {
    let skybox = Skybox::open(map).unwrap();
    for (preset, world_up, expected) in
        [(Preset::HumusZUp, SignedAxis::POS_Z, Z_UP), (Preset::HumusYUp, SignedAxis::POS_Y, Y_UP)]
    {
        for (direction, image) in expected {
            let seen = shot(&skybox, preset, filter, AxisShot::new(direction, world_up), 512);
            let seen = reduced(&as_file(&seen), 16);
            let file = skybox.image(image).decode().unwrap();
            let file = reduced(&file, file.width() / 32);
            let difference = |place: fn(usize, usize) -> (usize, usize)| {
                let step = |k: usize| {
                    let (x, y) = place(k % 32, k / 32);
                    (seen.pixel(k % 32, k / 32) - file.pixel(x, y)).abs().element_sum() / 3.0
                };
                (0..32 * 32).map(step).sum::<f32>() / 1024.0
            };
            let upright = difference(|x, y| (x, y));
            let mirrored = difference(|x, y| (31 - x, y));
            let upside_down = difference(|x, y| (x, 31 - y));
            let turned = difference(|x, y| (y, 31 - x));
            println!("{direction:?}: {upright} against {mirrored} {upside_down} {turned}");
            assert!(upright < 0.002, "{direction:?} through {}: {upright}", preset.name());
            assert!(mirrored.min(upside_down).min(turned) > 3.0 * upright, "{direction:?} decides nothing");
        }
    }
}
