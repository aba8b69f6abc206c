//! The unit sphere around the origin.
//!
//! ```text
//!        o----->(----------)------>      roots of |o + t d|^2 = 1 along the unit direction d,
//!              t0          t1            with b = o.d:  t = -b -+ sqrt(1 - |o - b d|^2)
//! ```

use crate::math::functions::{arctan2_turns, floor};
use crate::math::{DVec2, DVec3, Side};

/// Distance to the nearest hit in `(0, limit)`, in units of the direction's length.
///
/// A ray that leaves this sphere has one root at its origin. Outwards it never comes back; inwards the other root is
/// -2 o.d / d.d in closed form, so neither needs a tolerance.
///
/// `error` is how far, in units of the direction's length, the origin may be from where it should be: an exit no farther
/// ahead, of a ray not known to be inside, is that of a ray that starts on the surface and moves away from it.
#[inline]
pub(super) fn intersect(origin: DVec3, direction: DVec3, limit: f64, leaving: Option<Side>, error: f64) -> Option<f64> {
    let squared_length = direction.length_squared();
    let half_b = origin.dot(direction);
    let distance = match leaving {
        Some(Side::Front) => return None,
        // Rounding at grazing directions may make the chord negative: then it has no length.
        Some(Side::Back) => (-2.0 * half_b / squared_length).max(0.0),
        None => from_free_space(origin, direction, half_b, squared_length, error)?,
    };
    // A chord of no length is still a hit: the ray stays inside until it passes the surface.
    let starts_inside = leaving == Some(Side::Back);
    ((distance > 0.0 || starts_inside) && distance < limit).then_some(distance)
}

/// The nearest root ahead of a ray that starts anywhere.
#[inline(always)]
fn from_free_space(origin: DVec3, direction: DVec3, half_b: f64, squared_length: f64, error: f64) -> Option<f64> {
    let c = origin.length_squared() - 1.0;
    if half_b > 0.0 && c > 0.0 {
        return None;
    }
    // The discriminant from the distance between centre and ray does not cancel for far origins
    // (Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019). Both sides are
    // multiplied by |d|^2, so that a miss costs no division.
    let closest = origin * squared_length - direction * half_b;
    let difference = squared_length * squared_length - closest.length_squared();
    if difference < 0.0 {
        return None;
    }
    let root = (difference / squared_length).sqrt();
    // The root without cancellation first, the other from the product of the roots.
    let q = -half_b - root.copysign(half_b);
    let (first, second) = (c / q, q / squared_length);
    let (near, far) = if first < second { (first, second) } else { (second, first) };
    if near > 0.0 { Some(near) } else { is_ahead(near, far, error).then_some(far) }
}

/// True if the far root, the near one being behind, is beyond what rounding makes of an origin on the surface.
#[inline(always)]
pub(super) fn is_ahead(near: f64, far: f64, error: f64) -> bool {
    far > error - near * (1.0 / (1u64 << 50) as f64)
}

/// The outward normal at a point on the sphere.
pub(super) fn normal(point: DVec3) -> DVec3 {
    point.normalize()
}

/// Longitude about z from +x towards +y, and latitude from the south pole up, both mapped to `[0, 1]`.
pub(super) fn texture_coordinates(point: DVec3) -> DVec2 {
    let longitude = arctan2_turns(point.y, point.x);
    let from_pole = 2.0 * arctan2_turns((point.x * point.x + point.y * point.y).sqrt(), point.z);
    DVec2::new(longitude - floor(longitude) as f64, 1.0 - from_pole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_nearest_of_the_roots_ahead() {
        let hit = |origin: DVec3| intersect(origin, DVec3::X, f64::INFINITY, None, 0.0);
        assert_eq!(hit(DVec3::new(-3.0, 0.0, 0.0)), Some(2.0));
        assert_eq!(hit(DVec3::ZERO), Some(1.0));
        assert_eq!(hit(DVec3::new(3.0, 0.0, 0.0)), None);
        assert_eq!(hit(DVec3::new(-3.0, 1.5, 0.0)), None);
    }

    #[test]
    fn the_direction_may_have_any_length() {
        let hit = intersect(DVec3::new(-3.0, 0.0, 0.0), DVec3::X * 4.0, f64::INFINITY, None, 0.0);
        assert_eq!(hit, Some(0.5));
    }

    #[test]
    fn a_departing_ray_meets_the_sphere_only_at_the_other_end_of_the_chord() {
        let origin = DVec3::new(0.6, 0.8, 0.0);
        assert_eq!(intersect(origin, DVec3::NEG_X, f64::INFINITY, Some(Side::Front), 0.0), None);
        let chord = intersect(origin, DVec3::NEG_X, f64::INFINITY, Some(Side::Back), 0.0).unwrap();
        assert!((chord - 1.2).abs() < 1e-15);
    }

    #[test]
    fn a_point_of_the_far_sphere_is_hit_to_the_last_digits() {
        // Distance 1e7 radii: the textbook discriminant would be all rounding here in f32, and lose half in f64.
        let origin = DVec3::new(-1e7, 0.5, 0.0);
        let t = intersect(origin, DVec3::X, f64::INFINITY, None, 0.0).unwrap();
        let exact = 1e7 - 0.75_f64.sqrt();
        assert!((t - exact).abs() < 1e-8);
    }
}
