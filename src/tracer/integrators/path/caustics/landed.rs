//! Light sent ahead: bundles of rays, and where they land.

use super::super::lights::LightTables;
use super::chain::{Chain, ChainTracer};
use super::emission::{Bundle, Casters};
use super::photon::Photon;
use super::spread::Spread;
use crate::parallel;
use crate::sampling::{PixelSampler, Sampling};
use crate::scene::{Plan, Scene};

/// Bundles of rays sent out a pixel of the picture, and bounds on their number.
const BUNDLES_A_PIXEL: f64 = 0.5;
const BUNDLES: std::ops::RangeInclusive<u32> = 4096..=131_072;
/// Bundles sent out one after the other by one thread.
const BUNDLES_AT_ONCE: u32 = 256;
/// A column of pixels that no picture has: its samples are those of the photons.
const PHOTON_COLUMN: usize = usize::MAX;

/// A bundle whose middle landed by one way.
pub(super) struct Landed {
    /// Number of the bundle.
    bundle: u32,
    pub chain: Chain,
}

/// The light that is sent to the mirrors and glasses of a scene.
pub(super) struct LightAhead<'a> {
    scene: &'a Scene,
    lights: &'a LightTables,
    casters: Casters,
    tracer: ChainTracer<'a>,
    sampling: Sampling,
    count: u32,
}

impl<'a> LightAhead<'a> {
    /// `None` if there is nothing to send it to.
    pub fn new(scene: &'a Scene, plan: &Plan, lights: &'a LightTables) -> Option<Self> {
        let [width, height] = scene.camera.size();
        let count = ((width * height) as f64 * BUNDLES_A_PIXEL) as u32;
        Some(Self {
            scene,
            lights,
            casters: Casters::new(scene)?,
            tracer: ChainTracer::new(scene, plan),
            sampling: Sampling { seed: scene.sampling.seed, ..Sampling::default() },
            count: count.clamp(*BUNDLES.start(), *BUNDLES.end()),
        })
    }

    /// Bundle number `index`; `None` if its direction is not bright.
    fn bundle(&self, index: u32) -> Option<Bundle> {
        let mut sampler = PixelSampler::chosen(self.sampling, PHOTON_COLUMN, 0, index);
        self.casters.bundle(self.scene, self.lights, &mut sampler)
    }

    /// Follows the middles of all bundles by all their ways, in the order of the bundles.
    pub fn send(&self) -> Vec<Landed> {
        let starts = (0..self.count).step_by(BUNDLES_AT_ONCE as usize);
        let landed = parallel::map(starts, |start| {
            let bundles = start..(start + BUNDLES_AT_ONCE).min(self.count);
            let chains = |bundle: u32| self.bundle(bundle).map_or(Vec::new(), |sent| self.tracer.explore(sent.ray));
            bundles.flat_map(|bundle| chains(bundle).into_iter().map(move |chain| Landed { bundle, chain })).collect()
        });
        landed.into_iter().flat_map(|landed: Vec<Landed>| landed).collect()
    }

    /// The photons of what landed by one way.
    pub fn photons(&self, landed: &[&Landed], way: u32) -> Vec<Photon> {
        let some = parallel::map(landed.chunks(BUNDLES_AT_ONCE as usize), |landed| {
            let photon = |landed: &&Landed| {
                let spread = Spread::of(&self.tracer, &self.bundle(landed.bundle)?, &landed.chain);
                Some(spread.photon(&landed.chain, way))
            };
            landed.iter().filter_map(photon).collect::<Vec<_>>()
        });
        some.into_iter().flatten().collect()
    }
}
