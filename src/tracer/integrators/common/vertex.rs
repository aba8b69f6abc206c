//! A surface where a path arrived, and the rays that leave it.

use super::media::{Media, medium_before, medium_beyond, pass};
use super::view::View;
use crate::materials::{Material, MediumStack, Scattering, ScatteringSample};
use crate::math::{DVec3, Departure, Frame, Ray};
use crate::shapes::Surface;

/// A surface where a path arrived.
pub struct Vertex<'s> {
    /// Where it is.
    pub surface: Surface,
    /// The side and the normals that the path sees.
    pub view: View,
    /// The shading normal and two axes at right angles to it.
    pub frame: Frame,
    /// Towards where the path came from, in the frame; above the surface.
    pub towards_viewer: DVec3,
    /// What the surface does with light.
    pub scattering: Scattering<'s>,
}

impl<'s> Vertex<'s> {
    /// The surface with its scattering function, met along a direction out of the glasses `before`; `None` if it scatters
    /// nothing towards the viewer.
    #[inline(always)]
    pub fn new(
        media: &Media,
        before: &MediumStack,
        direction: DVec3,
        material: &'s Material,
        surface: Surface,
        view: View,
    ) -> Option<Self> {
        let relative_index = if material.transmits() {
            let index_before = media.index_inside(medium_before(before, &surface, &view));
            index_before / media.index_inside(medium_beyond(before, &surface, &view))
        } else {
            1.0
        };
        let scattering = material.scattering(surface.texture, relative_index)?;
        let frame = Frame::around(view.shading_normal);
        let towards_viewer = frame.to_local(-direction);
        let visible = towards_viewer.z > 0.0;
        visible.then_some(Self { surface, view, frame, towards_viewer, scattering })
    }

    /// The ray of a chosen direction; `media`, the glasses before the surface, become those it starts in. `None` if light
    /// would leak through the surface.
    #[inline]
    pub fn departure(&self, sample: &ScatteringSample, media: &mut MediumStack) -> Option<Ray> {
        let direction = self.frame.to_world(sample.direction);
        let ray = match (self.ray_towards(direction), sample.specular) {
            (Some(ray), _) if self.passes(&ray) == sample.transmitted => ray,
            // An interpolated normal sent the ray to the wrong side of the true surface: it is projected onto the
            // surface.
            (_, true) => self.ray_along_surface(direction, sample.transmitted),
            _ => return None,
        };
        if sample.transmitted {
            pass(media, &self.surface, &self.view);
        }
        Some(ray)
    }

    /// The ray that leaves the surface in a direction; `None` if the shading normal has it on one side of the surface and
    /// the true normal on the other: light must not leak through.
    #[inline]
    pub fn ray_towards(&self, direction: DVec3) -> Option<Ray> {
        let height = direction.dot(self.view.normal);
        let shading_height = direction.dot(self.view.shading_normal);
        if height == 0.0 || (height > 0.0) != (shading_height > 0.0) {
            return None;
        }
        Some(self.departing(direction, height < 0.0))
    }

    /// The ray in the surface that lies nearest to a direction on the wrong side of it.
    fn ray_along_surface(&self, direction: DVec3, passes: bool) -> Ray {
        let flattened = direction - self.view.normal * direction.dot(self.view.normal);
        self.departing(flattened.normalize(), passes)
    }

    fn departing(&self, direction: DVec3, passes: bool) -> Ray {
        let side = if passes { self.view.side.opposite() } else { self.view.side };
        let departure = Some(Departure { surface: self.surface.id, side });
        Ray { origin: self.surface.position, direction, departure }
    }

    /// True if a ray of this vertex goes through the surface.
    fn passes(&self, ray: &Ray) -> bool {
        ray.departure.is_some_and(|departure| departure.side != self.view.side)
    }

    /// The glasses that a ray of this vertex starts in, by those before the surface.
    #[inline]
    pub fn media_of(&self, ray: &Ray, before: &MediumStack) -> MediumStack {
        let mut media = *before;
        if self.passes(ray) {
            pass(&mut media, &self.surface, &self.view);
        }
        media
    }
}
