//! Caustics: light that glass and mirrors focus onto other surfaces.
//!
//! A path from the camera finds a small source behind glass only by chance, so this light stays noisy for hours. A
//! photon pass therefore traces rays from the source first and stores photons at their hits. A photon gives later paths
//! the directions in which the light is seen from there. These directions are another sampling strategy with a known
//! density, weighted against the material's own strategy: no photon can bias the picture (Jensen,
//! Importance Driven Path Tracing Using the Photon Map, 1995; with photon differentials in place of a count of
//! photons).

mod chain;
mod emission;
mod hits;
mod photon;
mod signature;
mod spread;
mod tree;

use std::collections::BTreeMap;

use crate::integrators::common::lights::LightTables;
use crate::math::DVec3;
use crate::sampling::warp::among_weights;
use crate::scene::{Plan, Scene};
use hits::{PhotonPass, TracedBeam};
use photon::{Forecast, Photon};
use tree::{HANDFUL, PhotonTree};

pub use chain::branch;
pub use signature::{Signature, SpecularEvent};

/// Most specular chains that are searched for; the weaker ones are left to chance.
const MOST_CHAINS: usize = 64;
/// Fewest photons of a chain, and most that are kept of one.
const FEWEST_PHOTONS: usize = 4;
const MOST_PHOTONS: usize = 32_768;
/// Share of the choices that go to all chains alike: light may arrive by a chain where none of its photons hit.
const EVEN_SHARE: f64 = 0.15;

/// Where focused light comes from, all over the scene.
pub struct CausticGuide {
    chains: Vec<ChainPhotons>,
    /// The photons of all chains: how much of the light around a place took which.
    all: PhotonTree,
}

/// The photons that took the same events.
struct ChainPhotons {
    /// From the photon hit back to the source.
    events: Vec<SpecularEvent>,
    signature: Signature,
    photons: PhotonTree,
}

impl CausticGuide {
    /// Does the photon pass. `None` where the plan leaves it out, no source is small and bright, or nothing is hit.
    pub fn new(scene: &Scene, plan: &Plan, lights: &LightTables) -> Option<Self> {
        if !plan.caustics || !lights.is_concentrated() {
            return None;
        }
        let pass = PhotonPass::new(scene, plan, lights)?;
        let traced = pass.send();
        let mut chains = Vec::new();
        let mut all = Vec::new();
        for (number, (signature, traced)) in strongest(&traced).into_iter().enumerate() {
            let photons = pass.photons(&traced, number as u32);
            all.extend_from_slice(&photons);
            let events = traced[0].chain.events.iter().rev().copied().collect();
            chains.push(ChainPhotons { events, signature, photons: PhotonTree::new(photons).with_drift() });
        }
        (!chains.is_empty()).then(|| Self { chains, all: PhotonTree::new(all) })
    }

    /// The directions of focused light around a place.
    #[inline]
    pub fn around(&self, point: DVec3) -> Directions<'_> {
        Directions { guide: self, point }
    }
}

/// The beams of the chains that most of the light took, strongest first; of each chain no more than tell enough.
fn strongest(traced: &[TracedBeam]) -> Vec<(Signature, Vec<&TracedBeam>)> {
    let mut chains: BTreeMap<Signature, Vec<&TracedBeam>> = BTreeMap::new();
    for beam in traced {
        // From the photon hit back to the source.
        let signature = Signature::of(beam.chain.events.iter().rev());
        chains.entry(signature).or_default().push(beam);
    }
    let share = |beams: &[&TracedBeam]| beams.iter().map(|beam| beam.chain.share).sum::<f64>();
    let mut chains: Vec<_> = chains.into_iter().filter(|(_, beams)| beams.len() >= FEWEST_PHOTONS).collect();
    chains.sort_by(|(_, one), (_, other)| share(other).total_cmp(&share(one)));
    chains.truncate(MOST_CHAINS);
    chains.iter_mut().for_each(|(_, beams)| beams.truncate(MOST_PHOTONS));
    chains
}

/// The directions in which focused light is seen from a place.
#[derive(Clone, Copy)]
pub struct Directions<'g> {
    guide: &'g CausticGuide,
    point: DVec3,
}

/// A direction in which light may arrive by a specular chain.
pub struct FocusedDirection<'g> {
    pub direction: DVec3,
    /// By solid angle, times the probability of the chain.
    pub density: f64,
    /// From here to the source.
    pub events: &'g [SpecularEvent],
}

impl<'g> Directions<'g> {
    /// Draws a chain, and a direction in which its light may arrive; `None` if none of its photons is near.
    #[inline]
    pub fn draw(&self, place: [f64; 2], choice: f64) -> Option<FocusedDirection<'g>> {
        let (chain, probability, rest) = self.draw_chain(choice);
        let ChainPhotons { events, photons, .. } = &self.guide.chains[chain];
        let photons = photons.near(self.point);
        let forecasts = self.forecasts(photons);
        let total: f64 = forecasts.iter().map(|forecast| forecast.weight).sum();
        let (chosen, _) = among_weights(photons.len(), |photon| forecasts[photon].weight, rest * total);
        let direction = photons.get(chosen)?.draw(&forecasts[chosen], place);
        let density = probability * mixed_density(photons, &forecasts, direction);
        Some(FocusedDirection { direction, density, events })
    }

    /// Density with which [`Directions::draw`] chooses a unit direction for a chain.
    pub fn density(&self, direction: DVec3, signature: Signature) -> f64 {
        let Some(chain) = self.guide.chains.iter().position(|chain| chain.signature == signature) else { return 0.0 };
        let photons = self.guide.chains[chain].photons.near(self.point);
        if photons.is_empty() {
            return 0.0;
        }
        self.probabilities()(chain) * mixed_density(photons, &self.forecasts(photons), direction)
    }

    /// The probability of each chain: its share of the light around here.
    #[inline]
    fn probabilities(&self) -> impl Fn(usize) -> f64 {
        let around = self.guide.all.near(self.point);
        let total: f64 = around.iter().map(|photon| photon.share).sum();
        let even = if around.is_empty() { 1.0 } else { EVEN_SHARE } / self.guide.chains.len() as f64;
        let scale = if around.is_empty() { 0.0 } else { (1.0 - EVEN_SHARE) / total };
        move |chain| {
            let here = around.iter().filter(|photon| photon.chain as usize == chain);
            even + scale * here.map(|photon| photon.share).sum::<f64>()
        }
    }

    /// A chain, its probability, and what is left of the random number, uniform in `[0, 1)`.
    #[inline]
    fn draw_chain(&self, choice: f64) -> (usize, f64, f64) {
        let probability = self.probabilities();
        let (chain, left) = among_weights(self.guide.chains.len(), &probability, choice);
        let of_chain = probability(chain);
        (chain, of_chain, (left / of_chain).min(1.0 - f64::EPSILON))
    }

    /// The prediction of each photon; `None` without a photon.
    #[inline]
    fn forecasts(&self, photons: &[Photon]) -> [Forecast; HANDFUL] {
        let mut forecasts = [Forecast::default(); HANDFUL];
        for (forecast, photon) in forecasts.iter_mut().zip(photons) {
            *forecast = photon.forecast(self.point);
        }
        forecasts
    }
}

#[inline]
fn mixed_density(photons: &[Photon], forecasts: &[Forecast; HANDFUL], direction: DVec3) -> f64 {
    let (mut total, mut sum) = (0.0, 0.0);
    for (photon, forecast) in photons.iter().zip(forecasts) {
        total += forecast.weight;
        sum += forecast.weight * photon.density(forecast, direction);
    }
    sum / total
}
