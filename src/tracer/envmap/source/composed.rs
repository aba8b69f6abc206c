//! Six faces in one picture: the inverse of cutting a sheet.

use super::layout::Layout;
use crate::math::Vec3;
use crate::picture::{Header, Picture, Texels};

impl Layout {
    /// One picture of six square faces of one size, +X -X +Y -Y +Z -Z; the empty cells of a cross are black.
    /// Texels are copied. Where some faces hold bytes and others light, the picture holds light.
    pub fn composed(self, faces: &[Picture; 6]) -> Picture {
        let bytes = |face: &Picture| match face.texels() {
            Texels::Srgb8(bytes) => Some(bytes.as_chunks::<3>().0.to_vec()),
            Texels::Linear(_) => None,
        };
        let all_bytes: Option<Vec<_>> = faces.iter().map(bytes).collect();
        let side = faces[0].width();
        let texels = match all_bytes {
            Some(faces) => Texels::Srgb8(self.placed(side, &faces, [0; 3]).into_flattened()),
            None => {
                let light: Vec<_> = faces.iter().map(|face| face.to_raster().pixels().to_vec()).collect();
                Texels::Linear(self.placed(side, &light, Vec3::ZERO))
            }
        };
        let (columns, rows) = self.grid();
        let bit_depth = faces.iter().map(|face| face.header().bit_depth).max().unwrap_or(8);
        let size = Header { width: columns * side, height: rows * side, bit_depth, ..faces[0].header() };
        Picture::new(size, texels)
    }

    /// The texels of all faces in their cells.
    fn placed<Texel: Copy>(self, side: usize, faces: &[Vec<Texel>], empty: Texel) -> Vec<Texel> {
        let (columns, rows) = self.grid();
        let mut placed = vec![empty; columns * side * rows * side];
        for (texels, cell) in faces.iter().zip(self.cells()) {
            for (x, y) in (0..side).flat_map(|y| (0..side).map(move |x| (x, y))) {
                // Cutting takes the texel in column x and row y of the face from there.
                let (right, down) = cell.turn.source(x, y, side);
                let place = (cell.row * side + down) * columns * side + cell.column * side + right;
                placed[place] = texels[y * side + x];
            }
        }
        placed
    }
}
