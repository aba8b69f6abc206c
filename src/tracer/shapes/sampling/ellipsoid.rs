//! Spheres and ellipsoids: directions uniform in the cone they fill.
//!
//! In the shape's own space it is the unit sphere, seen from distance d under the half angle m, sin m = 1/d:
//!
//! ```text
//!                     , - ~ ~ - ,
//!                 / '      |n     ' .            v = place * (1 - cos m)        uniform by solid angle
//!        ray  /  o         |/alpha   \           cos theta = 1 - v, sin^2 theta = v (2 - v)
//!         / theta|         o- - - - - |          cos alpha = d sin^2 theta + cos theta sqrt(1 - d^2 sin^2 theta)
//!      o - - - - - - - - - ^          '
//!    viewer       \      centre      /
//! ```
//!
//! `1 - cos m = sin^2 m / (1 + cos m)` does not cancel, however small or far the sphere. An affine map M carries a
//! direction w of the world to `M^-1 w` and stretches solid angles by `|det M^-1| / |M^-1 w|^3`: the density in the
//! world. That is 1 for round spheres; for ellipsoids no hidden point is ever sampled either. (Pharr, Jakob, Humphreys:
//! Physically Based Rendering, 4th ed., 6.2.4.)

use std::f64::consts::TAU;

use super::ShapeSample;
use crate::math::functions::{cos, sin};
use crate::math::{DVec3, Transform};

/// Draws points of a transformed unit sphere.
#[derive(Debug)]
pub(super) struct EllipsoidSampler {
    transform: Transform,
    /// Volume in the shape's space of a unit volume of the world.
    determinant: f64,
}

/// What is seen of the unit sphere from a point of its space.
struct View {
    /// Distance from the centre.
    distance: f64,
    /// 1 - cos of the half angle of the cone; 2, the whole sphere of directions, from inside.
    spread: f64,
}

impl View {
    #[inline]
    fn from(origin: DVec3) -> Self {
        let distance = origin.length();
        if distance <= 1.0 {
            return Self { distance, spread: 2.0 };
        }
        let cosine = ((distance - 1.0) * (distance + 1.0)).sqrt() / distance;
        Self { distance, spread: 1.0 / (distance * distance * (1.0 + cosine)) }
    }

    fn is_inside(&self) -> bool {
        self.spread == 2.0
    }
}

impl EllipsoidSampler {
    pub(super) fn new(transform: &Transform) -> Self {
        Self { transform: *transform, determinant: transform.to_object.matrix3.determinant().abs() }
    }

    #[inline]
    pub(super) fn sample_towards(&self, point: DVec3, place: [f64; 2]) -> Option<ShapeSample> {
        let origin = self.transform.to_object.transform_point3(point);
        let view = View::from(origin);
        let normal =
            if view.is_inside() { seen_from_inside(origin, place) } else { seen_from_outside(origin, &view, place) };
        let position = self.transform.to_world.transform_point3(normal);
        let offset = position - point;
        let density = self.density(&view, offset.normalize_or_zero());
        ShapeSample::with_density(offset, position, self.transform.normal_to_world(normal), density, 0)
    }

    #[inline]
    pub(super) fn density_towards(&self, point: DVec3, direction: DVec3) -> f64 {
        self.density(&View::from(self.transform.to_object.transform_point3(point)), direction)
    }

    #[inline]
    fn density(&self, view: &View, direction: DVec3) -> f64 {
        let stretched = self.transform.to_object.transform_vector3(direction);
        let square = stretched.length_squared();
        self.determinant / (square * square.sqrt() * TAU * view.spread)
    }

    /// The integral over the unit sphere of how much the map enlarges areas, `|det M| |M^-T n|`, by the midpoint rule.
    pub(super) fn area(&self) -> f64 {
        let steps = 256;
        let transposed = self.transform.to_object.matrix3.transpose();
        let mut sum = 0.0;
        for ring in 0..steps {
            let height = (2.0 * f64::from(ring) + 1.0) / f64::from(steps) - 1.0;
            let radius = (1.0 - height * height).sqrt();
            for step in 0..steps {
                let azimuth = TAU * f64::from(step) / f64::from(steps);
                sum += (transposed * DVec3::new(radius * cos(azimuth), radius * sin(azimuth), height)).length();
            }
        }
        2.0 * TAU * sum / f64::from(steps * steps) / self.determinant
    }
}

/// The point of the unit sphere that is seen at a place of the cone.
#[inline]
fn seen_from_outside(origin: DVec3, view: &View, place: [f64; 2]) -> DVec3 {
    let distance = view.distance;
    let offset = place[0] * view.spread;
    let (cosine, sine_square) = (1.0 - offset, offset * (2.0 - offset));
    // Half the chord of the ray in the sphere.
    let half_chord = (1.0 - distance * distance * sine_square).max(0.0).sqrt();
    let along = distance * sine_square + cosine * half_chord;
    let across = (distance * cosine - half_chord) * sine_square.sqrt();
    let axis = origin / distance;
    let (side, other) = axis.any_orthonormal_pair();
    let azimuth = TAU * place[1];
    (axis * along + (side * cos(azimuth) + other * sin(azimuth)) * across).normalize()
}

/// The point of the unit sphere around the viewer in a direction uniform over all.
#[inline]
fn seen_from_inside(origin: DVec3, place: [f64; 2]) -> DVec3 {
    let height = 1.0 - 2.0 * place[0];
    let radius = (2.0 * place[0] * (1.0 + height)).max(0.0).sqrt();
    let azimuth = TAU * place[1];
    let direction = DVec3::new(radius * cos(azimuth), radius * sin(azimuth), height);
    let half_b = origin.dot(direction);
    let root = (half_b * half_b + (1.0 - origin.length_squared())).max(0.0).sqrt();
    (origin + direction * (root - half_b)).normalize()
}
