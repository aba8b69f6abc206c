//! The sky: an equirectangular picture of clouds by fractal noise over directions.

use std::path::Path;

use skycube::error::Result;
use skycube::math::Vec3;
use skycube::math::functions::{cos, exponential, sin};

use crate::noise::{fractal, smoothstep};
use crate::paint::write_picture;

/// Direction towards the sun, of length 1 to a few hundredths.
pub const SUN: Vec3 = Vec3::new(0.56, 0.72, 0.41);

/// Writes `sky.png`. The middle column looks along -z, the columns to its right turn towards +x; up (+y) is the top.
pub fn write_sky(folder: &Path, width: usize) -> Result<()> {
    let height = width / 2;
    write_picture(&folder.join("sky.png"), width, height, |x, y| {
        let azimuth = f64::from(x / width as f32 - 0.5) * std::f64::consts::TAU;
        let polar = f64::from(y / height as f32) * std::f64::consts::PI;
        let (sine, height) = (sin(polar), cos(polar));
        sky_colour(Vec3::new((sine * sin(azimuth)) as f32, height as f32, (-sine * cos(azimuth)) as f32))
    })
}

fn sky_colour(direction: Vec3) -> Vec3 {
    let height = direction.y.max(0.0);
    let towards_sun = direction.dot(SUN.normalize()).max(0.0);
    let haze = exponential(-4.5 * height);
    let mut colour = Vec3::new(0.075, 0.20, 0.56).lerp(Vec3::new(0.50, 0.66, 0.86), haze);
    colour += Vec3::new(0.16, 0.14, 0.10) * exponential(9.0 * (towards_sun - 1.0));
    colour = add_cirrus(colour, direction, height);
    colour = add_cumulus(colour, direction, height, towards_sun);
    // The disc of the sun and its glow.
    colour + Vec3::new(1.0, 0.95, 0.85) * exponential(900.0 * (towards_sun - 1.0))
}

/// Thin high streaks, drawn out along one direction.
fn add_cirrus(colour: Vec3, direction: Vec3, height: f32) -> Vec3 {
    let plane = direction / (height + 0.22);
    let streak = Vec3::new(0.7 * plane.x + 0.5 * plane.z, 3.0, 2.6 * plane.z - 1.9 * plane.x);
    let bend = Vec3::new(0.0, 0.0, 0.8 * fractal(0.9 * plane, 3, 71));
    let density = smoothstep(0.0, 0.9, fractal(1.3 * streak + bend, 6, 60) + 0.3 * fractal(0.5 * plane, 2, 77));
    colour.lerp(Vec3::new(0.86, 0.90, 0.96), 0.42 * density * smoothstep(0.0, 0.25, height))
}

/// Heaped clouds in a layer seen in perspective, lit from the sun's side, grey below.
fn add_cumulus(colour: Vec3, direction: Vec3, height: f32, towards_sun: f32) -> Vec3 {
    let layer = direction / (height + 0.16);
    let density = cumulus_density(layer);
    let cover = smoothstep(0.05, 0.26, density);
    if cover <= 0.0 {
        return colour;
    }
    let sunward = 0.10 * Vec3::new(SUN.x, 0.0, SUN.z);
    let thickness = smoothstep(0.05, 0.9, density);
    let relief = 2.2 * (density - cumulus_density(layer + sunward));
    let light = (0.74 - 0.46 * thickness + relief + 0.12 * towards_sun).clamp(0.22, 1.0);
    let cloud = Vec3::new(0.36, 0.42, 0.53).lerp(Vec3::new(0.99, 0.97, 0.94), light);
    // Far clouds fade into the haze.
    let near = smoothstep(-0.02, 0.2, height);
    colour.lerp(cloud.lerp(colour, 0.55 * (1.0 - near)), cover * (0.3 + 0.7 * near))
}

fn cumulus_density(layer: Vec3) -> f32 {
    let layer = Vec3::new(layer.x, 0.0, layer.z);
    let warp = 0.35 * Vec3::new(fractal(1.1 * layer, 3, 11), 0.0, fractal(1.1 * layer + Vec3::splat(9.0), 3, 12));
    let large = fractal(0.55 * layer + Vec3::new(3.1, 0.0, 1.7), 2, 21);
    let heaps = fractal(2.3 * (layer + warp) + Vec3::new(0.4, 1.0, 5.2), 7, 31);
    0.85 * heaps + 0.5 * large + 0.02
}
