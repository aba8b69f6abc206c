//! The film: what the samples of every pixel add up to.

use super::layers::{LayerSums, Layers};
use super::tile::Tile;
use crate::integrators::{FirstHit, RayCounts};
use crate::math::{DVec3, Vec3};
use crate::parallel;
use crate::picture::Raster;

/// The part of the film under one tile, all its pixels with the same count of samples.
#[derive(Debug, Clone)]
pub struct TileFilm {
    /// Where in the picture.
    pub tile: Tile,
    /// Samples a pixel so far.
    pub samples: u32,
    /// Rays traced for all of them.
    pub counts: RayCounts,
    keeps: Keeps,
    /// Sums of radiance times filter weight, in `f64` so that many samples do not lose the small ones; empty before the
    /// first sample.
    weighted: Vec<DVec3>,
    /// Sums of radiance and of filter weights; empty for filters whose samples all count the same.
    uneven: Vec<(DVec3, f64)>,
    /// Empty unless layers were asked for.
    layers: Vec<LayerSums>,
}

/// What a film keeps of every sample beside its weighted radiance.
#[derive(Debug, Clone, Copy)]
pub struct Keeps {
    /// Samples count differently: their weights.
    pub weights: bool,
    /// Layers were asked for.
    pub layers: bool,
}

impl TileFilm {
    /// A film without samples. It takes no memory before the first: the thread that exposes it shall touch it first.
    pub fn new(tile: Tile, keeps: Keeps) -> Self {
        let counts = RayCounts::default();
        Self { tile, samples: 0, counts, keeps, weighted: Vec::new(), uneven: Vec::new(), layers: Vec::new() }
    }

    /// The film of a single pixel, ready for samples.
    pub fn of_pixel(keeps: Keeps) -> Self {
        Self::new(Tile { x: 0, y: 0, width: 1, height: 1 }, keeps).copy_for_pass()
    }

    /// A copy to add samples to, which replaces this film when all pixels have them.
    pub fn copy_for_pass(&self) -> Self {
        if !self.weighted.is_empty() {
            return self.clone();
        }
        let area = |kept| if kept { self.tile.area() } else { 0 };
        Self {
            weighted: vec![DVec3::ZERO; self.tile.area()],
            uneven: vec![(DVec3::ZERO, 0.0); area(self.keeps.weights)],
            layers: vec![LayerSums::default(); area(self.keeps.layers)],
            ..*self
        }
    }

    /// Adds a sample of a pixel, counted within the tile.
    #[inline]
    pub fn add(&mut self, pixel: usize, radiance: Vec3, weight: f64) {
        let radiance = radiance.as_dvec3();
        self.weighted[pixel] += radiance * weight;
        if let Some(uneven) = self.uneven.get_mut(pixel) {
            uneven.0 += radiance;
            uneven.1 += weight;
        }
    }

    /// Adds what the layers need of the same sample, if they were asked for.
    #[inline]
    pub fn add_layers(&mut self, pixel: usize, radiance: Vec3, first_hit: impl FnOnce() -> Option<FirstHit>) {
        if let Some(layer) = self.layers.get_mut(pixel) {
            layer.add(radiance, first_hit());
        }
    }

    /// The radiance a pixel shows; black before the first sample.
    ///
    /// With uneven weights the mean of the weights is not exactly 1; by as much as it is off, the plain mean of the radiance
    /// is taken away, so that an even picture stays even. The bias falls with 1/samples.
    pub fn pixel(&self, pixel: usize) -> Vec3 {
        let samples = f64::from(self.samples.max(1));
        let mean = self.weighted.get(pixel).copied().unwrap_or_default() / samples;
        let excess = |&(plain, weights): &(DVec3, f64)| plain / samples * (weights / samples - 1.0);
        let excess = self.uneven.get(pixel).map_or(DVec3::ZERO, excess);
        (mean - excess).as_vec3()
    }
}

/// The picture on the film of all tiles, given row by row; bands of tiles in parallel.
pub(super) fn develop(tiles: &[TileFilm], [width, height]: [usize; 2]) -> Raster {
    let mut raster = Raster::filled(width, height, Vec3::ZERO);
    let bands = raster.pixels_mut().chunks_mut(width * Tile::SIDE);
    parallel::for_each(bands.zip(tiles.chunks(width.div_ceil(Tile::SIDE))), |(band, tiles)| {
        for film in tiles {
            let tile = film.tile;
            for row in 0..tile.height {
                let start = row * width + tile.x;
                for (column, pixel) in band[start..start + tile.width].iter_mut().enumerate() {
                    *pixel = film.pixel(row * tile.width + column);
                }
            }
        }
    });
    raster
}

/// The layers on the film of all tiles; `None` if they were not asked for.
pub(super) fn develop_layers(tiles: &[TileFilm], [width, height]: [usize; 2]) -> Option<Layers> {
    tiles.first().filter(|film| film.keeps.layers)?;
    let mut layers = Layers::blank(width, height);
    for film in tiles {
        for ([x, y], sums) in film.tile.pixels().zip(&film.layers) {
            layers.set(x, y, sums, film.samples);
        }
    }
    Some(layers)
}
