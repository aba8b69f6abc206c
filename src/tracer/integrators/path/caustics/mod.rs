//! Caustics: light that glass and mirrors focus onto other surfaces.
//!
//! A path from the camera finds a small source behind glass only by chance, which is why such light is noise for hours. So
//! rays are sent from the source first. Where they land they leave photons, and a photon tells paths that come by later
//! in which directions the light is seen from there. Those directions are only another way of choosing rays, with a known
//! density, weighted against the material's own choice: the picture stays unbiased, whatever the photons say (Jensen,
//! Importance Driven Path Tracing Using the Photon Map, 1995; with photon differentials in place of a count of photons).

mod chain;
mod emission;
mod photon;
mod tree;

use rayon::prelude::*;

use super::lights::LightTables;
use crate::math::{DVec3, Frame};
use crate::sampling::{PixelSampler, Sampling};
use crate::scene::{Plan, Scene};
use chain::{ChainTracer, Landing, Turn};
use emission::{Bundle, Casters};
use photon::{Forecast, Photon};
use tree::{HANDFUL, PhotonTree};

/// Bundles of rays sent out a pixel of the picture, and bounds on their number.
const BUNDLES_A_PIXEL: f64 = 0.25;
const BUNDLES: std::ops::RangeInclusive<u32> = 4096..=262_144;
/// A column of pixels that no picture has: its samples are those of the photons.
const PHOTON_COLUMN: usize = usize::MAX;

/// Where focused light comes from, all over the scene.
pub(super) struct CausticGuide {
    tree: PhotonTree,
}

impl CausticGuide {
    /// Sends light ahead. `None` where the plan leaves it out, no source is small and bright, or nothing lands.
    pub fn new(scene: &Scene, plan: &Plan, lights: &LightTables) -> Option<Self> {
        if !plan.caustics || !lights.is_concentrated() {
            return None;
        }
        let casters = Casters::new(scene)?;
        let [width, height] = scene.camera.size();
        let count = ((width * height) as f64 * BUNDLES_A_PIXEL) as u32;
        let count = count.clamp(*BUNDLES.start(), *BUNDLES.end());
        let tracer = ChainTracer::new(scene, plan);
        let sampling = Sampling { seed: scene.sampling.seed, ..Sampling::default() };
        let landed: Vec<Landed> = (0..count)
            .into_par_iter()
            .filter_map(|index| {
                let mut sampler = PixelSampler::chosen(sampling, PHOTON_COLUMN, 0, index);
                land(&tracer, casters.bundle(scene, lights, &mut sampler)?, &mut sampler)
            })
            .collect();
        let width = source_width(&landed);
        let photons: Vec<Photon> = landed.iter().map(|landed| landed.photon(width)).collect();
        (!photons.is_empty()).then(|| Self { tree: PhotonTree::new(photons) })
    }

    /// The directions of focused light around a place; `None` where there is none.
    #[inline]
    pub fn around(&self, point: DVec3) -> Option<Directions<'_>> {
        let photons = self.tree.near(point);
        (!photons.is_empty()).then_some(Directions { photons, point })
    }
}

/// The directions in which focused light is seen from a place.
#[derive(Clone, Copy)]
pub(super) struct Directions<'g> {
    photons: &'g [Photon],
    point: DVec3,
}

impl Directions<'_> {
    /// A unit direction and its density by solid angle.
    #[inline]
    pub fn draw(&self, place: [f64; 2], choice: f64) -> (DVec3, f64) {
        let forecasts = self.forecasts();
        let total: f64 = forecasts.iter().map(|forecast| forecast.weight).sum();
        let mut left = choice * total;
        let mut chosen = 0;
        while chosen + 1 < self.photons.len() && left >= forecasts[chosen].weight {
            left -= forecasts[chosen].weight;
            chosen += 1;
        }
        let direction = self.photons[chosen].draw(&forecasts[chosen], place);
        (direction, self.mixed_density(&forecasts, direction))
    }

    /// Density with which [`Directions::draw`] chooses a unit direction.
    pub fn density(&self, direction: DVec3) -> f64 {
        self.mixed_density(&self.forecasts(), direction)
    }

    /// What each photon foresees; none where there is no photon.
    #[inline]
    fn forecasts(&self) -> [Forecast; HANDFUL] {
        let mut forecasts = [Forecast::default(); HANDFUL];
        for (forecast, photon) in forecasts.iter_mut().zip(self.photons) {
            *forecast = photon.forecast(self.point);
        }
        forecasts
    }

    #[inline]
    fn mixed_density(&self, forecasts: &[Forecast; HANDFUL], direction: DVec3) -> f64 {
        let (mut total, mut sum) = (0.0, 0.0);
        for (photon, forecast) in self.photons.iter().zip(forecasts) {
            total += forecast.weight;
            sum += forecast.weight * photon.density(forecast, direction);
        }
        sum / total
    }
}

