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

/// The height of a world point above the plane: `row . point + offset`, in the plane's own unit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Height {
    row: DVec3,
    offset: f64,
}

impl Height {
    /// The last row of the map from the world to the plane's space.
    pub(super) fn of(to_object: &DAffine3) -> Self {
        let matrix = &to_object.matrix3;
        Self { row: DVec3::new(matrix.x_axis.z, matrix.y_axis.z, matrix.z_axis.z), offset: to_object.translation.z }
    }
}

impl Outline {
    /// Distance to the hit in `(0, limit)` of a world ray, `to_object` carrying the world to the plane's space and
    /// `height` being its last row.
    ///
    /// The height above the plane decides first; only a hit of the plane needs the other two coordinates.
    #[inline]
    pub(super) fn intersect(
        self,
        to_object: &DAffine3,
        height: &Height,
        origin: DVec3,
        direction: DVec3,
        limit: f64,
    ) -> Option<f64> {
        let above = height.row.dot(origin) + height.offset;
        let slope = height.row.dot(direction);
        // A ray that moves away from the plane, or along it, costs no division.
        if !(above > 0.0 && slope < 0.0 || above < 0.0 && slope > 0.0) {
            return None;
        }
        let distance = -above / slope;
        // Underflow may leave 0, and overflow infinity.
        if !(distance > 0.0 && distance < limit) {
            return None;
        }
        if self == Outline::Plane {
            return Some(distance);
        }
        let point = to_object.transform_point3(origin + direction * distance);
        self.contains(point.x, point.y).then_some(distance)
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
