//! Environments that the tests draw from.

use skycube::envmap::{
    CubeFilter, CubeMap, Environment, EnvironmentKind, Equirectangular, Face, FaceLookup, Gradient, LazyImage, Lookup,
    Preset, SignedAxis, VOrigin,
};
use skycube::math::Vec3;
use skycube::picture::{Format, Header, Picture, Texels};
use skycube::stress::Random;

/// A picture of floats.
pub fn picture(width: usize, height: usize, mut colour: impl FnMut(usize, usize) -> Vec3) -> Picture {
    let header = Header { width, height, format: Format::Exr, bit_depth: 32, alpha: false };
    let texels = (0..width * height).map(|index| colour(index % width, index / width)).collect();
    Picture::new(header, Texels::Linear(texels))
}

/// Every lookup that matters: the presets, and one in which images change places.
pub fn lookups() -> Vec<(String, Lookup)> {
    let mut lookups: Vec<_> = Preset::ALL.map(|preset| (preset.name().to_owned(), preset.lookup())).into();
    let images = [Face::PosZ, Face::NegY, Face::NegX, Face::PosX, Face::PosX, Face::NegZ];
    let rows = std::array::from_fn(|face| {
        let row = Preset::Course.lookup().rows()[face];
        FaceLookup { image: images[face], u: row.v, v: -row.u }
    });
    lookups.push(("of the user".to_owned(), Lookup::new(rows, VOrigin::Top).unwrap()));
    lookups
}

/// A cube map of texels told by image, column and row.
pub fn cube(
    size: usize,
    lookup: Lookup,
    filter: CubeFilter,
    mut colour: impl FnMut(usize, usize, usize) -> Vec3,
) -> Environment {
    let images = std::array::from_fn(|image| LazyImage::ready(picture(size, size, |x, y| colour(image, x, y))));
    environment(EnvironmentKind::CubeMap(Box::new(CubeMap::new(images, lookup, filter))))
}

/// Uneven texels, a third of them black.
pub fn noise(seed: u64) -> impl FnMut() -> Vec3 {
    let mut random = Random(seed);
    move || match random.below(3) {
        0 => Vec3::ZERO,
        _ => Vec3::new(random.unit() as f32, random.unit().powi(4) as f32 * 8.0, random.unit() as f32),
    }
}

pub fn noise_cube(size: usize, lookup: Lookup, filter: CubeFilter) -> Environment {
    let mut texel = noise(size as u64);
    cube(size, lookup, filter, |_, _, _| texel())
}

pub fn panorama(
    width: usize,
    height: usize,
    up: SignedAxis,
    turns: f32,
    colour: impl FnMut(usize, usize) -> Vec3,
) -> Environment {
    let image = LazyImage::ready(picture(width, height, colour));
    environment(EnvironmentKind::Equirectangular(Equirectangular { image, up, turns }))
}

pub fn gradient(up: SignedAxis, [zenith, horizon, nadir]: [f32; 3]) -> Environment {
    let [zenith, horizon, nadir] = [zenith, horizon, nadir].map(|grey| Vec3::new(grey, grey * 0.5, grey * 2.0));
    environment(EnvironmentKind::Gradient(Gradient { up, zenith, horizon, nadir }))
}

pub fn environment(kind: EnvironmentKind) -> Environment {
    Environment { kind, scale: 1.0 }
}
