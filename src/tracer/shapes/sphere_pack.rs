//! Round spheres in the world, four side by side.
//!
//! ```text
//!     lane            0    1    2    3
//!     centre x     [ x0   x1   x2    - ]     The same operation is done on all four lanes, which the compiler
//!     centre y     [ y0   y1   y2    - ]     turns into vector instructions. An empty lane has the squared
//!     centre z     [ z0   z1   z2    - ]     radius -1: no ray comes that close.
//!     radius^2     [ r0   r1   r2   -1 ]
//! ```

use super::sphere;
use crate::math::{DVec3, Ray, Side};

/// Spheres tested at once.
pub(super) const LANES: usize = 4;

/// Up to four spheres.
#[derive(Debug, Clone)]
pub struct SpherePack {
    pub(super) centre: [[f64; LANES]; 3],
    /// -1 for an empty lane.
    pub(super) squared_radius: [f64; LANES],
    /// Their numbers in the scene.
    shapes: [u32; LANES],
}

/// What the line of a ray has to do with the four spheres, the origin taken relative to the centre.
struct Lines {
    /// `o . d` of the unit direction.
    half_b: [f64; LANES],
    /// The origin, by axis.
    origin: [[f64; LANES]; 3],
    squared_radius: [f64; LANES],
    /// `r^2 - |o - (o . d) d|^2`: half the chord, squared; negative where the line passes by.
    half_chord: [f64; LANES],
}

impl SpherePack {
    /// Most spheres of a pack.
    pub const MOST: usize = LANES;

    /// Packs up to [`MOST`](Self::MOST) spheres, given by number, centre and radius.
    pub fn new(spheres: &[(u32, DVec3, f64)]) -> Self {
        let mut pack = Self { centre: [[0.0; LANES]; 3], squared_radius: [-1.0; LANES], shapes: [u32::MAX; LANES] };
        for (lane, &(shape, centre, radius)) in spheres.iter().enumerate() {
            for axis in 0..3 {
                pack.centre[axis][lane] = centre[axis];
            }
            pack.squared_radius[lane] = radius * radius;
            pack.shapes[lane] = shape;
        }
        pack
    }

    /// Calls `found` with number and distance of the spheres that a ray of unit direction hits, until it returns
    /// true; returns whether it did. The nearest hit of a sphere counts; a ray that leaves a sphere meets it
    /// only at the other end of the chord.
    #[inline(always)]
    pub fn hits(&self, ray: &Ray, mut found: impl FnMut(u32, f64) -> bool) -> bool {
        let lines = self.lines(ray);
        let leaving = ray.departure.map_or(u32::MAX, |departure| departure.surface.shape);
        let inside = ray.departure.is_some_and(|departure| departure.side == Side::Back);
        if !inside && lines.all_miss() {
            return false;
        }
        for lane in 0..LANES {
            let shape = self.shapes[lane];
            if shape == leaving {
                // The root at the origin is skipped: outwards there is no other, inwards it is the chord's end.
                if inside && found(shape, (-2.0 * lines.half_b[lane]).max(0.0)) {
                    return true;
                }
            } else if lines.half_chord[lane] >= 0.0 {
                let distance = lines.nearest(lane, ray);
                if distance > 0.0 && found(shape, distance) {
                    return true;
                }
            }
        }
        false
    }

    #[inline(always)]
    fn lines(&self, ray: &Ray) -> Lines {
        let (origin, [dx, dy, dz]) = (ray.origin, ray.direction.to_array());
        let mut lines = Lines {
            half_b: [0.0; LANES],
            origin: [[0.0; LANES]; 3],
            squared_radius: self.squared_radius,
            half_chord: [0.0; LANES],
        };
        for lane in 0..LANES {
            let squared_radius = self.squared_radius[lane];
            let x = origin.x - self.centre[0][lane];
            let y = origin.y - self.centre[1][lane];
            let z = origin.z - self.centre[2][lane];
            let half_b = x * dx + y * dy + z * dz;
            // The distance between centre and line does not cancel for far origins
            // (Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019).
            let (px, py, pz) = (x - half_b * dx, y - half_b * dy, z - half_b * dz);
            lines.half_b[lane] = half_b;
            lines.origin[0][lane] = x;
            lines.origin[1][lane] = y;
            lines.origin[2][lane] = z;
            lines.half_chord[lane] = squared_radius - (px * px + py * py + pz * pz);
        }
        lines
    }
}

