//! Textures: pictures computed texel by texel, and palettes.

use std::path::Path;

use rayon::prelude::*;
use skycube::colour::encode_srgb;
use skycube::error::Result;
use skycube::math::{Vec2, Vec3};
use skycube::picture::{Samples, write_png};

/// Writes a picture whose linear colour is a function of column and row.
pub fn write_picture(file: &Path, width: usize, height: usize, colour: impl Fn(f32, f32) -> Vec3 + Sync) -> Result<()> {
    let row = |y: usize| {
        let colour = &colour;
        (0..width).flat_map(move |x| {
            colour(x as f32 + 0.5, y as f32 + 0.5).to_array().map(|channel| (255.0 * encode_srgb(channel) + 0.5) as u8)
        })
    };
    let bytes: Vec<u8> = (0..height).into_par_iter().flat_map_iter(row).collect();
    write_png(file, width, height, Samples::Rgb8(&bytes))
}

/// Colours of a material in variants: u picks the variant, v the light that reaches it (0 dark, 1 open).
pub struct Palette {
    pub name: &'static str,
    pub colours: &'static [[u8; 3]],
}

impl Palette {
    /// Texture coordinates of a variant under some light.
    pub fn at(&self, variant: usize, light: f32) -> Vec2 {
        let count = self.colours.len();
        Vec2::new(((variant % count) as f32 + 0.5) / count as f32, light.clamp(0.02, 0.98))
    }

    pub fn write(&self, folder: &Path) -> Result<()> {
        const BLOCK: usize = 8;
        const ROWS: usize = 64;
        write_picture(&folder.join(self.name).with_extension("png"), BLOCK * self.colours.len(), ROWS, |x, y| {
            let light = 1.0 - y / ROWS as f32;
            srgb(self.colours[x as usize / BLOCK]) * (0.22 + 0.78 * light)
        })
    }
}

/// A linear colour from sRGB codes.
pub fn srgb(codes: [u8; 3]) -> Vec3 {
    skycube::colour::decode_srgb8(codes)
}

pub const STONE: Palette = Palette {
    name: "stone",
    colours: &[
        [142, 134, 122],
        [126, 121, 114],
        [158, 149, 133],
        [116, 108, 98],
        [149, 132, 112],
        [134, 130, 126],
        [105, 101, 97],
        [168, 158, 144],
        [139, 117, 97],
        [121, 122, 104],
    ],
};
pub const LEAF: Palette = Palette {
    name: "leaf",
    colours: &[
        [88, 128, 44],
        [72, 112, 38],
        [104, 142, 54],
        [60, 98, 36],
        [122, 152, 62],
        [80, 118, 52],
        [134, 150, 58],
        [66, 106, 48],
    ],
};
pub const GRASS: Palette = Palette {
    name: "grass",
    colours: &[[108, 142, 58], [92, 128, 48], [130, 152, 70], [82, 116, 46], [148, 154, 82], [100, 136, 64]],
};
pub const WOOD: Palette = Palette {
    name: "wood",
    colours: &[
        [122, 88, 58],
        [104, 76, 52],
        [138, 104, 72],
        [92, 70, 54],
        [46, 82, 76],
        [58, 96, 88],
        [226, 218, 200],
        [110, 44, 36],
    ],
};
pub const ROOF: Palette = Palette {
    name: "roof",
    colours: &[
        [172, 88, 58],
        [156, 76, 52],
        [184, 102, 70],
        [140, 70, 50],
        [166, 96, 72],
        [126, 78, 60],
        [190, 116, 82],
        [148, 104, 80],
    ],
};
pub const FLOWER: Palette = Palette {
    name: "flower",
    colours: &[[206, 48, 52], [226, 92, 120], [236, 190, 60], [238, 232, 226], [128, 84, 176], [222, 118, 44]],
};
pub const CLAY: Palette =
    Palette { name: "clay", colours: &[[178, 102, 68], [160, 90, 62], [74, 96, 128], [190, 176, 150]] };
pub const PALETTES: [Palette; 7] = [STONE, LEAF, GRASS, WOOD, ROOF, FLOWER, CLAY];
