//! Tiles: the parts of a picture that threads work on.

/// A rectangle of a picture, in pixels from the top left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    pub x: usize,
    pub y: usize,
    pub width: usize,
    pub height: usize,
}

impl Tile {
    /// Side of a tile in pixels: small enough to balance the load, large enough to keep rays coherent.
    pub const SIDE: usize = 16;

    /// The tiles of a picture, row by row.
    pub fn all([width, height]: [usize; 2]) -> Vec<Self> {
        let corners = (0..height).step_by(Self::SIDE).flat_map(|y| (0..width).step_by(Self::SIDE).map(move |x| (x, y)));
        corners
            .map(|(x, y)| Self { x, y, width: Self::SIDE.min(width - x), height: Self::SIDE.min(height - y) })
            .collect()
    }

    /// Its pixels, row by row.
    pub fn pixels(self) -> impl Iterator<Item = [usize; 2]> {
        (self.y..self.y + self.height).flat_map(move |y| (self.x..self.x + self.width).map(move |x| [x, y]))
    }

    /// How many pixels it has.
    pub fn area(self) -> usize {
        self.width * self.height
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_every_pixel_once() {
        let mut seen = [0; 35 * 18];
        for [x, y] in Tile::all([35, 18]).into_iter().flat_map(Tile::pixels) {
            seen[y * 35 + x] += 1;
        }
        assert_eq!(seen, [1; 35 * 18]);
    }
}
