//! A point drawn on a shape.

use crate::math::DVec3;

/// A point on a shape as seen from another point, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeSample {
    /// The point itself.
    pub position: DVec3,
    /// Unit normal of the true surface, to its front: it points away from the viewer where the back is seen.
    pub normal: DVec3,
    /// Unit direction to the position.
    pub to_shape: DVec3,
    /// Distance to the position.
    pub distance: f64,
    /// Density by solid angle.
    pub density: f64,
    /// Part of the shape, as in the number of a surface: triangle of a mesh, face of a box, otherwise 0.
    pub id_part: u32,
}

impl ShapeSample {
    /// A point drawn uniformly from the area; `None` if it is seen edge-on or from no distance.
    #[inline]
    pub(super) fn by_area(point: DVec3, position: DVec3, normal: DVec3, area: f64, part: u32) -> Option<Self> {
        let offset = position - point;
        Self::with_density(offset, position, normal, density_of_area(area, offset, normal), part)
    }

    /// A point drawn with a known density; `None` if that or the distance is none.
    #[inline]
    pub(super) fn with_density(offset: DVec3, position: DVec3, normal: DVec3, density: f64, part: u32) -> Option<Self> {
        let distance = offset.length();
        let usable = distance > 0.0 && density > 0.0;
        usable.then(|| Self { position, normal, to_shape: offset / distance, distance, density, id_part: part })
    }
}

/// The density by solid angle of points drawn uniformly from an area, at `offset` from the viewer: `r^2 / (cos A)`.
/// 0 where it has no finite value, that is edge-on.
#[inline]
pub(super) fn density_of_area(area: f64, offset: DVec3, normal: DVec3) -> f64 {
    let square = offset.length_squared();
    let density = square * square.sqrt() / (normal.dot(offset).abs() * area);
    if density.is_finite() { density } else { 0.0 }
}
