//! The part of the film under one tile, while samples are added.

use super::layers::LayerSums;
use super::tile::Tile;
use crate::integrators::{FirstHit, RayCounts};
use crate::math::{DVec3, Vec3};

/// What the samples of the pixels of a tile add up to, all of them with the same count of samples.
#[derive(Debug, Clone)]
pub struct TileFilm {
    /// Where in the picture.
    pub tile: Tile,
    /// Samples a pixel so far.
    pub samples: u32,
    /// Rays traced for all of them.
    pub counts: RayCounts,
    /// Sums of radiance times filter weight, in `f64` so that many samples do not lose the small ones.
    pub(super) weighted: Vec<DVec3>,
    /// Sums of radiance and of filter weights; empty for filters whose samples all count the same.
    pub(super) uneven: Vec<(DVec3, f64)>,
    /// Empty unless layers were asked for.
    pub(super) layers: Vec<LayerSums>,
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
    /// The film of a single pixel, without samples.
    pub fn of_pixel(keeps: Keeps) -> Self {
        let mut film = Self::blank();
        film.clear(Tile { x: 0, y: 0, width: 1, height: 1 }, keeps);
        film
    }

    /// The film of no pixels.
    pub(super) fn blank() -> Self {
        let tile = Tile { x: 0, y: 0, width: 0, height: 0 };
        let counts = RayCounts::default();
        Self { tile, samples: 0, counts, weighted: Vec::new(), uneven: Vec::new(), layers: Vec::new() }
    }

    /// Makes it the film of a tile without samples. The room is used again.
    pub(super) fn clear(&mut self, tile: Tile, keeps: Keeps) {
        let area = |kept| if kept { tile.area() } else { 0 };
        (self.tile, self.samples, self.counts) = (tile, 0, RayCounts::default());
        self.weighted.clear();
        self.weighted.resize(tile.area(), DVec3::ZERO);
        self.uneven.clear();
        self.uneven.resize(area(keeps.weights), (DVec3::ZERO, 0.0));
        self.layers.clear();
        self.layers.resize(area(keeps.layers), LayerSums::default());
    }

    /// Adds a sample to each of several pixels, counted within the tile from `first`: radiances and what they count.
    #[inline]
    pub fn add(&mut self, first: usize, radiances: &[Vec3], weights: &[f64]) {
        debug_assert!(weights.len() >= radiances.len() && self.weighted.len() >= first + radiances.len());
        let samples = || radiances.iter().map(|radiance| radiance.as_dvec3()).zip(weights);
        for (sum, (radiance, &weight)) in self.weighted[first..].iter_mut().zip(samples()) {
            *sum += radiance * weight;
        }
        if !self.uneven.is_empty() {
            for (sum, (radiance, &weight)) in self.uneven[first..].iter_mut().zip(samples()) {
                sum.0 += radiance;
                sum.1 += weight;
            }
        }
    }

    /// True if layers were asked for.
    pub fn has_layers(&self) -> bool {
        !self.layers.is_empty()
    }

    /// Adds what the layers need of a sample of a pixel, counted within the tile.
    pub fn add_to_layers(&mut self, pixel: usize, radiance: Vec3, first_hit: Option<FirstHit>) {
        self.layers[pixel].add(radiance, first_hit);
    }

    /// The radiance a pixel shows; black before the first sample.
    pub fn pixel(&self, pixel: usize) -> Vec3 {
        shown(self.samples, self.weighted[pixel], self.uneven.get(pixel).copied())
    }
}

/// The radiance a pixel shows after so many samples; black before the first.
///
/// With uneven weights the mean of the weights is not exactly 1; by as much as it is off, the plain mean of the radiance
/// is taken away, so that an even picture stays even. The bias falls with 1/samples.
#[inline]
pub(super) fn shown(samples: u32, weighted: DVec3, uneven: Option<(DVec3, f64)>) -> Vec3 {
    let samples = f64::from(samples.max(1));
    let excess = |(plain, weights): (DVec3, f64)| plain / samples * (weights / samples - 1.0);
    (weighted / samples - uneven.map_or(DVec3::ZERO, excess)).as_vec3()
}
