//! Integrators: from a camera ray to the radiance of a pixel.

mod bundle;
mod cost;
mod direct;
mod media;
mod normals;
mod observer;
mod path;
mod view;
mod whitted;

pub use bundle::Bundle;
pub use cost::RayCounts;
pub use observer::{Blind, Event, LightOutcome, Observer, RayKind, Recorder};

use crate::error::Result;
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{IntegratorKind, Plan, Scene};
use crate::shapes::Outlook;
use media::Media;
use path::PathTables;
use view::View;

/// A scene made ready for rendering by its plan.
pub struct Integrator<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    /// What the path tracer looks up; `None` for the others.
    path: Option<PathTables>,
    /// The view from each light source, where it may save the others work.
    outlooks: Vec<Option<Outlook>>,
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
        Ok(Self { scene, plan, path, outlooks: direct::outlooks(scene, plan) })
    }

    /// An empty bundle for rays of the camera, which all start at `origin`, if there is one: that may save work.
    pub fn bundle(&self, origin: Option<DVec3>) -> Bundle {
        let Plan { integrator, reflection, refraction, .. } = *self.plan;
        let sends_on = integrator == IntegratorKind::Whitted && (reflection || refraction);
        let depth = if sends_on { self.scene.integrator.depth } else { 0 };
        Bundle::new(depth, origin.and_then(|origin| self.scene.shapes.outlook(origin)))
    }

    /// Finds the radiance along the rays of a bundle. The counts of rays grow by what was traced.
    #[inline]
    pub fn trace(&self, bundle: &mut Bundle, counts: &mut RayCounts) {
        self.trace_observed(bundle, counts, &mut Blind);
    }

    /// The same for a bundle of one ray, watched.
    pub fn trace_observed<O: Observer>(&self, bundle: &mut Bundle, counts: &mut RayCounts, observer: &mut O) {
        let Self { scene, plan, ref path, .. } = *self;
        bundle.normalize();
        counts.camera += bundle.rays().len() as u64;
        for ray in bundle.rays() {
            observer.note(|| Event::Ray { kind: RayKind::Camera, ray: *ray, factor: Vec3::ONE });
        }
        match plan.integrator {
            IntegratorKind::Normals => bundle.each(|ray, _, _| normals::radiance(scene, ray, observer)),
            IntegratorKind::Path => bundle.each(|ray, media, sampler| {
                let task = path::Task { scene, plan, sampler, counts, observer };
                path.as_ref().map_or(Vec3::ZERO, |tables| path::radiance(task, tables, ray, media))
            }),
            // Phong's follows nothing: the plan says so.
            IntegratorKind::Phong | IntegratorKind::Whitted => {
                let Bundle { outlook, samplers, levels } = bundle;
                let (outlooks, media_of) = (&self.outlooks, Media { scene, absorption: plan.absorption });
                let mut tracer = whitted::Tracer { scene, plan, outlooks, media_of, samplers, counts, observer };
                tracer.trace(0, outlook.as_ref(), levels);
            }
        }
    }

    /// The radiance along one ray from free space, whose direction may have any length; `media` are the glasses around its
    /// origin.
    pub fn radiance(&self, ray: &Ray, media: &MediumStack, sampler: PixelSampler, counts: &mut RayCounts) -> Vec3 {
        let mut bundle = self.bundle(Some(ray.origin));
        bundle.push(ray.origin, ray.direction, media, sampler);
        self.trace(&mut bundle, counts);
        bundle.radiances()[0]
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
