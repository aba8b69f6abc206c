//! The film of a picture, tile by tile.
//!
//! ```text
//!     tiles      |  0  |  1  |  2  | ...      how many samples each has, and what rays they took
//!     sums       |.....|.....|...  | ...      the same room for every tile; small ones at the border leave some of it
//! ```

use super::layers::{LayerSums, Layers};
use super::tile::Tile;
use super::tile_film::{Keeps, TileFilm, shown};
use crate::integrators::RayCounts;
use crate::math::{DVec3, Vec3};
use crate::memory::{on_large_pages, zeros_on_large_pages};
use crate::parallel;
use crate::picture::Raster;

/// Pixels that there is room for in every tile.
const ROOM: usize = Tile::SIDE * Tile::SIDE;

/// The film of a picture. It takes no memory before the first sample: the thread that exposes a tile touches it first.
#[derive(Debug)]
pub struct Film {
    size: [usize; 2],
    pub keeps: Keeps,
    exposures: Vec<Exposure>,
    /// Sums of radiance times filter weight.
    weighted: Vec<[f64; 3]>,
    /// Sums of radiance and of filter weights; empty for filters whose samples all count the same.
    uneven: Vec<[f64; 4]>,
    layers: Vec<Vec<LayerSums>>,
}

/// How far a tile is exposed.
#[derive(Debug)]
struct Exposure {
    tile: Tile,
    samples: u32,
    counts: RayCounts,
}

/// The film under one tile, in its place.
pub struct Slot<'f> {
    exposure: &'f mut Exposure,
    keeps: Keeps,
    weighted: &'f mut [[f64; 3]],
    uneven: &'f mut [[f64; 4]],
    layers: &'f mut Vec<LayerSums>,
}

impl Film {
    /// A film without samples.
    pub fn new(size: [usize; 2], keeps: Keeps) -> Self {
        let exposure = |tile| Exposure { tile, samples: 0, counts: RayCounts::default() };
        let exposures: Vec<_> = Tile::all(size).into_iter().map(exposure).collect();
        let weighted = zeros_on_large_pages([0.0; 3], exposures.len() * ROOM);
        let uneven = zeros_on_large_pages([0.0; 4], if keeps.weights { exposures.len() * ROOM } else { 0 });
        let layers = vec![Vec::new(); exposures.len()];
        Self { size, keeps, exposures, weighted, uneven, layers }
    }

    /// The tiles, to be exposed independently of each other.
    pub fn slots(&mut self) -> Vec<Slot<'_>> {
        let weighted = self.weighted.chunks_mut(ROOM);
        let mut uneven = self.uneven.chunks_mut(ROOM);
        let places = self.exposures.iter_mut().zip(weighted).zip(&mut self.layers);
        let slot = |((exposure, weighted), layers)| {
            let uneven = uneven.next().unwrap_or_default();
            Slot { exposure, keeps: self.keeps, weighted, uneven, layers }
        };
        places.map(slot).collect()
    }

    /// Samples that every pixel has.
    pub fn samples(&self) -> u32 {
        self.exposures.iter().map(|exposure| exposure.samples).min().unwrap_or(0)
    }

    /// Rays traced for all samples.
    pub fn counts(&self) -> RayCounts {
        let mut counts = RayCounts::default();
        self.exposures.iter().for_each(|exposure| counts += exposure.counts);
        counts
    }

    /// The picture; bands of tiles in parallel.
    pub fn develop(&self) -> Raster {
        let [width, height] = self.size;
        let mut pixels = on_large_pages(width * height);
        pixels.resize(width * height, Vec3::ZERO);
        let across = width.div_ceil(Tile::SIDE);
        let bands = pixels.chunks_mut(width * Tile::SIDE).enumerate();
        parallel::for_each(bands, |(band, pixels)| {
            (band * across..(band + 1) * across).for_each(|number| self.develop_tile(number, pixels));
        });
        Raster::from_pixels(width, height, pixels)
    }

    /// Develops a tile into the band of the picture that it lies in.
    fn develop_tile(&self, number: usize, band: &mut [Vec3]) {
        let Exposure { tile, samples, .. } = self.exposures[number];
        for row in 0..tile.height {
            let start = row * self.size[0] + tile.x;
            let first = number * ROOM + row * tile.width;
            let pixels = band[start..start + tile.width].iter_mut().enumerate();
            pixels.for_each(|(column, pixel)| {
                let uneven = self.uneven.get(first + column).map(|&[x, y, z, weights]| (DVec3::new(x, y, z), weights));
                *pixel = shown(samples, DVec3::from_array(self.weighted[first + column]), uneven);
            });
        }
    }

    /// The layers; `None` if they were not asked for.
    pub fn develop_layers(&self) -> Option<Layers> {
        let [width, height] = self.size;
        let mut layers = self.keeps.layers.then(|| Layers::blank(width, height))?;
        for (Exposure { tile, samples, .. }, sums) in self.exposures.iter().zip(&self.layers) {
            for ([x, y], sums) in tile.pixels().zip(sums) {
                layers.set(x, y, sums, *samples);
            }
        }
        Some(layers)
    }
}

impl Slot<'_> {
    /// Copies the tile, so that samples can be added.
    pub fn load(&self, film: &mut TileFilm) {
        let Exposure { tile, samples, counts } = *self.exposure;
        film.clear(tile, self.keeps);
        if samples == 0 {
            return;
        }
        (film.samples, film.counts) = (samples, counts);
        film.weighted.iter_mut().zip(self.weighted.iter()).for_each(|(to, from)| *to = DVec3::from_array(*from));
        let uneven = self.uneven.iter().map(|&[x, y, z, weights]| (DVec3::new(x, y, z), weights));
        film.uneven.iter_mut().zip(uneven).for_each(|(to, from)| *to = from);
        film.layers.clone_from(self.layers);
    }

    /// Puts the tile back with the samples that were added.
    pub fn store(&mut self, film: &TileFilm) {
        (self.exposure.samples, self.exposure.counts) = (film.samples, film.counts);
        self.weighted.iter_mut().zip(&film.weighted).for_each(|(to, from)| *to = from.to_array());
        let uneven = film.uneven.iter().map(|(radiance, weights)| [radiance.x, radiance.y, radiance.z, *weights]);
        self.uneven.iter_mut().zip(uneven).for_each(|(to, from)| *to = from);
        self.layers.clone_from(&film.layers);
    }
}
