//! Integrators: from a camera ray to the radiance of a pixel.

mod cost;
mod direct;
mod media;
mod normals;
mod phong;
mod whitted;

pub use cost::RayCounts;
pub use media::media_around;

use crate::materials::MediumStack;
use crate::math::{Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{IntegratorKind, Plan, Scene};

/// Computes the radiance along a camera ray.
///
/// `media` are the glasses around the ray's origin ([`media_around`]). The counts of rays grow by what was traced; the
/// sampler delivers random decisions.
#[inline]
pub fn radiance(
    scene: &Scene,
    plan: &Plan,
    ray: &Ray,
    media: &MediumStack,
    sampler: &mut PixelSampler,
    counts: &mut RayCounts,
) -> Vec3 {
    counts.camera += 1;
    match plan.integrator {
        IntegratorKind::Normals => normals::radiance(scene, ray),
        IntegratorKind::Phong => phong::radiance(scene, plan, ray, counts),
        IntegratorKind::Whitted => whitted::radiance(scene, plan, ray, media, sampler, counts),
    }
}
