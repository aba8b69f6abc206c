//! All pictures of the scene.

use std::path::Path;

use skycube::error::Result;
use skycube::math::Vec3;

use crate::facades::write_sign;
use crate::ground::{write_land, write_soil};
use crate::noise::fractal;
use crate::paint::{PALETTES, srgb, write_picture};
use crate::sky::write_sky;
use crate::yard::facades;

pub fn write(folder: &Path) -> Result<()> {
    for palette in &PALETTES {
        palette.write(folder)?;
    }
    for facade in facades() {
        facade.write(folder)?;
    }
    write_sign(folder)?;
    write_soil(folder)?;
    write_land(folder)?;
    write_bark(folder)?;
    write_pane(folder)?;
    write_sky(folder, 4096)
}

/// Bark: ridges along the branch (v).
fn write_bark(folder: &Path) -> Result<()> {
    write_picture(&folder.join("bark.png"), 512, 512, |x, y| {
        let ridges = fractal(Vec3::new(0.09 * x, 0.0, 0.012 * y), 5, 111);
        srgb([104, 88, 70]).lerp(srgb([58, 48, 40]), 0.5 - 0.7 * ridges)
    })
}

/// Window glass as it looks in daylight: a dark room behind, a curtain, a faint picture of the sky.
fn write_pane(folder: &Path) -> Result<()> {
    write_picture(&folder.join("pane.png"), 512, 512, |x, y| {
        let (u, v) = (x / 512.0, 1.0 - y / 512.0);
        let cloud = fractal(Vec3::new(3.0 * u, 0.0, 3.0 * v), 5, 121);
        let sky = Vec3::new(0.16, 0.24, 0.36) + Vec3::splat(0.16) * cloud.max(0.0);
        let room = Vec3::new(0.02, 0.02, 0.025) + Vec3::splat(0.01) * fractal(Vec3::new(9.0 * u, 0.0, 7.0 * v), 3, 122);
        let skyline = 0.45 + 0.12 * fractal(Vec3::new(4.0 * u, 0.0, 0.0), 3, 123);
        let reflection = crate::noise::smoothstep(skyline - 0.01, skyline + 0.03, v);
        room.lerp(sky, 0.15 + 0.75 * reflection)
    })
}
