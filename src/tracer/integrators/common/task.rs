//! A camera ray as a task for an integrator, and its cost.

use std::ops::AddAssign;

use crate::sampling::PixelSampler;
use crate::scene::{Plan, Scene};

/// What a ray of the camera is traced with.
pub struct Task<'a, O> {
    /// What is rendered.
    pub scene: &'a Scene,
    /// What of it needs to be computed.
    pub plan: &'a Plan,
    /// Delivers the random decisions.
    pub sampler: &'a mut PixelSampler,
    /// Grow by what is traced.
    pub counts: &'a mut RayCounts,
    /// Is told of every step.
    pub observer: &'a mut O,
}

/// Rays traced, by purpose, and what was cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct RayCounts {
    /// Rays from the camera.
    pub camera: u64,
    /// Rays sent on by reflection; of the path tracer, all rays sent on from a surface but the refracted.
    pub reflected: u64,
    /// Rays sent on through glass.
    pub refracted: u64,
    /// Rays to light sources.
    pub shadow: u64,
    /// Rays that hit nothing and took the environment.
    pub environment: u64,
    /// Rays that were not followed because the depth limit was reached: their light is missing.
    pub cut_by_depth: u64,
    /// Rays that were not followed by a random decision, whose light the survivors stand for.
    pub cut_by_weight: u64,
}

impl RayCounts {
    /// All rays that were traced.
    pub fn traced(&self) -> u64 {
        self.camera + self.reflected + self.refracted + self.shadow
    }
}

impl AddAssign for RayCounts {
    fn add_assign(&mut self, other: Self) {
        self.camera += other.camera;
        self.reflected += other.reflected;
        self.refracted += other.refracted;
        self.shadow += other.shadow;
        self.environment += other.environment;
        self.cut_by_depth += other.cut_by_depth;
        self.cut_by_weight += other.cut_by_weight;
    }
}
