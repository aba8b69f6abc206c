//! Maps computed from the direction: skies with hardly anything in them.

use skycube::envmap::{Face, FacePoint, Preset};
use skycube::math::Vec3;
use skycube::stress::Random;

use super::pictures::{Map, computed};

/// A map whose display colours are a function of the direction, rounded to whole codes after noise of this amplitude.
pub fn from_directions(size: usize, noise: f64, colour: impl Fn(Vec3) -> [f32; 3]) -> Map {
    let lookup = Preset::Opengl.lookup();
    let picture = |face: Face| {
        let mut random = Random(face.index() as u64 + 1);
        let mut dither = Vec::new();
        dither.resize_with(3 * size * size, || (random.unit() + random.unit() + random.unit() - 1.5) * noise);
        computed(size, |x, y| {
            let centre = |index: usize| (index as f32 + 0.5) / size as f32;
            let direction = lookup.direction(FacePoint { face, u: centre(x), v: centre(y) }).normalize();
            let channels = colour(direction);
            std::array::from_fn(|channel| channels[channel] + dither[3 * (y * size + x) + channel] as f32)
        })
    };
    Map::new(Face::ALL.map(picture))
}

/// A sky that grows brighter upwards, and a little redder towards +x.
pub fn gradient(size: usize, amplitude: f32, noise: f64) -> Map {
    from_directions(size, noise, |d| {
        let height = amplitude * d.y;
        [100.0 + height + 0.3 * amplitude * d.x, 120.0 + height + 0.2 * amplitude * d.z, 180.0 + 0.5 * height]
    })
}

/// A clear sky that fades from the horizon upwards, alike all around.
pub fn fading(size: usize, amplitude: f32, noise: f64) -> Map {
    from_directions(size, noise, |d| {
        let haze = amplitude * (1.0 - d.y.abs()).powi(3) + if d.y < 0.0 { 0.4 * amplitude * d.y } else { 0.0 };
        [110.0 + haze, 140.0 + haze, 190.0 + 0.5 * haze]
    })
}

/// A glow around a sun that stands at no axis, and nothing else.
pub fn glow(size: usize, amplitude: f32, noise: f64) -> Map {
    let sun = Vec3::new(0.5, 0.35, 0.8).normalize();
    from_directions(size, noise, |d| {
        let near = 0.5 + 0.5 * d.dot(sun);
        let light = amplitude * near * near * near;
        [120.0 + light, 130.0 + light, 160.0 + 0.7 * light]
    })
}

/// Stars on the sphere, a texel and a half wide each, on black: those at a seam are seen on both faces.
pub fn starry(size: usize, count: usize) -> Map {
    let mut random = Random(9);
    let stars: Vec<(Vec3, f32)> =
        (0..count).map(|_| (random.direction().as_vec3(), 60.0 + 600.0 * random.unit().powi(3) as f32)).collect();
    let width = 1.5 / size as f32;
    // By cells of the cube around [-1, 1]^3, so that a texel looks at the stars nearby only.
    let cells = 24;
    let cell = |value: f32| (((value + 1.0) / 2.0 * cells as f32) as usize).min(cells - 1);
    let mut grid = vec![Vec::new(); cells * cells * cells];
    for &(star, brightness) in &stars {
        let reach = 4.0 * width;
        let range = |value: f32| cell(value - reach)..=cell(value + reach);
        for (x, y) in range(star.x).flat_map(|x| range(star.y).map(move |y| (x, y))) {
            for z in range(star.z) {
                grid[(x * cells + y) * cells + z].push((star, brightness));
            }
        }
    }
    from_directions(size, 1.0, |d| {
        let near = &grid[(cell(d.x) * cells + cell(d.y)) * cells + cell(d.z)];
        let light = |&(star, brightness): &(Vec3, f32)| {
            brightness * (-(d - star).length_squared() / (2.0 * width * width)).exp()
        };
        [4.0 + near.iter().map(light).sum::<f32>(); 3]
    })
}
