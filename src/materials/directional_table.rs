//! A quantity over the cosine of a direction with the normal, tabulated; and a lobe shaped by it.

use rayon::prelude::*;

use super::microfacet::Microfacets;
use super::octaves::Octaves;
use super::quadrature::{integral, short_integral};
use crate::math::DVec3;
use crate::math::functions::sin_cos_turns;

/// Steps in which kinks are looked for.
const SEARCH: usize = 16;
/// Steps that make a piece of the integral at most.
const PIECE: usize = 8;
/// Change at which the quadrature over the azimuth is content: well below the error of the table between its nodes.
const TOLERANCE: f64 = 3e-6;
/// Kinds of kinks.
const KINKS: usize = 3;
/// Cells of a table at least.
const CELLS: u32 = 256;

/// What is averaged over microfacets.
pub struct Facet {
    /// The function itself.
    pub value: f64,
    /// Continuous quantities at whose zeros the function has kinks.
    pub kinks: [f64; KINKS],
}

/// A function of the cosine in `[0, 1]`, itself in `[0, 1]`, linear in its square root between nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionalTable {
    octaves: Octaves,
    /// One value a node, one more than there are cells.
    values: Vec<f64>,
    /// Integral over all cosines, each weighted by `2 mu`: of the table as it is looked up, exact.
    average: f64,
    inverse_average: f64,
    /// Share of that integral up to the end of each cell.
    cumulative: Vec<f64>,
    /// Density of the lobe in each cell, in units of the cosine lobe's.
    level: Vec<f64>,
}

impl DirectionalTable {
    /// Tabulates a function of the cosine.
    pub fn new(roughness: f64, function: impl Fn(f64) -> f64 + Sync) -> Self {
        let octaves = Octaves::new(roughness, CELLS);
        // Looking along the surface is a limit.
        let value = |cell: usize| function(octaves.node(cell).max(1e-9 * roughness));
        let values: Vec<f64> = (0..=octaves.count()).into_par_iter().map(value).collect();
        let masses: Vec<f64> = (0..octaves.count()).map(|cell| mass(&octaves, &values, cell)).collect();
        let average: f64 = masses.iter().sum();
        let inverse_average = if average > 0.0 { 1.0 / average } else { 0.0 };
        let mut sum = 0.0;
        let cumulative = masses
            .iter()
            .map(|mass| {
                sum += mass * inverse_average;
                sum
            })
            .collect();
        let level = masses
            .iter()
            .enumerate()
            .map(|(cell, mass)| mass * inverse_average / square_width(&octaves, cell))
            .collect();
        Self { octaves, values, average, inverse_average, cumulative, level }
    }

    /// Tabulates the average of `function(view, normal)` over the microfacet normals visible from each view.
    pub fn over_visible_normals(microfacets: &Microfacets, function: impl Fn(DVec3, DVec3) -> Facet + Sync) -> Self {
        Self::new(microfacets.alpha(), |cosine| average_over_visible(microfacets, cosine, TOLERANCE, &function))
    }

    /// The value at a cosine.
    #[inline]
    pub fn at(&self, cosine: f64) -> f64 {
        let (cell, place) = self.octaves.find(cosine);
        let (low, high) = (self.values[cell], self.values[cell + 1]);
        low + (high - low) * place
    }

    /// The integral of `2 mu` times the value.
    #[inline]
    pub fn average(&self) -> f64 {
        self.average
    }

    /// One over that average; 0 if there is nothing.
    #[inline]
    pub fn inverse_average(&self) -> f64 {
        self.inverse_average
    }

    /// A direction about +z whose density is nearly proportional to value times cosine.
    pub fn lobe_direction(&self, place: [f64; 2]) -> DVec3 {
        let cell = self.cumulative.partition_point(|&sum| sum <= place[0]).min(self.octaves.count() - 1);
        let before = if cell == 0 { 0.0 } else { self.cumulative[cell - 1] };
        let share = ((place[0] - before) / (self.cumulative[cell] - before)).clamp(0.0, 1.0);
        let (low, high) = (self.octaves.node(cell), self.octaves.node(cell + 1));
        // Even in mu^2 within a cell.
        let square = low * low + share * (high - low) * (high + low);
        let (sine, cosine) = sin_cos_turns(place[1]);
        let radius = (1.0 - square).max(0.0).sqrt();
        DVec3::new(radius * cosine, radius * sine, square.sqrt())
    }

    /// The value at a cosine, and the density of [`Self::lobe_direction`] there, over `cosine / pi`.
    #[inline]
    pub fn at_with_lobe(&self, cosine: f64) -> (f64, f64) {
        let (cell, place) = self.octaves.find(cosine);
        let (low, high) = (self.values[cell], self.values[cell + 1]);
        (low + (high - low) * place, self.level[cell])
    }
}

/// Integral of `2 mu` times the interpolant over a cell. With `w = sqrt(mu)`, in which the interpolant is linear, that is
/// the integral of `4 w^3 (a + b w)`.
fn mass(octaves: &Octaves, values: &[f64], cell: usize) -> f64 {
    let (low, high) = (octaves.node(cell).sqrt(), octaves.node(cell + 1).sqrt());
    let width = high - low;
    // Written with the two values' own weights, so that nothing cancels: Gauss and Legendre's rule is exact here.
    integral(|place| {
        let w = low + width * place;
        4.0 * w * w * w * (values[cell] + (values[cell + 1] - values[cell]) * place)
    }) * width
}

