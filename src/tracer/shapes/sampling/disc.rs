//! Discs, and ellipses that uneven scales make of them: points uniform in the area.

use std::f64::consts::PI;

use super::ShapeSample;
use crate::math::{DVec2, DVec3, Transform};
use crate::sampling::warp::concentric_disc;

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
        let DVec2 { x, y } = concentric_disc(place);
        let position = self.centre + self.radii[0] * x + self.radii[1] * y;
        ShapeSample::by_area(point, position, self.normal, self.area, 0)
    }
}
