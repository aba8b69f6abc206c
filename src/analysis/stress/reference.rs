//! The exact hit of a ray and a shape, in double-double arithmetic.

use super::wide::Wide;
use super::wide_vector::WideVector;
use crate::math::{DVec3, Ray, Transform};

/// A ray in a shape's own space, carried there without rounding that counts.
#[derive(Debug, Clone, Copy)]
pub struct WideRay {
    pub origin: WideVector,
    pub direction: WideVector,
}

/// The two roots of a line and a convex shape: `middle -+ half`, in units of the direction's length.
#[derive(Debug, Clone, Copy)]
pub struct Chord {
    pub middle: Wide,
    /// Square of half the length; negative where the line misses, by how much.
    pub half_squared: Wide,
}

impl WideRay {
    /// The world ray in the space of a shape: the inverse of the map to the world by Cramer's rule.
    pub fn in_space_of(transform: &Transform, ray: &Ray) -> Self {
        let matrix = &transform.to_world.matrix3;
        let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(WideVector::from);
        let rows = [y.cross(z), z.cross(x), x.cross(y)];
        let determinant = x.dot(rows[0]);
        let carry = |vector: WideVector| WideVector(rows.map(|row| row.dot(vector) / determinant));
        let offset = WideVector::from(ray.origin) - transform.to_world.translation.into();
        Self { origin: carry(offset), direction: carry(ray.direction.into()) }
    }

    /// The chord in a sphere around the origin.
    pub fn in_sphere(&self, radius: f64) -> Chord {
        let Self { origin, direction } = *self;
        let (square, half_b) = (direction.dot(direction), origin.dot(direction));
        let closest = origin * square - direction * half_b;
        let difference = (square * radius.into()).square() - closest.dot(closest);
        Chord { middle: -half_b / square, half_squared: difference / (square * square * square) }
    }

    /// The chord in the cube `[-1, 1]^3`.
    pub fn in_cube(&self) -> Chord {
        let (mut enter, mut exit) = (Wide::from(f64::NEG_INFINITY), Wide::from(f64::INFINITY));
        for axis in 0..3 {
            let (position, slope) = (self.origin.0[axis], self.direction.0[axis]);
            if slope == Wide::ZERO {
                continue;
            }
            let (first, second) = ((-Wide::ONE - position) / slope, (Wide::ONE - position) / slope);
            let (near, far) = if first < second { (first, second) } else { (second, first) };
            enter = if near > enter { near } else { enter };
            exit = if far < exit { far } else { exit };
        }
        let half = (exit - enter) * 0.5.into();
        let sign = if half < Wide::ZERO { -Wide::ONE } else { Wide::ONE };
        Chord { middle: (enter + exit) * 0.5.into(), half_squared: half.square() * sign }
    }

    /// The ray parameter where the plane z = 0 is met.
    pub fn at_plane(&self) -> Wide {
        -self.origin.0[2] / self.direction.0[2]
    }
}

impl Chord {
    /// The first root ahead of the origin; `None` if there is none.
    pub fn nearest(&self) -> Option<Wide> {
        if self.half_squared < Wide::ZERO {
            return None;
        }
        let half = self.half_squared.sqrt();
        let ahead = |root: &Wide| *root > Wide::ZERO;
        [self.middle - half, self.middle + half].into_iter().find(ahead)
    }

    /// Half the length of the chord; of a line that misses the length by which it does.
    pub fn half(&self) -> f64 {
        self.half_squared.abs().sqrt().value()
    }
}

/// The true point of a world ray at a parameter.
pub fn point_at(ray: &Ray, parameter: Wide) -> WideVector {
    WideVector::from(ray.origin) + WideVector::from(ray.direction) * parameter
}

/// How far a point is from where it should be.
pub fn distance(point: DVec3, truth: WideVector) -> f64 {
    (WideVector::from(point) - truth).length().value()
}

/// One unit in the last place of the `f32` numbers of a size.
pub fn ulp_f32(size: f64) -> f64 {
    let size = (size.abs() as f32).clamp(f32::MIN_POSITIVE, f32::MAX / 2.0);
    f64::from(size.next_up()) - f64::from(size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_roots_of_a_placed_sphere() {
        let transform =
            Transform::from_parts(DVec3::new(5.0, 0.0, 0.0), DVec3::ZERO, DVec3::new(2.0, 1.0, 1.0)).unwrap();
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let chord = WideRay::in_space_of(&transform, &ray).in_sphere(1.0);
        assert_eq!((chord.nearest().unwrap().value(), chord.half()), (3.0, 2.0));
        let chord = WideRay::in_space_of(&transform, &ray).in_cube();
        assert_eq!((chord.nearest().unwrap().value(), chord.half()), (3.0, 2.0));
    }

    #[test]
    fn ulps_are_those_of_single_precision() {
        assert_eq!(ulp_f32(1.0), 1.0 / f64::from(1 << 23));
        assert_eq!(ulp_f32(1e7), 1.0);
    }
}
