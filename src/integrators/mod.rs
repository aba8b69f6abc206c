//! Integrators: from a camera ray to the radiance of a pixel.

mod cost;
mod direct;
mod normals;
mod phong;
mod whitted;

pub use cost::RayCounts;

use crate::math::{Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{IntegratorKind, Plan, Scene};

/// Computes the radiance along a camera ray.
///
/// The counts of rays grow by what was traced; the sampler delivers random decisions.
#[inline]
pub fn radiance(scene: &Scene, plan: &Plan, ray: &Ray, sampler: &mut PixelSampler, counts: &mut RayCounts) -> Vec3 {
    counts.camera += 1;
    match plan.integrator {
        IntegratorKind::Normals => normals::radiance(scene, ray),
        IntegratorKind::Phong => phong::radiance(scene, plan, ray, counts),
        IntegratorKind::Whitted => whitted::radiance(scene, plan, ray, sampler, counts),
    }
}
