//! Integrators: from a camera ray to the radiance of a pixel.

mod cost;
mod direct;
mod media;
mod normals;
mod observer;
mod path;
mod phong;
mod whitted;

pub use cost::RayCounts;
pub use observer::{Blind, Event, LightOutcome, Observer, RayKind, Recorder};

use crate::error::Result;
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{IntegratorKind, Plan, Scene};
use direct::View;
use path::PathTables;

/// A scene made ready for rendering by its plan.
pub struct Integrator<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    /// What the path tracer looks up; `None` for the others.
    path: Option<PathTables>,
}

/// What every integrator works on and with.
struct Task<'a, O> {
    scene: &'a Scene,
    plan: &'a Plan,
    sampler: &'a mut PixelSampler,
    counts: &'a mut RayCounts,
    observer: &'a mut O,
}

/// What a camera ray meets first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstHit {
    /// Unit shading normal in the world, on the viewer's side.
    pub normal: DVec3,
    /// Share of the light that is reflected or transmitted.
    pub albedo: Vec3,
    pub distance: f64,
}

impl<'a> Integrator<'a> {
    /// Builds the tables that the plan asks for. An error tells that a picture of the environment cannot be decoded.
    pub fn new(scene: &'a Scene, plan: &'a Plan) -> Result<Self> {
        let path = match plan.integrator {
            IntegratorKind::Path => Some(PathTables::new(scene, plan)?),
            _ => None,
        };
        Ok(Self { scene, plan, path })
    }

    /// The radiance along a camera ray.
    ///
    /// `media` are the glasses around the ray's origin. The counts of rays grow by what was traced; the sampler delivers
    /// random decisions.
    #[inline]
    pub fn radiance(&self, ray: &Ray, media: &MediumStack, sampler: &mut PixelSampler, counts: &mut RayCounts) -> Vec3 {
        self.observed_radiance(ray, media, sampler, counts, &mut Blind)
    }

    /// The same, watched.
    #[inline]
    pub fn observed_radiance<O: Observer>(
        &self,
        ray: &Ray,
        media: &MediumStack,
        sampler: &mut PixelSampler,
        counts: &mut RayCounts,
        observer: &mut O,
    ) -> Vec3 {
        let Self { scene, plan, ref path } = *self;
        counts.camera += 1;
        observer.note(|| Event::Ray { kind: RayKind::Camera, ray: *ray, factor: Vec3::ONE });
        let task = Task { scene, plan, sampler, counts, observer };
        match plan.integrator {
            IntegratorKind::Normals => normals::radiance(task, ray),
            IntegratorKind::Phong => phong::radiance(task, ray),
            IntegratorKind::Whitted => whitted::radiance(task, ray, media),
            IntegratorKind::Path => path.as_ref().map_or(Vec3::ZERO, |tables| path::radiance(task, tables, ray, media)),
        }
    }

    /// What was left out beyond the plan, after a look at the light itself; one sentence an item.
    pub fn left_out(&self) -> Vec<String> {
        self.path.as_ref().map_or(Vec::new(), |tables| tables.left_out(self.plan))
    }

    /// The glasses that enclose a point from which rays start, outermost first: a camera may stand in water.
    pub fn media_around(&self, point: DVec3) -> MediumStack {
        media::media_around(self.scene, self.plan, point)
    }

    /// What a camera ray meets first; `None` if nothing.
    pub fn first_hit(&self, ray: &Ray) -> Option<FirstHit> {
        let hit = self.scene.shapes.intersect(ray)?;
        let surface = self.scene.shapes.surface(ray, &hit);
        let albedo = self.scene.materials[surface.material as usize].albedo(surface.texture_coordinates);
        Some(FirstHit { normal: View::new(&surface, ray.direction).shading_normal, albedo, distance: hit.t })
    }
}
