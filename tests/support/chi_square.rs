//! Does a sampling routine follow the density it states? Pearson's chi-square test over bins on the sphere.
//!
//! The bins are rings about a pole, cut into sectors. The density is integrated over every bin by adaptive Simpson
//! quadrature; what it lacks to 1 must be the share of samples that fail.
#![allow(dead_code)] // Every test uses a part of it.

use std::f64::consts::{PI, TAU};

use skycube::math::DVec3;

/// Bins on the sphere.
pub struct Bins {
    pole: DVec3,
    /// Angles from the pole, from 0 to pi.
    rings: Vec<f64>,
    sectors: usize,
}

/// What a test found.
#[derive(Debug, Clone, Copy)]
pub struct Outcome {
    pub statistic: f64,
    pub degrees_of_freedom: f64,
    /// Probability of a statistic at least as large if the samples follow the density.
    pub p_value: f64,
    /// Integral of the density over the sphere.
    pub integral: f64,
}

impl Outcome {
    /// True at the significance 1e-3, shared among all tests of a family (Bonferroni).
    pub fn passes(&self, tests: usize) -> bool {
        self.p_value > 1e-3 / tests as f64
    }
}

impl Bins {
    /// Rings of even width.
    pub fn even(pole: DVec3, rings: usize, sectors: usize) -> Self {
        let rings = (0..=rings).map(|ring| PI * ring as f64 / rings as f64).collect();
        Self { pole, rings, sectors }
    }

    /// Rings that grow from a tenth of `spread` on in even ratios: for densities that peak at the pole.
    pub fn focused(pole: DVec3, spread: f64, rings: usize, sectors: usize) -> Self {
        let first = 0.1 * spread;
        let growth = |ring: usize| first * (PI / first).powf((ring - 1) as f64 / (rings - 1) as f64);
        Self { pole, rings: std::iter::once(0.0).chain((1..=rings).map(growth)).collect(), sectors }
    }

    fn direction(&self, angle: f64, azimuth: f64) -> DVec3 {
        let (x, y) = self.pole.any_orthonormal_pair();
        let (sine, cosine) = angle.sin_cos();
        (x * azimuth.cos() + y * azimuth.sin()) * sine + self.pole * cosine
    }

    fn find(&self, direction: DVec3) -> usize {
        let (x, y) = self.pole.any_orthonormal_pair();
        let across = DVec3::new(direction.dot(x), direction.dot(y), direction.dot(self.pole));
        let angle = across.truncate().length().atan2(across.z);
        let ring = self.rings[1..].partition_point(|&edge| edge < angle).min(self.rings.len() - 2);
        let turn = across.y.atan2(across.x).rem_euclid(TAU) / TAU;
        ring * self.sectors + ((turn * self.sectors as f64) as usize).min(self.sectors - 1)
    }

    /// Integral of the density over every bin.
    fn integrate(&self, density: &impl Fn(DVec3) -> f64) -> Vec<f64> {
        let integrand = |angle: f64, azimuth: f64| density(self.direction(angle, azimuth)) * angle.sin();
        let width = TAU / self.sectors as f64;
        self.rings
            .windows(2)
            .flat_map(|ring| (0..self.sectors).map(move |sector| (ring[0], ring[1], sector as f64 * width)))
            .map(|(low, high, azimuth)| adaptive(&integrand, [low, high], [azimuth, azimuth + width], 7))
            .collect()
    }
}

/// Tests `count` samples against the density. A sample of `None` failed, or is not in the part that is tested.
pub fn chi_square(
    bins: &Bins,
    count: usize,
    mut sample: impl FnMut() -> Option<DVec3>,
    density: impl Fn(DVec3) -> f64,
) -> Outcome {
    let shares = bins.integrate(&density);
    let mut found = vec![0.0; shares.len()];
    let mut failed = 0.0;
    for _ in 0..count {
        match sample() {
            Some(direction) => found[bins.find(direction)] += 1.0,
            None => failed += 1.0,
        }
    }
    let integral: f64 = shares.iter().sum();
    let mut cells: Vec<(f64, f64)> = shares
        .iter()
        .map(|share| share * count as f64)
        .zip(found)
        .chain([((1.0 - integral) * count as f64, failed)])
        .collect();
    cells.sort_by(|one, other| one.0.total_cmp(&other.0));
    compare(&cells, integral)
}

