//! The layout that rows of RGB8 are measured against: tiles of 4 x 4 texels of four bytes, one cache line each.

use skycube::colour::decode_srgb8;
use skycube::math::Vec3;
use skycube::picture::{Footprint, Picture, Texels};

pub struct Tiles {
    width: usize,
    height: usize,
    tiles_across: usize,
    texels: Vec<Tile>,
}

#[derive(Clone, Copy)]
#[repr(align(64))]
struct Tile([[u8; 4]; 16]);

impl Tiles {
    pub fn new(picture: &Picture) -> Self {
        let Texels::Srgb8(bytes) = picture.texels() else { panic!("8-bit texels only") };
        let (width, height) = (picture.width(), picture.height());
        let tiles_across = width.div_ceil(4);
        let mut texels = vec![Tile([[0; 4]; 16]); tiles_across * height.div_ceil(4)];
        for (y, row) in bytes.chunks_exact(3 * width).enumerate() {
            for (x, texel) in row.chunks_exact(3).enumerate() {
                let tile = &mut texels[(y / 4) * tiles_across + x / 4];
                tile.0[(y % 4) * 4 + x % 4] = [texel[0], texel[1], texel[2], 255];
            }
        }
        Self { width, height, tiles_across, texels }
    }

    #[inline]
    pub fn bilinear(&self, x: f32, y: f32) -> Vec3 {
        Footprint::new(x, y, self.width, self.height).interpolate(|x, y| {
            let [r, g, b, _] = self.texels[(y / 4) * self.tiles_across + x / 4].0[(y % 4) * 4 + x % 4];
            decode_srgb8([r, g, b])
        })
    }
}
