//! A quantity over the cosine of a direction with the normal, tabulated; and a lobe shaped by it.

use super::microfacet::Microfacets;
use super::octaves::Octaves;
use super::quadrature::GAUSS_LEGENDRE;
use crate::math::DVec3;
use crate::math::functions::sin_cos_turns;

/// Azimuths of the quadrature over visible normals, on half a circle: the other half mirrors it.
const AZIMUTHS: usize = 32;
/// Cells of a table at least.
const CELLS: u32 = 256;

/// A function of the cosine in `[0, 1]`, itself in `[0, 1]`, linear between nodes.
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
    pub fn new(roughness: f64, function: impl Fn(f64) -> f64) -> Self {
        let octaves = Octaves::new(roughness, CELLS);
        let values: Vec<f64> = (0..=octaves.count()).map(|cell| function(octaves.node(cell))).collect();
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
    pub fn over_visible_normals(microfacets: &Microfacets, function: impl Fn(DVec3, DVec3) -> f64) -> Self {
        Self::new(microfacets.alpha(), |cosine| average_over_visible(microfacets, cosine, &function))
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

/// Integral of `2 mu` times the interpolant over a cell: Simpson's rule is exact for it.
fn mass(octaves: &Octaves, values: &[f64], cell: usize) -> f64 {
    let (low, high) = (octaves.node(cell), octaves.node(cell + 1));
    let middle = 0.5 * (low + high) * 2.0 * (values[cell] + values[cell + 1]);
    (high - low) * (low * values[cell] + middle + high * values[cell + 1]) / 3.0
}

/// Difference of the squared cosines at the ends of a cell.
fn square_width(octaves: &Octaves, cell: usize) -> f64 {
    let (low, high) = (octaves.node(cell), octaves.node(cell + 1));
    (high - low) * (high + low)
}

/// Average over the normals visible from a view with the given cosine: Gauss and Legendre's rule over the height in
/// the cap of visible normals, the midpoint rule, which converges fast for a periodic function, over the azimuth.
fn average_over_visible(microfacets: &Microfacets, cosine: f64, function: &impl Fn(DVec3, DVec3) -> f64) -> f64 {
    let view = DVec3::new(((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, cosine);
    let mut sum = 0.0;
    for azimuth in 0..AZIMUTHS {
        let (sine, cosine) = sin_cos_turns((azimuth as f64 + 0.5) / (2 * AZIMUTHS) as f64);
        for &(place, weight) in GAUSS_LEGENDRE.iter() {
            sum += weight * function(view, microfacets.visible_normal_around(view, place, cosine, sine));
        }
    }
    sum / AZIMUTHS as f64
}

/// The same by the midpoint rule with many points, for tests.
#[cfg(test)]
pub(super) fn fine_average(microfacets: &Microfacets, cosine: f64, function: impl Fn(DVec3, DVec3) -> f64) -> f64 {
    const ROWS: usize = 600;
    let view = DVec3::new(((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, cosine);
    let mut sum = 0.0;
    for azimuth in 0..ROWS {
        let (sine, cosine) = sin_cos_turns((azimuth as f64 + 0.5) / (2 * ROWS) as f64);
        for row in 0..ROWS {
            let place = (row as f64 + 0.5) / ROWS as f64;
            sum += function(view, microfacets.visible_normal_around(view, place, cosine, sine));
        }
    }
    sum / (ROWS * ROWS) as f64
}