/// The statistic over pairs of expected and found counts, the smallest expected first: those below 5 are pooled.
fn compare(cells: &[(f64, f64)], integral: f64) -> Outcome {
    let (mut statistic, mut categories) = (0.0, 0.0);
    let mut pool = (0.0, 0.0);
    for &(expected, found) in cells {
        pool = (pool.0 + expected, pool.1 + found);
        if pool.0 >= 5.0 {
            statistic += (pool.1 - pool.0) * (pool.1 - pool.0) / pool.0;
            categories += 1.0;
            pool = (0.0, 0.0);
        }
    }
    let degrees_of_freedom = f64::max(categories - 1.0, 1.0);
    let p_value = upper_gamma(0.5 * degrees_of_freedom, 0.5 * statistic);
    Outcome { statistic, degrees_of_freedom, p_value, integral }
}

/// Simpson's rule in two dimensions, halved until two refinements agree.
fn adaptive(function: &impl Fn(f64, f64) -> f64, x: [f64; 2], y: [f64; 2], depth: usize) -> f64 {
    let middle = |range: [f64; 2]| 0.5 * (range[0] + range[1]);
    let (mx, my) = (middle(x), middle(y));
    let parts =
        [([x[0], mx], [y[0], my]), ([mx, x[1]], [y[0], my]), ([x[0], mx], [my, y[1]]), ([mx, x[1]], [my, y[1]])];
    let coarse = simpson(function, x, y);
    let fine: f64 = parts.iter().map(|&(x, y)| simpson(function, x, y)).sum();
    if depth == 0 || (fine - coarse).abs() < 1e-7 + 1e-5 * fine.abs() {
        return fine;
    }
    parts.iter().map(|&(x, y)| adaptive(function, x, y, depth - 1)).sum()
}

fn simpson(function: &impl Fn(f64, f64) -> f64, x: [f64; 2], y: [f64; 2]) -> f64 {
    let mut sum = 0.0;
    for (across, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
        for (up, other_weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
            sum += weight * other_weight * function(x[0] + across * (x[1] - x[0]), y[0] + up * (y[1] - y[0]));
        }
    }
    sum * (x[1] - x[0]) * (y[1] - y[0]) / 36.0
}

/// The regularised upper incomplete gamma function Q(a, x) (Press et al., Numerical Recipes, section 6.2).
fn upper_gamma(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 1.0;
    }
    let front = (a * x.ln() - x - libm::lgamma(a)).exp();
    if x < a + 1.0 {
        let (mut term, mut sum, mut order) = (1.0 / a, 1.0 / a, a);
        while term > sum * 1e-15 {
            order += 1.0;
            term *= x / order;
            sum += term;
        }
        return 1.0 - front * sum;
    }
    // Lentz's method for the continued fraction.
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1e300, 1.0 / b);
    let mut fraction = d;
    for step in 1..10_000 {
        let step = f64::from(step);
        let numerator = -step * (step - a);
        b += 2.0;
        d = 1.0 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= c * d;
        if (c * d - 1.0).abs() < 1e-14 {
            break;
        }
    }
    front * fraction
}

#[test]
fn the_harness_knows_chi_squares_quantiles() {
    // Tables: 18.307 is the 95 % quantile for 10 degrees of freedom, 149.449 the 99.9 % quantile for 100.
    assert!((upper_gamma(5.0, 18.307 / 2.0) - 0.05).abs() < 1e-5);
    assert!((upper_gamma(50.0, 149.449 / 2.0) - 0.001).abs() < 1e-6);
    assert!((upper_gamma(0.5, 0.5) - 0.317_310_5).abs() < 1e-6);
}