/// Difference of the squared cosines at the ends of a cell.
fn square_width(octaves: &Octaves, cell: usize) -> f64 {
    let (low, high) = (octaves.node(cell), octaves.node(cell + 1));
    (high - low) * (high + low)
}

/// Average over the normals visible from a view with the given cosine, which is more than 0.
///
/// In the space where the microfacets are a hemisphere, a normal at the angle theta from the stretched view s is visible
/// with a density even in `q = sin^2 theta` and in the azimuth psi about s, as far as it is above the horizon. So psi
/// outside, q inside up to the horizon: Gauss and Legendre's rule for both, piece by piece between the kinks.
pub(super) fn average_over_visible(
    microfacets: &Microfacets,
    cosine: f64,
    tolerance: f64,
    function: impl Fn(DVec3, DVec3) -> Facet,
) -> f64 {
    let view = DVec3::new(((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, cosine);
    let stretched = microfacets.stretched(view);
    // The axis from which psi is counted: up from the stretched view.
    let up = DVec3::new(-stretched.z, 0.0, stretched.x);
    let at_azimuth = |turns: f64| {
        let (sine, cosine) = sin_cos_turns(turns);
        let axis = DVec3::new(up.x * cosine, sine, up.z * cosine);
        let falling = stretched.x * cosine.min(0.0);
        let height = stretched.z * stretched.z;
        let horizon = height / (height + falling * falling);
        let at = |place: f64| {
            let square = place * horizon;
            let normal = stretched * (1.0 - square).max(0.0).sqrt() + axis * square.sqrt();
            function(view, microfacets.shrunk(normal))
        };
        horizon * integral_between_kinks(&at)
    };
    let sum = adaptive_integral(&at_azimuth, [0.0, 0.25], tolerance, 6)
        + adaptive_integral(&at_azimuth, [0.25, 0.5], tolerance, 6);
    4.0 * sum / (1.0 + stretched.z)
}

/// Integral over a range, halved until it no longer changes.
fn adaptive_integral(function: &impl Fn(f64) -> f64, range: [f64; 2], tolerance: f64, depth: u32) -> f64 {
    let rule = |low: f64, high: f64| (high - low) * short_integral(|t| function(low + (high - low) * t));
    refined(&rule, range, rule(range[0], range[1]), tolerance, depth)
}

fn refined(rule: &impl Fn(f64, f64) -> f64, [low, high]: [f64; 2], whole: f64, tolerance: f64, depth: u32) -> f64 {
    let middle = 0.5 * (low + high);
    let halves = [rule(low, middle), rule(middle, high)];
    let sum = halves[0] + halves[1];
    if depth == 0 || (sum - whole).abs() < tolerance {
        return sum;
    }
    refined(rule, [low, middle], halves[0], tolerance, depth - 1)
        + refined(rule, [middle, high], halves[1], tolerance, depth - 1)
}

/// Integral over `[0, 1]` of a function with kinks.
fn integral_between_kinks(at: &impl Fn(f64) -> Facet) -> f64 {
    let mut sum = 0.0;
    let mut start = 0.0;
    let (mut low, mut before) = (0.0, at(0.0).kinks);
    for step in 1..=SEARCH {
        let high = search_place(step);
        let after = at(high).kinks;
        let mut ends = [high; KINKS];
        for kink in 0..KINKS {
            if (before[kink] > 0.0) != (after[kink] > 0.0) {
                ends[kink] = zero(&|place| at(place).kinks[kink], [low, high], [before[kink], after[kink]]);
            }
        }
        ends.sort_by(f64::total_cmp);
        for end in ends.into_iter().filter(|&end| end < high) {
            sum += piece(at, start, end);
            start = end;
        }
        if step % PIECE == 0 {
            sum += piece(at, start, high);
            start = high;
        }
        (low, before) = (high, after);
    }
    sum
}

/// Places in `[0, 1]` that crowd at both ends, where the microfacets are that face the view, and those hardly seen.
fn search_place(step: usize) -> f64 {
    let t = step as f64 / SEARCH as f64;
    let (rising, falling) = (t * t * t * t, (1.0 - t) * (1.0 - t) * (1.0 - t) * (1.0 - t));
    rising / (rising + falling)
}

/// Integral over a piece without kinks inside; points crowd at both ends, where square roots begin.
fn piece(at: &impl Fn(f64) -> Facet, start: f64, end: f64) -> f64 {
    let place = |t: f64| start + (end - start) * (t * t * (3.0 - 2.0 * t));
    (end - start) * integral(|t| 6.0 * t * (1.0 - t) * at(place(t)).value)
}

/// A zero between two places with values of different sign (the Illinois variant of the false position).
fn zero(function: &impl Fn(f64) -> f64, mut places: [f64; 2], mut values: [f64; 2]) -> f64 {
    for _ in 0..10 {
        let place = (places[0] * values[1] - places[1] * values[0]) / (values[1] - values[0]);
        let value = function(place);
        if value == 0.0 || !place.is_finite() {
            return if place.is_finite() { place } else { places[0] };
        }
        if (value > 0.0) == (values[1] > 0.0) {
            values[0] *= 0.5;
        } else {
            (places[0], values[0]) = (places[1], values[1]);
        }
        (places[1], values[1]) = (place, value);
    }
    places[1].clamp(0.0, 1.0)
}
