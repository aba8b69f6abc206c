//! A stream of camera rays, traced side by side.

use super::queue::Queue;
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::shapes::ViewCones;

/// Rays that leave the camera together, buffers for their intermediate results, and their radiance.
pub struct RayStream {
    /// The spheres as seen from the point that all rays start at, if there is one and it may save work.
    pub(super) cones: Option<ViewCones>,
    pub(super) samplers: Vec<PixelSampler>,
    /// The rays of the camera, then by depth those that they send on.
    pub(super) queues: Vec<Queue>,
}

impl RayStream {
    /// Rays that are traced together, about: enough to fill the processor, few enough to stay in its nearest memory.
    pub const LENGTH: usize = 32;

    /// An empty stream whose rays are sent on at most `depth` times. `cones` are those from the point that all rays start at.
    pub fn new(depth: u32, cones: Option<ViewCones>) -> Self {
        Self { cones, samplers: Vec::new(), queues: (0..=depth).map(|_| Queue::default()).collect() }
    }

    /// Removes all rays.
    pub fn clear(&mut self) {
        self.samplers.clear();
        self.queues[0].clear();
    }

    /// Adds a ray of the camera along a direction of any length, with the glasses around its origin and the sampler that delivers its random decisions.
    #[inline]
    pub fn push(&mut self, origin: DVec3, towards: DVec3, media: &MediumStack, sampler: PixelSampler) {
        // Cones from elsewhere say nothing.
        self.cones.take_if(|cones| cones.point() != origin);
        let index = self.samplers.len();
        self.samplers.push(sampler);
        self.queues[0].push(Ray::new(origin, towards), Vec3::ONE, index, *media);
    }

    /// Normalises the directions of all rays, in a separate loop, where the processor takes several square roots at
    /// once.
    pub(super) fn normalize(&mut self) {
        self.queues[0].paths.iter_mut().for_each(|path| path.ray.direction = path.ray.direction.normalize());
    }

    /// What they brought back, once they are traced.
    pub fn radiances(&self) -> &[Vec3] {
        &self.queues[0].found.radiances
    }
}
