//! Where the rays of a picture start.

use crate::camera::Camera;
use crate::envmap::{Face, Lookup};
use crate::math::DVec3;

/// The rays of a picture.
#[derive(Debug, Clone)]
pub(super) enum RaySource<'a> {
    Camera(&'a Camera),
    /// The image that a lookup reads for a face, seen from a point: each texel looks along its own direction.
    Face {
        lookup: &'a Lookup,
        face: Face,
        size: usize,
        position: DVec3,
    },
}

impl RaySource<'_> {
    /// Width and height of the picture in pixels.
    pub fn size(&self) -> [usize; 2] {
        match self {
            RaySource::Camera(camera) => camera.size(),
            RaySource::Face { size, .. } => [*size, *size],
        }
    }

    /// The point that all rays come from, or come from nearly.
    pub fn position(&self) -> DVec3 {
        match self {
            RaySource::Camera(camera) => camera.position(),
            RaySource::Face { position, .. } => *position,
        }
    }

    /// The point that all rays start at; `None` for a lens.
    pub fn origin(&self) -> Option<DVec3> {
        match self {
            RaySource::Camera(camera) if camera.lens().is_some() => None,
            _ => Some(self.position()),
        }
    }

    /// Origin and direction, of any length, of the ray through a place of the picture in pixels from the top left corner, and
    /// a place of the lens, if there is one.
    #[inline]
    pub fn sight(&self, x: f64, y: f64, lens_place: [f64; 2]) -> (DVec3, DVec3) {
        match self {
            RaySource::Camera(camera) => camera.sight(x, y, lens_place),
            RaySource::Face { lookup, face, size, position } => {
                (*position, lookup.image_direction(*face, x / *size as f64, y / *size as f64))
            }
        }
    }
}