impl Lines {
    /// True if the line misses all four spheres, as most do: one branch instead of several for each.
    #[inline(always)]
    fn all_miss(&self) -> bool {
        !self.half_chord.iter().fold(false, |met, &half_chord| met | (half_chord >= 0.0))
    }

    /// `|o|^2 - r^2`: positive outside.
    #[inline(always)]
    fn outside(&self, lane: usize) -> f64 {
        let [x, y, z] = self.origin.map(|component| component[lane]);
        x * x + y * y + z * z - self.squared_radius[lane]
    }

    /// The nearest root ahead of the ray whose line meets the sphere; 0 or less if there is none, or only an exit no farther
    /// than the error of the origin: see [`sphere::intersect`].
    #[inline(always)]
    fn nearest(&self, lane: usize, ray: &Ray) -> f64 {
        let (half_b, outside) = (self.half_b[lane], self.outside(lane));
        // Outside, the ray moves away.
        if half_b > 0.0 && outside > 0.0 {
            return 0.0;
        }
        // The root without cancellation first, the other from the product of the roots.
        let q = -half_b - self.half_chord[lane].sqrt().copysign(half_b);
        let other = outside / q;
        let (near, far) = if other < q { (other, q) } else { (q, other) };
        if near > 0.0 {
            near
        } else if sphere::is_ahead(near, far, ray.origin_error()) {
            far
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::math::{Departure, SurfaceId, Transform};
    use crate::shapes::{Geometry, MaterialChoice, Primitive};

    /// Five spheres, so that one stands alone in a second pack.
    fn spheres() -> Vec<(u32, DVec3, f64)> {
        let centre = |x: f64, y: f64| DVec3::new(x, y, 0.5);
        vec![
            (2, centre(0.0, 0.0), 1.0),
            (3, centre(2.5, 0.0), 1.2),
            (5, centre(0.0, 2.0), 0.3),
            (7, centre(0.4, 0.1), 3.0),
            (8, centre(-2.0, -1.0), 0.7),
        ]
    }

    /// The same sphere as a single shape, tested in object space.
    fn alone(&(_, centre, radius): &(u32, DVec3, f64)) -> Primitive {
        let transform = Transform::from_parts(centre, DVec3::ZERO, DVec3::splat(radius)).unwrap();
        Primitive::new(Geometry::Sphere, transform, MaterialChoice::Whole(0), true)
    }

    fn distances(ray: &Ray) -> Vec<(u32, f64)> {
        let mut found = Vec::new();
        for pack in spheres().chunks(SpherePack::MOST).map(SpherePack::new) {
            pack.hits(ray, |shape, distance| {
                found.push((shape, distance));
                false
            });
        }
        found
    }

    proptest! {
        #[test]
        fn side_by_side_is_as_one_by_one(
            origin in prop::array::uniform3(-5.0..5.0_f64),
            target in prop::array::uniform3(-2.0..2.0_f64),
            leaving in 0..10_u32,
            back in any::<bool>(),
        ) {
            let (mut origin, target) = (DVec3::from(origin), DVec3::from(target));
            let mut departure = None;
            if let Some(&(shape, centre, radius)) = spheres().iter().find(|sphere| sphere.0 == leaving) {
                origin = centre + (origin - centre).normalize() * radius;
                let side = if back { Side::Back } else { Side::Front };
                departure = Some(Departure { surface: SurfaceId { shape, part: 0 }, side });
            }
            let ray = Ray { origin, direction: (target - origin).normalize(), departure };
            let found = distances(&ray);
            let hit = |sphere: &(u32, DVec3, f64)| {
                let hit = alone(sphere).intersect(&ray, sphere.0, f64::INFINITY)?;
                Some((sphere.0, hit.t))
            };
            let expected: Vec<_> = spheres().iter().filter_map(hit).collect();
            prop_assert_eq!(found.len(), expected.len());
            for (one, other) in found.iter().zip(&expected) {
                prop_assert_eq!(one.0, other.0);
                prop_assert!((one.1 - other.1).abs() < 1e-9 * (1.0 + other.1), "{:?} {:?}", one, other);
            }
        }
    }

    #[test]
    fn enough_ends_the_search() {
        let ray = Ray::new(DVec3::new(-9.0, 0.0, 0.5), DVec3::X);
        let mut count = 0;
        let stopped = SpherePack::new(&spheres()[..LANES]).hits(&ray, |_, _| {
            count += 1;
            true
        });
        assert_eq!((stopped, count), (true, 1));
    }
}
