//! View cones: the shapes that rays through a common point may hit, from the camera or towards a light.
//!
//! ```text
//!            ____
//!           /    \           A line through the point meets the sphere of radius r around c if it lies within the cone
//!          |   c  |          that the sphere fills: with the unit direction d, (c . d)^2 >= c^2 - r^2. All but c . d
//!           \____/           is known beforehand. The cone is taken a little wider than that, so that no rounding
//!            \   /           loses a ray: what it lets pass is tested again.
//!             \ /
//!              o ---- d
//! ```
//!
//! Measured by `skycube render SCENE --threads 1` without the cones: 8 % more CPU time for three spheres and for
//! `lessons/03-phong-shadows/balls-with-shadows.toml`, 1 % for `lessons/06-environment-map/environment-with.toml`. That is less
//! than a speed trick should save; they stay for the three spheres, which other ray tracers are compared on.

use super::sphere_pack::{LANES, SpherePack};
use crate::math::DVec3;

/// By how much the cones are widened: a share of the squared distance, far above what rounding makes of it.
const SLACK: f64 = 1e-9;

/// How far away, in distances of the nearest centre, a ray may start that goes through the point: from farther away,
/// rounding of its direction makes it miss the point by more than the slack.
const REACH: f64 = 1e5;

/// Four spheres as seen from a point.
#[derive(Debug, Clone)]
pub struct ViewCones {
    point: DVec3,
    /// From the point to the centres, by axis.
    towards: [[f64; LANES]; 3],
    /// `c^2 - r^2` and a little less: infinite for empty lanes, minus infinity around spheres that contain the point.
    threshold: [f64; LANES],
    /// Greatest distance from the point of the other end of a ray.
    reach: f64,
}

impl ViewCones {
    /// The view of the spheres from a point.
    pub fn new(pack: &SpherePack, point: DVec3) -> Self {
        let mut cones = Self { point, towards: pack.centre, threshold: [f64::INFINITY; LANES], reach: f64::INFINITY };
        for lane in 0..LANES {
            let mut squared_distance = 0.0;
            for axis in 0..3 {
                let component = pack.centre[axis][lane] - point[axis];
                cones.towards[axis][lane] = component;
                squared_distance += component * component;
            }
            if pack.squared_radius[lane] < 0.0 {
                continue;
            }
            // A ray that leaves the sphere may start a rounding error beside it.
            let radius = pack.squared_radius[lane].sqrt();
            let largest = (0..3).map(|axis| pack.centre[axis][lane].abs()).fold(radius, f64::max);
            let widened = radius + (largest + radius) * (1.0 / (1u64 << 50) as f64);
            let threshold = squared_distance * (1.0 - SLACK) - widened * widened;
            cones.threshold[lane] = if threshold > 0.0 { threshold } else { f64::NEG_INFINITY };
            cones.reach = cones.reach.min(REACH * squared_distance.sqrt());
        }
        cones
    }

    /// Where it is seen from.
    pub fn point(&self) -> DVec3 {
        self.point
    }

    /// False only if no sphere is met by a ray in this unit direction from the point, or by one to the point that starts
    /// `distance` away in this direction. True does not promise a hit.
    #[inline(always)]
    pub fn may_meet(&self, direction: DVec3, distance: f64) -> bool {
        let [dx, dy, dz] = direction.to_array();
        let mut met = distance > self.reach;
        for lane in 0..LANES {
            let ahead = self.towards[0][lane] * dx + self.towards[1][lane] * dy + self.towards[2][lane] * dz;
            met |= ahead * ahead.abs() >= self.threshold[lane];
        }
        met
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::math::Ray;

    /// A sphere of a radius at the distance 1 along x, alone.
    fn view_cones(radius: f64) -> ViewCones {
        ViewCones::new(&SpherePack::new(&[(0, DVec3::X, radius)]), DVec3::ZERO)
    }

    #[test]
    fn no_less_and_little_more_than_the_cone_of_the_ball_passes() {
        for radius in [1e-3, 0.1, 0.5, 0.999] {
            let cones = view_cones(radius);
            let rim = libm::asin(radius);
            let passes = |angle: f64| cones.may_meet(DVec3::new(libm::cos(angle), libm::sin(angle), 0.0), 0.0);
            // The slack widens the squared sine of the half angle by itself.
            let slack = 2.0 * SLACK / radius.min(libm::cos(rim));
            assert!(passes(0.0) && passes(rim - 1e-12) && passes(-rim + 1e-12), "{radius}");
            assert!(!passes(rim + slack) && !passes(-rim - slack), "{radius}");
            assert!(!passes(std::f64::consts::PI), "behind, {radius}");
        }
    }

    #[test]
    fn from_inside_and_from_too_far_away_nothing_is_ruled_out() {
        assert!(view_cones(1.5).may_meet(DVec3::NEG_X, 0.0));
        assert!(view_cones(0.1).may_meet(DVec3::NEG_X, 2.0 * REACH));
        let empty = ViewCones::new(&SpherePack::new(&[]), DVec3::ZERO);
        assert!(!empty.may_meet(DVec3::X, 1e300));
    }

    proptest! {
        /// Rays along the rim of a sphere, missing or meeting it by next to nothing, at many scales: what is met is not
        /// ruled out, from the point and towards it.
        #[test]
        fn what_is_met_is_not_ruled_out(
            centre in prop::array::uniform3(-3.0..3.0_f64),
            aside in prop::array::uniform3(-1.0..1.0_f64),
            scale in -6.0..6.0_f64,
            size in -4.0..0.0_f64,
            past in prop_oneof![Just(0.0), -1e-9..1e-9_f64, -1e-14..1e-14_f64],
            beyond in 0.1..4.0_f64,
        ) {
            let centre = DVec3::from(centre) * libm::pow(10.0, scale);
            let distance = centre.length();
            let radius = distance * libm::pow(10.0, size) * 0.99;
            let across = DVec3::from(aside).cross(centre).normalize();
            prop_assume!(across.is_finite());
            // The point of contact of a tangent from the origin: the sine of its angle is radius / distance.
            let sine = radius / distance * (1.0 + past);
            let cosine = (1.0 - sine * sine).max(0.0).sqrt();
            let direction = (centre / distance * cosine + across * sine).normalize();
            let pack = SpherePack::new(&[(0, centre, radius)]);
            let met = |ray: &Ray, limit: f64| pack.hits(ray, |_, t| t < limit);
            let cones = ViewCones::new(&pack, DVec3::ZERO);
            if met(&Ray::new(DVec3::ZERO, direction), f64::INFINITY) {
                prop_assert!(cones.may_meet(direction, 0.0));
            }
            let start = direction * (distance * beyond);
            let back = -start.normalize();
            if met(&Ray::new(start, back), start.length()) {
                prop_assert!(cones.may_meet(-back, start.length()));
            }
        }
    }
}
