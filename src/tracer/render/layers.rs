//! Layers beside the picture, for denoisers and inspection: normal, albedo, depth and variance.

use crate::integrators::FirstHit;
use crate::math::{DVec3, Vec3};
use crate::picture::{Raster, SideLayer};

/// Means over the samples of each pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Layers {
    /// World-space shading normal on the viewer's side of what a camera ray meets first; 0 where it meets nothing, and
    /// shorter than 1 where samples of a pixel differ.
    pub normal: Raster,
    /// The share of light that the first surface reflects or transmits; 1 for ideal glass, 0 where nothing is met.
    pub albedo: Raster,
    /// Distance along the ray to the first surface, in all three channels; infinite if any sample met nothing.
    pub depth: Raster,
    /// Variance of the pixel's mean by the spread of its samples, by channel, as if they were independent: an upper
    /// estimate for Sobol points. 0 for one sample.
    pub variance: Raster,
}

/// Sums over the samples of a pixel.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LayerSums {
    normal: DVec3,
    albedo: DVec3,
    depth: f64,
    /// Mean of the radiance so far and sum of squared distances from it (Welford, 1962): squares themselves would
    /// cancel.
    mean: DVec3,
    spread: DVec3,
    samples: u32,
}

impl LayerSums {
    pub fn add(&mut self, radiance: Vec3, first_hit: Option<FirstHit>) {
        self.samples += 1;
        let radiance = radiance.as_dvec3();
        let before = radiance - self.mean;
        self.mean += before / f64::from(self.samples);
        self.spread += before * (radiance - self.mean);
        match first_hit {
            Some(hit) => {
                self.normal += hit.normal;
                self.albedo += hit.albedo.as_dvec3();
                self.depth += hit.distance;
            }
            None => self.depth = f64::INFINITY,
        }
    }
}

impl Layers {
    /// The layers under the names they have in files.
    pub fn named(&self) -> [SideLayer<'_>; 4] {
        let layer = |name, channels, raster| SideLayer { name, channels, raster };
        [
            layer("normal", &["X", "Y", "Z"][..], &self.normal),
            layer("albedo", &["R", "G", "B"], &self.albedo),
            layer("depth", &["Z"], &self.depth),
            layer("variance", &["R", "G", "B"], &self.variance),
        ]
    }

    pub(super) fn blank(width: usize, height: usize) -> Self {
        let blank = || Raster::filled(width, height, Vec3::ZERO);
        Self { normal: blank(), albedo: blank(), depth: blank(), variance: blank() }
    }

    pub(super) fn set(&mut self, x: usize, y: usize, sums: &LayerSums, samples: u32) {
        let count = f64::from(samples.max(1));
        self.normal.set(x, y, (sums.normal / count).as_vec3());
        self.albedo.set(x, y, (sums.albedo / count).as_vec3());
        self.depth.set(x, y, Vec3::splat((sums.depth / count) as f32));
        self.variance.set(x, y, (sums.spread / (count * (count - 1.0).max(1.0))).as_vec3());
    }
}
