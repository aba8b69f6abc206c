//! A queue of rays of the same depth, and their results step by step.

use crate::integrators::common::view::{Reflection, View};
use crate::materials::MediumStack;
use crate::materials::fresnel::Boundary;
use crate::math::{DVec3, Ray, SurfaceId, Vec3};
use crate::shapes::{Hit, Surface};

/// A ray with its throughput.
pub struct Path {
    pub ray: Ray,
    /// Share of the pixel that this ray's radiance counts for, by channel.
    pub weight: Vec3,
    /// Number of the camera ray that it comes from.
    pub camera_ray: usize,
    /// The glasses the ray is inside of.
    pub media: MediumStack,
}

/// A ray that met something.
pub struct Meeting {
    /// Its number in the queue.
    pub path: usize,
    pub distance: f64,
    pub surface: Surface,
}

/// Where a ray met a surface: what is needed to send other rays from there.
#[derive(Clone, Copy)]
pub struct Origin {
    /// Number of the ray in the queue.
    pub path: usize,
    pub position: DVec3,
    pub id: SurfaceId,
    /// Number of the material in the scene.
    pub material: u32,
    pub view: View,
}

/// A surface that reflects the light of sources.
pub struct Lit {
    pub origin: Origin,
    pub reflection: Reflection,
}

/// A mirror that a ray met.
pub struct Mirror {
    pub origin: Origin,
    pub colour: Vec3,
}

/// A glass that a ray met.
pub struct Glass {
    pub origin: Origin,
    /// Index of refraction on the ray's side over that beyond.
    pub relative_index: f64,
    pub boundary: Boundary,
}

/// Where a ray was sent on.
pub struct Sender {
    /// Number of the ray in the queue above.
    pub path: usize,
    /// Factor on the radiance along the ray.
    pub factor: Vec3,
}

/// Rays of the same depth. The room is used again and again.
#[derive(Default)]
pub struct Queue {
    pub paths: Vec<Path>,
    /// For each ray, if they were sent on: by what.
    pub senders: Vec<Sender>,
    pub hits: Vec<Option<Hit>>,
    pub meetings: Vec<Meeting>,
    pub found: Found,
}

/// What rays found.
#[derive(Default)]
pub struct Found {
    /// The radiance along each ray, as far as it is known.
    pub radiances: Vec<Vec3>,
    /// Transmittance along each ray; empty if no glass attenuates light.
    pub transmittances: Vec<Vec3>,
    /// Surfaces with direct light.
    pub lit: Vec<Lit>,
    /// Surfaces that send rays on.
    pub mirrors: Vec<Mirror>,
    pub glasses: Vec<Glass>,
}

impl Found {
    /// Makes room for a number of rays.
    pub fn clear(&mut self, rays: usize) {
        self.radiances.clear();
        self.radiances.resize(rays, Vec3::ZERO);
        self.transmittances.clear();
        self.lit.clear();
        self.mirrors.clear();
        self.glasses.clear();
    }

    /// Transmittance along a ray.
    #[inline]
    pub fn transmittance(&self, ray: usize) -> Vec3 {
        self.transmittances.get(ray).copied().unwrap_or(Vec3::ONE)
    }
}

impl Queue {
    /// Removes all rays.
    pub fn clear(&mut self) {
        self.paths.clear();
        self.senders.clear();
    }

    /// Adds a ray.
    #[inline]
    pub fn push(&mut self, ray: Ray, weight: Vec3, camera_ray: usize, media: MediumStack) {
        self.paths.push(Path { ray, weight, camera_ray, media });
    }
}
