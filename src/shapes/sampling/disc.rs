//! Discs, and ellipses that uneven scales make of them: points uniform in the area.

use std::f64::consts::{FRAC_PI_4, PI};

use super::ShapeSample;
use crate::math::functions::{cos, sin};
use crate::math::{DVec3, Transform};

/// Draws points of a disc.
#[derive(Debug)]
pub(super) struct DiscSampler {
    centre: DVec3,
    /// From the centre to the border, along the axes of the shape's own space.
    radii: [DVec3; 2],
    normal: DVec3,
    area: f64,
}

impl DiscSampler {
    pub(super) fn new(transform: &Transform) -> Self {
        let matrix = &transform.to_world.matrix3;
        let radii = [matrix.x_axis, matrix.y_axis];
        Self {
            centre: transform.to_world.translation,
            radii,
            normal: transform.normal_to_world(DVec3::Z),
            area: PI * radii[0].cross(radii[1]).length(),
        }
    }

    pub(super) fn area(&self) -> f64 {
        self.area
    }

    #[inline]
    pub(super) fn sample_towards(&self, point: DVec3, place: [f64; 2]) -> Option<ShapeSample> {
        let [x, y] = onto_disc(place);
        let position = self.centre + self.radii[0] * x + self.radii[1] * y;
        ShapeSample::by_area(point, position, self.normal, self.area, 0)
    }
}

/// Squares around the middle become circles: keeps areas and strata (Shirley and Chiu, A Low Distortion Map Between
/// Disk and Square, 1997).
#[inline]
fn onto_disc(place: [f64; 2]) -> [f64; 2] {
    let [x, y] = place.map(|coordinate| 2.0 * coordinate - 1.0);
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    let (radius, angle) =
        if x.abs() > y.abs() { (x, FRAC_PI_4 * (y / x)) } else { (y, 2.0 * FRAC_PI_4 - FRAC_PI_4 * (x / y)) };
    [radius * cos(angle), radius * sin(angle)]
}
