//! A surface as a ray sees it.

use super::observer::Event;
use crate::math::{DVec3, Ray, Side, Vec3};
use crate::shapes::Surface;

/// A surface as the ray sees it: the normals turned to the ray's side.
#[derive(Debug, Clone, Copy)]
pub struct View {
    /// Side of the true surface that the ray comes from.
    pub side: Side,
    /// True normal on the ray's side.
    pub normal: DVec3,
    /// Shading normal on the ray's side.
    pub shading_normal: DVec3,
}

impl View {
    /// The surface seen along a direction.
    #[inline]
    pub fn new(surface: &Surface, direction: DVec3) -> Self {
        let side = Side::of(-direction, surface.normal);
        let turned = |normal: DVec3| if side == Side::Front { normal } else { -normal };
        let normal = turned(surface.normal);
        let shading_normal = turned(surface.shading_normal);
        // An interpolated normal may look away from the ray at a silhouette: there the true one serves.
        let visible = shading_normal.dot(direction) < 0.0;
        Self { side, normal, shading_normal: if visible { shading_normal } else { normal } }
    }

    /// The hit as an observer is told of it.
    pub fn hit(&self, surface: &Surface, ray: &Ray, distance: f64, transmittance: Vec3) -> Event {
        let cosine = -ray.direction.dot(self.shading_normal);
        let Self { side, shading_normal, .. } = *self;
        Event::Hit { surface: *surface, side, shading_normal, distance, cosine, transmittance }
    }
}
