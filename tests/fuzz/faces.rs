//! Six small pictures as bytes: the sides of each, and its texels.

use skycube::envmap::Face;
use skycube::picture::{Format, Header, Picture, Texels};

const SIDE: u8 = 16;

/// The map "compass", of 16 by 16 texels.
pub fn compass() -> Vec<u8> {
    let mut bytes = vec![SIDE - 1; 12];
    for face in Face::ALL {
        let file = format!("{}/envmaps/compass/{}.png", env!("CARGO_MANIFEST_DIR"), face.name());
        let picture = skycube::picture::read(file.as_ref()).unwrap();
        let step = picture.width() / usize::from(SIDE);
        let Texels::Srgb8(texels) = picture.texels() else { unreachable!("PNG of 8 bits") };
        for place in 0..usize::from(SIDE) * usize::from(SIDE) {
            let (x, y) = (place % usize::from(SIDE) * step + step / 2, place / usize::from(SIDE) * step + step / 2);
            bytes.extend(&texels[3 * (y * picture.width() + x)..][..3]);
        }
    }
    bytes
}

/// The pictures that bytes stand for, whatever they are: sides of 1 to 32, texels from the start again where they run out.
pub fn pictures(bytes: &[u8]) -> [Picture; 6] {
    let (sides, texels) = bytes.split_at(bytes.len().min(12));
    let mut texels = texels.iter().chain(std::iter::once(&128)).copied().cycle();
    std::array::from_fn(|face| {
        let side = |axis: usize| 1 + usize::from(sides.get(2 * face + axis).copied().unwrap_or(7) % 32);
        let (width, height) = (side(0), side(1));
        let header = Header { width, height, format: Format::Png, bit_depth: 8, alpha: false };
        Picture::new(header, Texels::Srgb8(texels.by_ref().take(3 * width * height).collect()))
    })
}
