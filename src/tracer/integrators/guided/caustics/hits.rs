//! The photon pass: beams of rays from the sources, and their hits.

use super::chain::{Chain, ChainTracer};
use super::emission::{Beam, Casters};
use super::photon::Photon;
use super::spread::Spread;
use crate::integrators::common::lights::LightTables;
use crate::parallel;
use crate::sampling::{PixelSampler, Sampling};
use crate::scene::{Plan, Scene};

/// Beams of rays sent out a pixel of the picture, and bounds on their number.
const BEAMS_A_PIXEL: f64 = 0.5;
const BEAMS: std::ops::RangeInclusive<u32> = 4096..=131_072;
/// Beams sent out one after the other by one thread.
const BEAMS_AT_ONCE: u32 = 256;
/// A column of pixels that no picture has: its samples are those of the photons.
const PHOTON_COLUMN: usize = usize::MAX;

/// A beam whose middle ray took one chain.
pub(super) struct TracedBeam {
    /// Number of the beam.
    beam: u32,
    pub chain: Chain,
}

/// The beams that are sent to the mirrors and glasses of a scene.
pub(super) struct PhotonPass<'a> {
    scene: &'a Scene,
    lights: &'a LightTables,
    casters: Casters,
    tracer: ChainTracer<'a>,
    sampling: Sampling,
    count: u32,
}

impl<'a> PhotonPass<'a> {
    /// `None` if there is nothing to send it to.
    pub fn new(scene: &'a Scene, plan: &Plan, lights: &'a LightTables) -> Option<Self> {
        let [width, height] = scene.camera.size();
        let count = ((width * height) as f64 * BEAMS_A_PIXEL) as u32;
        Some(Self {
            scene,
            lights,
            casters: Casters::new(scene)?,
            tracer: ChainTracer::new(scene, plan),
            sampling: Sampling { seed: scene.sampling.seed, ..Sampling::default() },
            count: count.clamp(*BEAMS.start(), *BEAMS.end()),
        })
    }

    /// Beam number `index`; `None` if its direction is not bright.
    fn beam(&self, index: u32) -> Option<Beam> {
        let mut sampler = PixelSampler::chosen(self.sampling, PHOTON_COLUMN, 0, index);
        self.casters.beam(self.scene, self.lights, &mut sampler)
    }

    /// Follows the middle rays of all beams along all their chains, in the order of the beams.
    pub fn send(&self) -> Vec<TracedBeam> {
        let starts = (0..self.count).step_by(BEAMS_AT_ONCE as usize);
        let traced = parallel::map(starts, |start| {
            let beams = start..(start + BEAMS_AT_ONCE).min(self.count);
            let chains = |beam: u32| self.beam(beam).map_or(Vec::new(), |sent| self.tracer.explore(sent.ray));
            beams.flat_map(|beam| chains(beam).into_iter().map(move |chain| TracedBeam { beam, chain })).collect()
        });
        traced.into_iter().flat_map(|traced: Vec<TracedBeam>| traced).collect()
    }

    /// The photons of one chain.
    pub fn photons(&self, traced: &[&TracedBeam], chain: u32) -> Vec<Photon> {
        let some = parallel::map(traced.chunks(BEAMS_AT_ONCE as usize), |traced| {
            let photon = |traced: &&TracedBeam| {
                let spread = Spread::of(&self.tracer, &self.beam(traced.beam)?, &traced.chain);
                Some(spread.photon(&traced.chain, chain))
            };
            traced.iter().filter_map(photon).collect::<Vec<_>>()
        });
        some.into_iter().flatten().collect()
    }
}
