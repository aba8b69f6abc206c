//! Flat shapes in the plane z = 0: plane, disc, rectangle.

use crate::math::{DAffine3, DVec2, DVec3};

/// The outline of a flat shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outline {
    /// The whole plane.
    Plane,
    /// Within radius 1 of the origin.
    Disc,
    /// `[-1, 1] x [-1, 1]`.
    Rectangle,
}

impl Outline {
    /// Distance to the hit in `(0, limit)` of a world ray, `to_object` carrying the world to the plane's space.
    ///
    /// The height above the plane decides first; only a hit of the plane needs the other two coordinates.
    #[inline]
    pub(super) fn intersect(self, to_object: &DAffine3, origin: DVec3, direction: DVec3, limit: f64) -> Option<f64> {
        let row = |index: usize| {
            let matrix = &to_object.matrix3;
            DVec3::new(matrix.x_axis[index], matrix.y_axis[index], matrix.z_axis[index])
        };
        let height_row = row(2);
        let height = height_row.dot(origin) + to_object.translation.z;
        let distance = -height / height_row.dot(direction);
        // A ray in the plane divides by zero: infinity or NaN fails here.
        if !(distance > 0.0 && distance < limit) {
            return None;
        }
        if self == Outline::Plane {
            return Some(distance);
        }
        let point = origin + direction * distance;
        let x = row(0).dot(point) + to_object.translation.x;
        let y = row(1).dot(point) + to_object.translation.y;
        self.contains(x, y).then_some(distance)
    }

    /// True if the place in the plane belongs to the shape.
    fn contains(self, x: f64, y: f64) -> bool {
        match self {
            Outline::Plane => true,
            Outline::Disc => x * x + y * y <= 1.0,
            Outline::Rectangle => x.abs() <= 1.0 && y.abs() <= 1.0,
        }
    }

    /// Texture coordinates: the plane repeats every unit, disc and rectangle fit the picture once, v = 0 at the bottom.
    pub(super) fn texture_coordinates(self, point: DVec3) -> DVec2 {
        let place = DVec2::new(point.x, point.y);
        match self {
            Outline::Plane => place,
            Outline::Disc | Outline::Rectangle => (place + 1.0) / 2.0,
        }
    }
}
