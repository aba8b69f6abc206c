//! The film: what the samples of every pixel add up to.

use super::layers::{LayerSums, Layers};
use super::tile::Tile;
use crate::integrators::{FirstHit, RayCounts};
use crate::math::{DVec3, Vec3};
use crate::picture::Raster;

/// The part of the film under one tile, all its pixels with the same count of samples.
#[derive(Debug, Clone)]
pub(crate) struct TileFilm {
    pub tile: Tile,
    /// Samples a pixel so far.
    pub samples: u32,
    pub counts: RayCounts,
    /// Sums of radiance times filter weight, in `f64` so that many samples do not lose the small ones.
    weighted: Vec<DVec3>,
    /// Sums of radiance and of filter weights; `None` for filters whose samples all count the same.
    uneven: Option<Vec<(DVec3, f64)>>,
    /// `None` unless layers were asked for.
    layers: Option<Vec<LayerSums>>,
}

impl TileFilm {
    /// A film without samples. `even`: all samples count the same.
    pub fn new(tile: Tile, even: bool, layers: bool) -> Self {
        Self {
            tile,
            samples: 0,
            counts: RayCounts::default(),
            weighted: vec![DVec3::ZERO; tile.area()],
            uneven: (!even).then(|| vec![(DVec3::ZERO, 0.0); tile.area()]),
            layers: layers.then(|| vec![LayerSums::default(); tile.area()]),
        }
    }

    /// Adds a sample of a pixel, counted within the tile.
    #[inline]
    pub fn add(&mut self, pixel: usize, radiance: Vec3, weight: f64) {
        let radiance = radiance.as_dvec3();
        self.weighted[pixel] += radiance * weight;
        if let Some(uneven) = &mut self.uneven {
            uneven[pixel].0 += radiance;
            uneven[pixel].1 += weight;
        }
    }

    /// Adds what the layers need of the same sample, if they were asked for.
    #[inline]
    pub fn add_layers(&mut self, pixel: usize, radiance: Vec3, first_hit: impl FnOnce() -> Option<FirstHit>) {
        if let Some(layers) = &mut self.layers {
            layers[pixel].add(radiance, first_hit());
        }
    }

    /// The radiance a pixel shows.
    ///
    /// With uneven weights the mean of the weights is not exactly 1; by as much as it is off, the plain mean of the radiance
    /// is taken away, so that an even picture stays even. The bias falls with 1/samples.
    pub fn pixel(&self, pixel: usize) -> Vec3 {
        let samples = f64::from(self.samples.max(1));
        let mean = self.weighted[pixel] / samples;
        let excess = |&(plain, weights): &(DVec3, f64)| plain / samples * (weights / samples - 1.0);
        let excess = self.uneven.as_ref().map_or(DVec3::ZERO, |uneven| excess(&uneven[pixel]));
        (mean - excess).as_vec3()
    }
}

/// The picture on the film of all tiles.
pub(super) fn develop(tiles: &[TileFilm], [width, height]: [usize; 2]) -> Raster {
    let mut raster = Raster::filled(width, height, Vec3::ZERO);
    for film in tiles {
        let tile = film.tile;
        for row in 0..tile.height {
            let start = (tile.y + row) * width + tile.x;
            for (column, pixel) in raster.pixels_mut()[start..start + tile.width].iter_mut().enumerate() {
                *pixel = film.pixel(row * tile.width + column);
            }
        }
    }
    raster
}

/// The layers on the film of all tiles; `None` if they were not asked for.
pub(super) fn develop_layers(tiles: &[TileFilm], [width, height]: [usize; 2]) -> Option<Layers> {
    let mut layers = Layers::blank(width, height);
    for film in tiles {
        let sums = film.layers.as_ref()?;
        for (pixel, [x, y]) in film.tile.pixels().enumerate() {
            layers.set(x, y, &sums[pixel], film.samples);
        }
    }
    Some(layers)
}