/// A bundle that landed: its middle, and how far the others landed from it, by length of their steps.
struct Landed {
    landing: Landing,
    /// Change of place and of direction by moving along the disc; `None` if they went another way.
    moved: Option<[(DVec3, DVec3); 2]>,
    /// The same by turning.
    turned: Option<[(DVec3, DVec3); 2]>,
    towards_source: DVec3,
}

fn land(tracer: &ChainTracer, bundle: Bundle, sampler: &mut PixelSampler) -> Option<Landed> {
    let mut turns: Vec<Turn> = Vec::new();
    let landing = tracer.follow(bundle.ray, sampler, &mut turns)?;
    let change = |ray, step: f64| {
        let other = tracer.follow_again(ray, &turns)?;
        Some(((other.position - landing.position) / step, (other.towards - landing.towards) / step))
    };
    let both = |[one, other]: [_; 2], step| Some([change(one, step)?, change(other, step)?]);
    let moved = both(bundle.moved, bundle.steps[0]);
    let turned = both(bundle.turned, bundle.steps[1]);
    Some(Landed { landing, moved, turned, towards_source: bundle.towards_source })
}

/// The tangent of the angle that covers a source, from the directions of rays that it sent: small sources lie apart, so of
/// all distances between directions the small ones tell. (In a disc of radius r, a quarter of the pairs are nearer than
/// 0.57 r.)
fn source_width(landed: &[Landed]) -> f64 {
    let few: Vec<DVec3> = landed.iter().step_by(landed.len() / 64 + 1).map(|landed| landed.towards_source).collect();
    let pairs =
        few.iter().enumerate().flat_map(|(index, one)| few[..index].iter().map(move |other| (*one - *other).length()));
    let mut distances: Vec<f64> = pairs.collect();
    distances.sort_by(f64::total_cmp);
    distances.get(distances.len() / 4).map_or(0.1, |quarter| quarter / 0.57)
}

impl Landed {
    /// The photon, for a source of the given width (tangent of its radius).
    fn photon(&self, width: f64) -> Photon {
        let Landing { position, normal, towards } = self.landing;
        let Frame { tangent, bitangent, .. } = Frame::around(normal);
        let along = [tangent, bitangent];
        let view = Frame::around(towards);
        let unknown = Photon {
            position,
            towards,
            axes: [view.tangent, view.bitangent],
            along,
            turn: [[0.0; 2]; 2],
            half: [width; 2],
            drift: 0.0,
        };
        let Some(turn) = self.turn_along(along) else { return unknown };
        let (axes, half) = match self.turned {
            // Seen from the same place: what turning the source does, less what the move does that brings the ray back.
            Some(turned) => {
                let seen = |(place, direction): (DVec3, DVec3)| {
                    (direction - turn[0] * tangent.dot(place) - turn[1] * bitangent.dot(place)) * width
                };
                ellipse_axes(turned.map(seen), towards)
            }
            None => (unknown.axes, unknown.half),
        };
        let on_plane = |vector: DVec3| axes.map(|axis| axis.dot(vector));
        Photon { axes, turn: turn.map(on_plane), half, ..unknown }
    }

    /// J = W Y^-1: the change of direction for a step along either axis of the surface, from the changes of place Y and of
    /// direction W by moving the start of the ray. `None` where neighbours went another way or all land in one line.
    fn turn_along(&self, [tangent, bitangent]: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let [one, other] = self.moved?;
        let flat = |offset: DVec3| [tangent.dot(offset), bitangent.dot(offset)];
        let ([a, c], [b, d]) = (flat(one.0), flat(other.0));
        let determinant = a * d - b * c;
        let flattened = determinant.abs() < 1e-6 * (a * a + b * b + c * c + d * d);
        (!flattened).then(|| [(one.1 * d - other.1 * c) / determinant, (other.1 * a - one.1 * b) / determinant])
    }
}

/// The axes of the ellipse that two vectors (at right angles to `normal`, more or less) make of the unit circle, and their
/// lengths: the singular value decomposition of two columns (Golub and Van Loan, Matrix Computations, section 8.6).
fn ellipse_axes([one, other]: [DVec3; 2], normal: DVec3) -> ([DVec3; 2], [f64; 2]) {
    // Turn the circle so that the images of its axes are at right angles.
    let (difference, product) = (one.length_squared() - other.length_squared(), 2.0 * one.dot(other));
    let angle = 0.5 * crate::math::functions::arctan2(product, difference);
    let (sine, cosine) = (crate::math::functions::sin(angle), crate::math::functions::cos(angle));
    let (long, short) = (one * cosine + other * sine, other * cosine - one * sine);
    let fallback = Frame::around(normal);
    let first = (long - normal * long.dot(normal)).try_normalize().unwrap_or(fallback.tangent);
    ([first, normal.cross(first)], [long.length(), short.length()])
}
