//! The reference of the errors.

use serde::Serialize;

use super::cache;
use super::configuration::Configuration;
use super::errors::{Errors, mean_radiance};
use super::protocol::Protocol;
use super::variation::Variant;
use super::watch::{Watch, Work};
use crate::envmap::CubeFilter;
use crate::error::{Error, Result};
use crate::picture::Raster;
use crate::render::{Budget, Renderer, render_progressively};
use crate::sampling::SamplerKind;
use crate::scene::{Caustics, IntegratorKind, Plan, Scene, Strategy};

/// A picture from two independent halves.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    pub halves: [Raster; 2],
    /// Their mean.
    pub mean: Raster,
    pub facts: ReferenceFacts,
}

/// What a report says of a reference.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReferenceFacts {
    /// The settings it was rendered with.
    pub configuration: Configuration,
    /// Samples per pixel over both halves.
    pub samples: u32,
    /// The expected errors of the mean against a perfect picture, estimated from the halves: the errors of a half
    /// against the mean, `(a - (a + b)/2)^2 = (a - b)^2 / 4`, whose expectation is the variance of the mean.
    pub errors: Errors,
    /// Mean over all pixels and channels.
    pub mean_radiance: f64,
    /// What the picture depends on, in 16 hexadecimal digits; names the files in the cache.
    pub key: String,
    /// True if it was not rendered now.
    pub cached: bool,
}

impl ReferenceFacts {
    /// What a picture of it says of itself.
    fn remark(&self) -> String {
        let Self { samples, errors, .. } = self;
        format!("{samples} samples per pixel, standard error {:.3e} (root mean square)", errors.rmse)
    }
}

/// The seeds of the halves, counted from the scene's: far from those of the renderings, which follow the scene's.
const SEEDS: [u32; 2] = [0x8000_0000, 0x8000_0001];

/// The references that the variants need, each once, and which of them belongs to which variant.
///
/// What approximates a picture is measured against the best of what is compared, so that its bias shows: the most complete
/// integrator, the greatest depth, the seamless lookup. A pixel filter says what a pixel means: each has a reference of
/// its own. Strategy, sampler and caustics do not change the expected picture; the best of them are taken.
pub(super) fn aims(variants: &[Variant]) -> (Vec<Configuration>, Vec<usize>) {
    let configurations = || variants.iter().map(|variant| variant.configuration);
    let integrator = configurations().map(|variant| variant.integrator).max_by_key(|&kind| completeness(kind));
    let depth = configurations().map(|variant| variant.depth).max();
    let lookup =
        configurations().filter_map(|variant| variant.environment_filter).max_by_key(|&filter| quality(filter));
    let mut aims: Vec<Configuration> = Vec::new();
    let number = |configuration: Configuration| {
        let aim = Configuration {
            integrator: integrator.unwrap_or(configuration.integrator),
            depth: depth.unwrap_or(configuration.depth),
            environment_filter: lookup,
            strategy: Strategy::Mis,
            caustics: Caustics::Auto,
            sampler: SamplerKind::Sobol,
            ..configuration
        };
        aims.iter().position(|other| *other == aim).unwrap_or_else(|| {
            aims.push(aim);
            aims.len() - 1
        })
    };
    let numbers = configurations().map(number).collect();
    (aims, numbers)
}

fn completeness(kind: IntegratorKind) -> u8 {
    match kind {
        IntegratorKind::Normals => 0,
        IntegratorKind::Phong => 1,
        IntegratorKind::Whitted => 2,
        IntegratorKind::Path => 3,
    }
}

fn quality(filter: CubeFilter) -> u8 {
    match filter {
        CubeFilter::Nearest => 0,
        CubeFilter::Bilinear => 1,
        CubeFilter::Seamless => 2,
    }
}

impl Reference {
    /// The reference of a scene for a configuration: from the cache, or rendered and put there.
    pub(super) fn obtain(
        scene: &mut Scene,
        aim: Configuration,
        protocol: &Protocol,
        watch: &impl Watch,
        what: &str,
    ) -> Result<Self> {
        aim.apply(scene);
        // Each half has as many samples as the other.
        let samples = protocol.reference_samples.max(2).next_multiple_of(2);
        let key = cache::key(scene, &aim, samples)?;
        if let Some(halves) = protocol.cache.and_then(|folder| cache::read(folder, &key, scene.camera.size())) {
            return Ok(Self::of_halves(halves, aim, samples, key, true));
        }
        let halves = render_halves(scene, samples / 2, watch, what)?;
        let reference = Self::of_halves(halves, aim, samples, key, false);
        if let Some(folder) = protocol.cache {
            cache::write(folder, &reference.facts.key, &reference.halves, &reference.mean, &reference.facts.remark())?;
        }
        Ok(reference)
    }

    fn of_halves(halves: [Raster; 2], configuration: Configuration, samples: u32, key: String, cached: bool) -> Self {
        let pixels = halves[0].pixels().iter().zip(halves[1].pixels());
        let pixels = pixels.map(|(&a, &b)| ((a.as_dvec3() + b.as_dvec3()) / 2.0).as_vec3()).collect();
        let mean = Raster::from_pixels(halves[0].width(), halves[0].height(), pixels);
        let errors = Errors::between(&halves[0], &mean);
        let mean_radiance = mean_radiance(&mean);
        let facts = ReferenceFacts { configuration, samples, errors, mean_radiance, key, cached };
        Self { halves, mean, facts }
    }
}

const STOPPED: &str = "stopped before the reference was finished: nothing was written";

fn render_halves(scene: &mut Scene, samples: u32, watch: &impl Watch, what: &str) -> Result<[Raster; 2]> {
    let [width, height] = scene.camera.size();
    let phase = watch.begin(what, Work::Samples(2 * u64::from(samples) * (width * height) as u64));
    let own_seed = scene.sampling.seed;
    let mut half = |offset: u32| -> Result<Raster> {
        // Once cancelled, nothing may be prepared either: that traces rays, too.
        if watch.cancelled() {
            return Err(Error::new(STOPPED));
        }
        // In the scene itself, so that the photons that search for caustics are others, too.
        scene.sampling.seed = own_seed.wrapping_add(offset);
        let plan = Plan::new(scene);
        let renderer = Renderer::new(scene, &plan)?.scattered();
        let rendering = render_progressively(renderer, Budget::Samples(samples), &phase)?;
        if rendering.stopped {
            return Err(Error::new(STOPPED));
        }
        Ok(rendering.raster)
    };
    let halves = half(SEEDS[0]).and_then(|first| Ok([first, half(SEEDS[1])?]));
    scene.sampling.seed = own_seed;
    halves
}
