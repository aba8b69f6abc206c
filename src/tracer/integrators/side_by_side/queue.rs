//! Rays of the same depth, and what is found of them step by step.

use super::super::direct::Lit;
use super::branch::{Glass, Mirror};
use crate::materials::MediumStack;
use crate::math::{Ray, Vec3};
use crate::shapes::{Hit, Surface};

/// A ray on its way, with what it carries.
pub struct Path {
    pub ray: Ray,
    /// Share of the pixel that this ray's radiance counts for, by channel.
    pub weight: Vec3,
    /// Number of the camera ray that it comes from.
    pub lane: usize,
    /// The glasses the ray is inside of.
    pub media: MediumStack,
}

/// A ray that met something.
pub struct Meeting {
    /// Its number in the level.
    pub path: usize,
    pub distance: f64,
    pub surface: Surface,
}

/// Where a ray was sent on.
pub struct Sender {
    /// Number of the ray in the level above.
    pub path: usize,
    /// Factor on what is brought back.
    pub factor: Vec3,
}

/// Rays of the same depth. The room is used again and again.
#[derive(Default)]
pub struct Level {
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
    /// What each ray brings back, as far as it is known.
    pub radiances: Vec<Vec3>,
    /// Share of the light that is left after the way of each ray; empty if no glass weakens light.
    pub transmittances: Vec<Vec3>,
    /// Surfaces that lights shine on.
    pub lit: Vec<Lit>,
    /// Surfaces that send rays on.
    pub mirrors: Vec<Mirror>,
    pub glasses: Vec<Glass>,
}

impl Found {
    /// Makes room for a count of rays.
    pub fn clear(&mut self, rays: usize) {
        self.radiances.clear();
        self.radiances.resize(rays, Vec3::ZERO);
        self.transmittances.clear();
        self.lit.clear();
        self.mirrors.clear();
        self.glasses.clear();
    }

    /// Share of the light that is left after the way of a ray.
    #[inline]
    pub fn transmittance(&self, ray: usize) -> Vec3 {
        self.transmittances.get(ray).copied().unwrap_or(Vec3::ONE)
    }
}

impl Level {
    /// Removes all rays.
    pub fn clear(&mut self) {
        self.paths.clear();
        self.senders.clear();
    }

    /// Adds a ray.
    #[inline]
    pub fn push(&mut self, ray: Ray, weight: Vec3, lane: usize, media: MediumStack) {
        self.paths.push(Path { ray, weight, lane, media });
    }
}
