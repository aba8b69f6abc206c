//! Caustics: light that glass and mirrors focus onto other surfaces.
//!
//! A path from the camera finds a small source behind glass only by chance, which is why such light is noise for hours. So
//! rays are sent from the source first. Where they land they leave photons, and a photon tells paths that come by later
//! in which directions the light is seen from there. Those directions are only another way of choosing rays, with a known
//! density, weighted against the material's own choice: the picture stays unbiased, whatever the photons say (Jensen,
//! Importance Driven Path Tracing Using the Photon Map, 1995; with photon differentials in place of a count of photons).

mod chain;
mod emission;
mod landed;
mod photon;
mod spread;
mod tree;
mod way;

use std::collections::BTreeMap;

use super::lights::LightTables;
use crate::math::DVec3;
use crate::sampling::warp::among_weights;
use crate::scene::{Plan, Scene};
use landed::{Landed, LightAhead};
use photon::{Forecast, Photon};
use tree::{HANDFUL, PhotonTree};

pub(super) use chain::branch;
pub(super) use way::{Turn, WayCode};

/// Most ways that are searched for; the weaker ones are left to chance.
const MOST_WAYS: usize = 64;
/// Fewest photons that tell of a way, and most that are kept of one.
const FEWEST_PHOTONS: usize = 4;
const MOST_PHOTONS: usize = 32_768;
/// Share of the choices that go to all ways alike: a way may be seen where none of its photons landed.
const EVEN_SHARE: f64 = 0.15;

/// Where focused light comes from, all over the scene.
pub(super) struct CausticGuide {
    ways: Vec<Way>,
    /// The photons of all ways, which tell how much of the light around a place took which.
    all: PhotonTree,
}

/// Light that took the same turns.
struct Way {
    /// From where the light lands back to its source.
    turns: Vec<Turn>,
    code: WayCode,
    photons: PhotonTree,
}

impl CausticGuide {
    /// Sends light ahead. `None` where the plan leaves it out, no source is small and bright, or nothing lands.
    pub fn new(scene: &Scene, plan: &Plan, lights: &LightTables) -> Option<Self> {
        if !plan.caustics || !lights.is_concentrated() {
            return None;
        }
        let source = LightAhead::new(scene, plan, lights)?;
        let landed = source.send();
        let mut ways = Vec::new();
        let mut all = Vec::new();
        for (number, (code, landed)) in strongest(&landed).into_iter().enumerate() {
            let photons = source.photons(&landed, number as u32);
            all.extend_from_slice(&photons);
            let turns = landed[0].chain.turns.iter().rev().copied().collect();
            ways.push(Way { turns, code, photons: PhotonTree::new(photons).with_drift() });
        }
        (!ways.is_empty()).then(|| Self { ways, all: PhotonTree::new(all) })
    }

    /// The directions of focused light around a place.
    #[inline]
    pub fn around(&self, point: DVec3) -> Directions<'_> {
        Directions { guide: self, point }
    }
}

/// What landed by the ways that most of the light took, strongest first; of each way no more than tell enough.
fn strongest(landed: &[Landed]) -> Vec<(WayCode, Vec<&Landed>)> {
    let mut ways: BTreeMap<WayCode, Vec<&Landed>> = BTreeMap::new();
    for landed in landed {
        // From where the light landed back to its source.
        let code = WayCode::of(landed.chain.turns.iter().rev());
        ways.entry(code).or_default().push(landed);
    }
    let share = |landed: &[&Landed]| landed.iter().map(|landed| landed.chain.share).sum::<f64>();
    let mut ways: Vec<_> = ways.into_iter().filter(|(_, landed)| landed.len() >= FEWEST_PHOTONS).collect();
    ways.sort_by(|(_, one), (_, other)| share(other).total_cmp(&share(one)));
    ways.truncate(MOST_WAYS);
    ways.iter_mut().for_each(|(_, landed)| landed.truncate(MOST_PHOTONS));
    ways
}

/// The directions in which focused light is seen from a place.
#[derive(Clone, Copy)]
pub(super) struct Directions<'g> {
    guide: &'g CausticGuide,
    point: DVec3,
}

/// A direction in which light may be seen that took a certain way.
pub(super) struct FocusedDirection<'g> {
    pub direction: DVec3,
    /// By solid angle, of all directions drawn for this way.
    pub density: f64,
    /// From here to the source.
    pub turns: &'g [Turn],
}

impl<'g> Directions<'g> {
    /// Draws a way, and a direction in which light of that way may be seen; `None` if it is not seen from here.
    #[inline]
    pub fn draw(&self, place: [f64; 2], choice: f64) -> Option<FocusedDirection<'g>> {
        let (way, probability, rest) = self.draw_way(choice);
        let Way { turns, photons, .. } = &self.guide.ways[way];
        let photons = photons.near(self.point);
        let forecasts = self.forecasts(photons);
        let total: f64 = forecasts.iter().map(|forecast| forecast.weight).sum();
        let (chosen, _) = among_weights(photons.len(), |photon| forecasts[photon].weight, rest * total);
        let direction = photons.get(chosen)?.draw(&forecasts[chosen], place);
        let density = probability * mixed_density(photons, &forecasts, direction);
        Some(FocusedDirection { direction, density, turns })
    }

    /// Density with which [`Directions::draw`] chooses a unit direction for a way.
    pub fn density(&self, direction: DVec3, code: WayCode) -> f64 {
        let Some(way) = self.guide.ways.iter().position(|way| way.code == code) else { return 0.0 };
        let photons = self.guide.ways[way].photons.near(self.point);
        if photons.is_empty() {
            return 0.0;
        }
        self.probabilities()(way) * mixed_density(photons, &self.forecasts(photons), direction)
    }

    /// With which probability each way is chosen: by the share of the light around here that took it.
    #[inline]
    fn probabilities(&self) -> impl Fn(usize) -> f64 {
        let around = self.guide.all.near(self.point);
        let total: f64 = around.iter().map(|photon| photon.share).sum();
        let even = if around.is_empty() { 1.0 } else { EVEN_SHARE } / self.guide.ways.len() as f64;
        let scale = if around.is_empty() { 0.0 } else { (1.0 - EVEN_SHARE) / total };
        move |way| {
            let here = around.iter().filter(|photon| photon.way as usize == way);
            even + scale * here.map(|photon| photon.share).sum::<f64>()
        }
    }

    /// A way, its probability, and what is left of the random number, uniform in `[0, 1)`.
    #[inline]
    fn draw_way(&self, choice: f64) -> (usize, f64, f64) {
        let probability = self.probabilities();
        let (way, left) = among_weights(self.guide.ways.len(), &probability, choice);
        let of_way = probability(way);
        (way, of_way, (left / of_way).min(1.0 - f64::EPSILON))
    }

    /// What each photon foresees; none where there is no photon.
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
