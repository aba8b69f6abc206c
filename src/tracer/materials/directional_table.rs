//! A quantity over the cosine of a direction with the normal, tabulated; and a lobe shaped by it.

use super::microfacet::Microfacets;
use super::octaves::Octaves;
use super::quadrature::integral;
use super::visible_average::{Facet, average_over_visible};
use crate::math::DVec3;
use crate::math::functions::sin_cos_turns;
use crate::parallel;

/// Change at which the quadrature over the azimuth is content: well below the error of the table between its nodes.
const TOLERANCE: f64 = 2e-6;
/// Cells of a table at least.
const CELLS: u32 = 1024;
/// Nodes a step in which the table is first computed.
const STRIDE: usize = 16;
/// What a quadratic may miss in the middle between computed nodes for a cubic to be good enough.
const PREDICTED: f64 = 5e-5;

/// A function of the cosine in `[0, 1]`, itself in `[0, 1]`, linear in its square root between nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionalTable {
    octaves: Octaves,
    /// One value per node, one more than there are cells.
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
    /// Tabulates a function of the cosine; `bump` as below.
    fn new(roughness: f64, bump: Option<[f64; 2]>, function: impl Fn(f64) -> f64 + Sync) -> Self {
        let octaves = Octaves::new(roughness, CELLS);
        // Looking along the surface is a limit.
        let value = |node: usize| function(octaves.node(node).max(1e-9 * roughness));
        let values = node_values(&octaves, bump, &value);
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

    /// Tabulates the average of `function(view, normal)` over the microfacet normals visible from each view. A narrow
    /// feature in the range of cosines `bump` is not missed.
    pub fn over_visible_normals(
        microfacets: &Microfacets,
        bump: Option<[f64; 2]>,
        function: impl Fn(DVec3, DVec3) -> Facet + Sync,
    ) -> Self {
        Self::new(microfacets.alpha(), bump, |cosine| average_over_visible(microfacets, cosine, TOLERANCE, &function))
    }

    /// The value at a cosine.
    #[inline]
    pub fn at(&self, cosine: f64) -> f64 {
        let (cell, place) = self.octaves.find(cosine);
        interpolated(self.values[cell], self.values[cell + 1], place)
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
        (interpolated(self.values[cell], self.values[cell + 1], place), self.level[cell])
    }
}

/// Linear between two nodes; clamped to 0, below which rounding and extrapolated nodes may go by 1e-10.
#[inline]
fn interpolated(low: f64, high: f64, place: f64) -> f64 {
    (low + (high - low) * place).max(0.0)
}

/// Values at all nodes: computed where the function bends, and between them from a cubic through computed ones where that
/// predicts the middle. In the range of cosines `bump` all are computed.
fn node_values(octaves: &Octaves, bump: Option<[f64; 2]>, value: &(dyn Fn(usize) -> f64 + Sync)) -> Vec<f64> {
    let coarse: Vec<f64> = parallel::map(0..=octaves.count() / STRIDE, |node| value(node * STRIDE));
    let fill = |interval: usize| {
        let mut values = [0.0; STRIDE + 1];
        (values[0], values[STRIDE]) = (coarse[interval], coarse[interval + 1]);
        let first = interval * STRIDE;
        let neighbour = if interval > 0 { interval - 1 } else { interval + 2 };
        let outer = (octaves.node(neighbour * STRIDE).sqrt(), coarse[neighbour]);
        let range = [octaves.node(first), octaves.node(first + STRIDE)];
        if bump.is_some_and(|bump| range[0] < bump[1] && bump[0] < range[1]) {
            (1..STRIDE).for_each(|node| values[node] = value(first + node));
        } else {
            refine(octaves, value, first, [0, STRIDE], outer, &mut values);
        }
        values
    };
    let filled = parallel::map(0..octaves.count() / STRIDE, fill);
    filled.iter().flat_map(|values| &values[..STRIDE]).chain(coarse.last()).copied().collect()
}

/// Fills the nodes between two, counted from `first`; `outer` is a node further out and its value.
fn refine(
    octaves: &Octaves,
    value: &dyn Fn(usize) -> f64,
    first: usize,
    [low, high]: [usize; 2],
    outer: (f64, f64),
    values: &mut [f64; STRIDE + 1],
) {
    if high - low < 2 {
        return;
    }
    let at = |node: usize| octaves.node(first + node).sqrt();
    let middle = (low + high) / 2;
    values[middle] = value(first + middle);
    let known = [outer, (at(low), values[low]), (at(high), values[high])];
    if (polynomial(&known, at(middle)) - values[middle]).abs() < PREDICTED {
        let known = [known[0], known[1], (at(middle), values[middle]), known[2]];
        for node in (low + 1..high).filter(|&node| node != middle) {
            values[node] = polynomial(&known, at(node));
        }
        return;
    }
    let outer = (at(high), values[high]);
    refine(octaves, value, first, [low, middle], outer, values);
    let outer = (at(low), values[low]);
    refine(octaves, value, first, [middle, high], outer, values);
}

/// Lagrange's polynomial through points, at a place.
fn polynomial(points: &[(f64, f64)], place: f64) -> f64 {
    let weight = |own: usize| -> f64 {
        let others = points.iter().enumerate().filter(|&(other, _)| other != own);
        others.map(|(_, &(x, _))| (place - x) / (points[own].0 - x)).product()
    };
    points.iter().enumerate().map(|(number, &(_, value))| value * weight(number)).sum()
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
