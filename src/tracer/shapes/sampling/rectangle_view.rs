//! A rectangle as seen from a point: its solid angle, and points uniform in it.
//!
//! The rectangle lies parallel to the axes x and y at depth z below the viewer, from (x0, y0) to (x1, y1):
//!
//! ```text
//!            o viewer at the origin             The spherical quadrilateral has the inner angles g0 (at x1, y0),
//!           /|\                                 g1 (x1, y1), g2 (x0, y1), g3 (x0, y0); its area is their excess
//!      y1 +-----+  at depth z                   g0 + g1 + g2 + g3 - 2 pi (Girard). With r the distance of
//!        /     /                                a corner, each is arctan2(z r, +-x y).
//!    y0 +-----+
//!      x0     x1
//! ```
//!
//! Urena, Fajardo, King: An Area-Preserving Parametrization for Spherical Rectangles, EGSR 2013. Two things differ: the
//! angles are computed by arctan2 instead of arccos of a dot product, which loses half the digits at grazing angles, and
//! `1 - cu^2` is written without cancellation.

use std::f64::consts::TAU;

use crate::math::functions::{arctan2, cos, sin};

/// A rectangle relative to the viewer.
#[derive(Debug, Clone, Copy)]
pub(super) struct RectangleView {
    x: [f64; 2],
    y: [f64; 2],
    /// Distance from the plane, not negative.
    depth: f64,
    /// In steradians.
    pub solid_angle: f64,
    /// `2 pi - g2 - g3`.
    offset: f64,
}

impl RectangleView {
    #[inline]
    pub(super) fn new(x: [f64; 2], y: [f64; 2], depth: f64) -> Self {
        let angle = |x: f64, y: f64, product: f64| arctan2(depth * (x * x + y * y + depth * depth).sqrt(), product);
        let ([x0, x1], [y0, y1]) = (x, y);
        let (g0, g1) = (angle(x1, y0, x1 * y0), angle(x1, y1, -x1 * y1));
        let (g2, g3) = (angle(x0, y1, x0 * y1), angle(x0, y0, -x0 * y0));
        let offset = TAU - g2 - g3;
        Self { x, y, depth, solid_angle: g0 + g1 - offset, offset }
    }

    /// The place (x, y) on the rectangle for a place in `[0, 1)^2`, uniform by solid angle.
    #[inline]
    pub(super) fn draw(&self, place: [f64; 2]) -> [f64; 2] {
        let x = self.draw_x(place[0]);
        // Along the line x = const, uniform by solid angle is uniform in the sine of the elevation.
        let square = x * x + self.depth * self.depth;
        let height = |y: f64| y / (square + y * y).sqrt();
        let (low, high) = (height(self.y[0]), height(self.y[1]));
        let drawn = low + place[1] * (high - low);
        let y = drawn * (square / ((1.0 - drawn) * (1.0 + drawn))).sqrt();
        [x, y.max(self.y[0]).min(self.y[1])]
    }

    #[inline]
    fn draw_x(&self, place: f64) -> f64 {
        let (z, [y0, y1]) = (self.depth, self.y);
        // Components along z of the unit normals of the sides y0 and y1.
        let (b0, b1) = (-y0 / (z * z + y0 * y0).sqrt(), y1 / (z * z + y1 * y1).sqrt());
        let angle = place * self.solid_angle + self.offset;
        let f = (cos(angle) * b0 - b1) / sin(angle);
        // 1 - b0^2.
        let rest = z * z / (z * z + y0 * y0);
        let x = z.copysign(f) / (f * f - rest).max(0.0).sqrt();
        x.max(self.x[0]).min(self.x[1])
    }
}
