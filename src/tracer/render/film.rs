//! The film of a picture: the sums of the samples of its pixels.

use super::layers::{LayerSums, Layers};
use crate::integrators::{FirstHit, RayCounts};
use crate::math::{DVec3, Vec3};
use crate::memory::on_large_pages;
use crate::parallel;
use crate::picture::Raster;

/// The film of a picture, row by row, so that several threads can expose it.
#[derive(Debug)]
pub struct Film {
    size: [usize; 2],
    pub rows: Vec<FilmRow>,
    /// Shown where a row has no sample.
    pub coarse: Option<CoarseFilm>,
}

/// A film with one pixel for each square of pixels of the picture.
#[derive(Debug)]
pub struct CoarseFilm {
    pub film: Box<Film>,
    /// The side of the squares.
    pub side: usize,
}

/// One row of pixels, all with the same number of samples. It takes no memory before the first.
#[derive(Debug, Default)]
pub struct FilmRow {
    /// Samples that every pixel has.
    pub samples: u32,
    /// Rays traced for all of them.
    pub counts: RayCounts,
    /// Sums of radiance times filter weight, in `f64` so that many samples do not lose the small ones.
    weighted: Vec<DVec3>,
    /// Sums of radiance and of filter weights; empty for filters whose samples all count the same.
    uneven: Vec<(DVec3, f64)>,
    /// Empty unless layers were requested.
    layers: Vec<LayerSums>,
    keeps: Keeps,
}

/// What a film keeps of every sample beside its weighted radiance.
#[derive(Debug, Clone, Copy, Default)]
pub struct Keeps {
    /// Samples count differently: their weights.
    pub weights: bool,
    /// Layers were requested.
    pub layers: bool,
}

impl Film {
    /// A film without samples.
    pub fn new([width, height]: [usize; 2], keeps: Keeps) -> Self {
        Self { size: [width, height], rows: (0..height).map(|_| FilmRow::new(keeps)).collect(), coarse: None }
    }

    /// Samples that every pixel has.
    pub fn samples(&self) -> u32 {
        self.rows.iter().map(|row| row.samples).min().unwrap_or(0)
    }

    /// Rays traced for all samples.
    pub fn counts(&self) -> RayCounts {
        let mut counts = RayCounts::default();
        self.rows.iter().for_each(|row| counts += row.counts);
        counts
    }

    /// Rows without a sample.
    pub fn blank_rows(&self) -> usize {
        self.rows.iter().filter(|row| row.samples == 0).count()
    }

    /// What is shown of row `y`: a row, and how many pixels side by side each of its own covers.
    fn shown(&self, y: usize) -> (&FilmRow, usize) {
        match &self.coarse {
            Some(CoarseFilm { film, side }) if self.rows[y].samples == 0 => (&film.rows[y / side], *side),
            _ => (&self.rows[y], 1),
        }
    }

    /// The picture; rows in parallel.
    pub fn develop(&self) -> Raster {
        let [width, height] = self.size;
        let mut pixels = on_large_pages(width * height);
        pixels.resize(width * height, Vec3::ZERO);
        parallel::for_each(pixels.chunks_mut(width).enumerate(), |(y, pixels)| {
            let (row, side) = self.shown(y);
            pixels.iter_mut().enumerate().for_each(|(x, pixel)| *pixel = row.pixel(x / side));
        });
        Raster::from_pixels(width, height, pixels)
    }

    /// The layers; `None` unless they were requested.
    pub fn develop_layers(&self) -> Option<Layers> {
        let [width, height] = self.size;
        let mut layers = self.rows.first()?.keeps.layers.then(|| Layers::blank(width, height))?;
        for y in 0..height {
            let (row, side) = self.shown(y);
            for x in 0..width.min(row.layers.len() * side) {
                layers.set(x, y, &row.layers[x / side], row.samples);
            }
        }
        Some(layers)
    }
}

impl FilmRow {
    /// A row without samples.
    pub fn new(keeps: Keeps) -> Self {
        Self { keeps, ..Self::default() }
    }

    /// Adds one sample to every pixel: radiances and what they count.
    pub fn add(&mut self, radiances: &[Vec3], weights: &[f64]) {
        if self.samples == 0 {
            let kept = |kept: bool| if kept { radiances.len() } else { 0 };
            self.weighted.resize(radiances.len(), DVec3::ZERO);
            self.uneven.resize(kept(self.keeps.weights), (DVec3::ZERO, 0.0));
        }
        self.samples += 1;
        let samples = || radiances.iter().map(|radiance| radiance.as_dvec3()).zip(weights);
        for (sum, (radiance, &weight)) in self.weighted.iter_mut().zip(samples()) {
            *sum += radiance * weight;
        }
        for (sum, (radiance, &weight)) in self.uneven.iter_mut().zip(samples()) {
            sum.0 += radiance;
            sum.1 += weight;
        }
    }

    /// Adds what the layers need of one sample of every pixel.
    pub fn add_to_layers(&mut self, radiances: &[Vec3], first_hits: &[Option<FirstHit>]) {
        self.layers.resize(radiances.len(), LayerSums::default());
        for (sums, (&radiance, &first_hit)) in self.layers.iter_mut().zip(radiances.iter().zip(first_hits)) {
            sums.add(radiance, first_hit);
        }
    }

    /// The radiance a pixel shows; black before the first sample.
    ///
    /// With uneven weights the mean of the weights is not exactly 1; by as much as it is off, the plain mean of the radiance
    /// is taken away, so that an even picture stays even. The bias falls with 1/samples.
    #[inline]
    pub fn pixel(&self, x: usize) -> Vec3 {
        let Some(weighted) = self.weighted.get(x) else { return Vec3::ZERO };
        let samples = f64::from(self.samples);
        let excess = |(plain, weights): &(DVec3, f64)| *plain / samples * (weights / samples - 1.0);
        (*weighted / samples - self.uneven.get(x).map_or(DVec3::ZERO, excess)).as_vec3()
    }
}
