//! A ray prepared for conservative box tests in single precision.

use super::FloatBox;
use crate::math::DVec3;

/// Unit roundoff of `f32`: the largest relative error of one operation.
const ROUNDOFF: f64 = 1.0 / (1u64 << 24) as f64;

/// A ray against the boxes of one hierarchy.
///
/// A box is the meeting of three slabs, each between two parallel planes. To be safe, a ray enters a slab a little
/// early and leaves it a little late:
///
/// ```text
///            near plane             far plane
///    entry here |                       | exit here
///          <----|                       |---->
///    o--------->|======== inside =======|--------->  direction
/// ```
///
/// * The origin is moved up to the outermost box first, in `f64`, so that a camera far away loses nothing.
/// * The position is off by the rounding of the origin, of the direction over the length of the box, and of the plane
///   tests: all below `error`, by which each plane is moved outwards.
///   (Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection", JCGT 2013, section 3.3.)
/// * The relative error of the quotient is covered by making the exit later by 1 + 2 gamma(3).
///   (Ize: "Robust BVH Ray Traversal", JCGT 2013.)
/// * 0 * infinity, a ray in the plane of a side, is NaN; NaN compares as a hit.
#[derive(Debug, Clone, Copy)]
pub struct HierarchyRay {
    /// The ray parameter of the moved origin.
    shift: f64,
    /// Largest component of the direction: the `f32` ray has 1 there, and parameters in units of that length.
    scale: f64,
    /// The moved origin.
    pub origin: [f32; 3],
    /// Bound of the error of any position along the ray inside the hierarchy, along any axis.
    pub error: f32,
    pub(super) origin_near: [f32; 3],
    pub(super) origin_far: [f32; 3],
    pub(super) inverse: [f32; 3],
    pub(super) inverse_far: [f32; 3],
    /// Whether the direction is negative along the axis: then the near plane is the maximum.
    pub(super) negative: [bool; 3],
}

impl HierarchyRay {
    /// Prepares a ray; `None` if it misses the box around everything, or is not a ray (zero or not finite).
    #[inline]
    pub fn new(bounds: &FloatBox, origin: DVec3, direction: DVec3) -> Option<Self> {
        let scale = direction.abs().max_element();
        if !(scale > 0.0 && direction.is_finite() && origin.is_finite()) {
            return None;
        }
        let inverse = DVec3::ONE / direction;
        let shift = entry(bounds, origin, inverse)?;
        let moved = if shift > 0.0 { origin + direction * shift } else { origin };
        let error = 16.0 * ROUNDOFF * (bounds.reach(moved) + moved.abs().max_element());
        let negative = direction.to_array().map(|component| component.is_sign_negative());
        let scaled = (inverse * scale).to_array().map(|component| component as f32);
        let moved_by = |sign: f64| {
            std::array::from_fn(|axis| {
                let outward = if negative[axis] { -error } else { error };
                (moved[axis] + sign * outward) as f32
            })
        };
        Some(Self {
            shift,
            scale,
            origin: moved.to_array().map(|component| component as f32),
            error: error as f32,
            origin_near: moved_by(1.0),
            origin_far: moved_by(-1.0),
            inverse: scaled,
            inverse_far: scaled.map(|component| component * (1.0 + 12.0 * ROUNDOFF as f32)),
            negative,
        })
    }

    /// The ray parameter `t` in the units of the `f32` ray, rounded up.
    #[inline]
    pub(super) fn limit(&self, t: f64) -> f32 {
        let exact = (t - self.shift) * self.scale;
        (exact + exact.abs() * (16.0 * ROUNDOFF)) as f32 + self.error
    }
}

/// Where the ray enters the box, 0 if it starts inside; `None` if it misses. The box is taken a little too large.
#[inline]
fn entry(bounds: &FloatBox, origin: DVec3, inverse: DVec3) -> Option<f64> {
    let (minimum, maximum) = (bounds.minimum.as_dvec3(), bounds.maximum.as_dvec3());
    let magnitude = origin.abs().max(minimum.abs()).max(maximum.abs()).max_element();
    let slack = DVec3::splat(magnitude * (1.0 / (1u64 << 46) as f64));
    let first = (minimum - slack - origin) * inverse;
    let second = (maximum + slack - origin) * inverse;
    let mut enter = 0.0_f64;
    let mut exit = f64::INFINITY;
    for axis in 0..3 {
        // `f64::max` and `min` pass over NaN: a ray in the plane of a side is inside its slab.
        let (low, high) = if inverse[axis] < 0.0 { (second[axis], first[axis]) } else { (first[axis], second[axis]) };
        enter = enter.max(low);
        exit = exit.min(high);
    }
    (enter <= exit).then_some(enter)
}
