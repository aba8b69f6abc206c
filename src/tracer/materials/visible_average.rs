//! Averages over the microfacets that are visible from a direction, by quadrature.

use super::microfacet::Microfacets;
use super::quadrature::short_integral;
use crate::math::DVec3;
use crate::math::functions::sin_cos_turns;

/// Steps in which kinks are looked for.
const SEARCH: usize = 12;
/// Steps that make a piece of the integral at most.
const PIECE: usize = 4;
/// Kinds of kinks.
const KINKS: usize = 3;

/// What is averaged over microfacets.
pub struct Facet {
    /// The function itself.
    pub value: f64,
    /// Continuous quantities at whose zeros the function has kinks.
    pub kinks: [f64; KINKS],
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
    // Azimuths crowd at the ends of both quarters, where a grazing view hardly sees the microfacets.
    let quarter = |start: f64| {
        let turns = |t: f64| start + 0.25 * t * t * (3.0 - 2.0 * t);
        adaptive_integral(&|t| 1.5 * t * (1.0 - t) * at_azimuth(turns(t)), tolerance)
    };
    4.0 * (quarter(0.0) + quarter(0.25)) / (1.0 + stretched.z)
}

/// Integral over `[0, 1]`, halved until it no longer changes.
fn adaptive_integral(function: &impl Fn(f64) -> f64, tolerance: f64) -> f64 {
    let rule = |low: f64, high: f64| (high - low) * short_integral(|t| function(low + (high - low) * t));
    // Two halves from the start: a coincidence would have to happen in both.
    [[0.0, 0.5], [0.5, 1.0]].map(|[low, high]| refined(&rule, [low, high], rule(low, high), tolerance, 5)).iter().sum()
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
    (end - start) * short_integral(|t| 6.0 * t * (1.0 - t) * at(place(t)).value)
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
