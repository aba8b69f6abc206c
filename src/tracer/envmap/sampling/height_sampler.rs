//! Constant and gradient: the luminance is linear in the height above the horizon, up and down.
//!
//! By Archimedes a zone of the sphere has the area `2 pi dh`, so height and azimuth are independent, and the density
//! in the height is two straight lines:
//!
//! ```text
//!     nadir |\            /| zenith       h = height = sine of the elevation
//!           |  \        /  |              integral = 2 pi ((nadir + horizon) / 2 + (horizon + zenith) / 2)
//!           |    \ __ /    |
//!    h = -1 +------+-------+ h = 1
//!                horizon
//! ```

use std::f64::consts::TAU;

use super::brightness::BrightnessHistogram;
use super::cells::Cell;
use super::texel_means::weighed_luminance;
use crate::envmap::Gradient;
use crate::math::DVec3;
use crate::math::functions::{cos, sin};

/// Draws directions of an environment that depends on the height alone.
#[derive(Debug, Clone)]
pub(super) struct HeightSampler {
    /// Up, and two axes of the horizon.
    up: DVec3,
    horizontal: [DVec3; 2],
    zenith: f64,
    horizon: f64,
    nadir: f64,
}

impl HeightSampler {
    pub(super) fn new(gradient: &Gradient) -> Self {
        let up = gradient.up.direction().as_dvec3();
        let side = DVec3::new(up.y, up.z, up.x);
        let [zenith, horizon, nadir] =
            [gradient.zenith, gradient.horizon, gradient.nadir].map(|colour| f64::from(weighed_luminance(colour)));
        Self { up, horizontal: [side, up.cross(side)], zenith, horizon, nadir }
    }

    /// Integral of the luminance over the sphere.
    pub(super) fn power(&self) -> f64 {
        TAU * (self.above() + self.below())
    }

    fn above(&self) -> f64 {
        (self.horizon + self.zenith) / 2.0
    }

    fn below(&self) -> f64 {
        (self.horizon + self.nadir) / 2.0
    }

    #[inline]
    pub(super) fn sample(&self, place: [f64; 2]) -> (DVec3, f64) {
        // The lower half of the sphere takes its share of [0, 1) from the left, and runs from nadir to horizon.
        let target = place[1] * (self.above() + self.below()) - self.below();
        let (sign, end, half) =
            if target < 0.0 { (-1.0, self.nadir, self.below()) } else { (1.0, self.zenith, self.above()) };
        let height = sign * invert_line(self.horizon, end, (sign * target / half).min(1.0));
        let radius = ((1.0 - height) * (1.0 + height)).max(0.0).sqrt();
        let azimuth = TAU * place[0];
        let [x, y] = self.horizontal;
        let direction = self.up * height + x * (radius * cos(azimuth)) + y * (radius * sin(azimuth));
        (direction, self.density_at(height))
    }

    #[inline]
    pub(super) fn density(&self, direction: DVec3) -> f64 {
        self.density_at(direction.dot(self.up).clamp(-1.0, 1.0))
    }

    fn density_at(&self, height: f64) -> f64 {
        self.luminance_at(height) / self.power()
    }

    fn luminance_at(&self, height: f64) -> f64 {
        let end = if height < 0.0 { self.nadir } else { self.zenith };
        self.horizon + (end - self.horizon) * height.abs()
    }

    /// Adds zones of equal height, fine enough for any share.
    pub(super) fn spread(&self, histogram: &mut BrightnessHistogram) {
        let zones = 1 << 16;
        let solid_angle = 2.0 * TAU / f64::from(zones);
        for zone in 0..zones {
            let height = (2.0 * f64::from(zone) + 1.0) / f64::from(zones) - 1.0;
            histogram.add(Cell { power: self.luminance_at(height) * solid_angle, solid_angle });
        }
    }
}

/// Where on `[0, 1]` the share `x` of the integral of the line from `a` to `b` is reached; without cancellation also
/// for equal ends.
#[inline]
fn invert_line(a: f64, b: f64, x: f64) -> f64 {
    let denominator = a + (a * a + x * (b * b - a * a)).max(0.0).sqrt();
    if denominator == 0.0 { 0.0 } else { (x * (a + b) / denominator).min(1.0) }
}
