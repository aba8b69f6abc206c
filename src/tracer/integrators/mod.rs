//! Integrators: from a camera ray to the radiance of a pixel.
//!
//! ```text
//!     textbook       what a lecture shows; renders wherever nothing faster applies, and is watched by `skycube trace`
//!     side_by_side   Whitted's and Phong's for a row of pixels at once: the same bits
//!     guided         path tracing with photons where glass and mirrors focus light: the same mean, less noise
//!     common         what they share
//! ```

mod common;
mod guided;
mod side_by_side;
mod textbook;

pub use common::first_hit::FirstHit;
pub use common::observer::{Blind, Event, LightOutcome, Observer, RayKind, Recorder};
pub use common::task::RayCounts;
pub(crate) use side_by_side::{RayStream, StreamTracer};

use crate::error::Result;
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{IntegratorKind, Plan, Scene, Wing};
use common::enclosing;
use common::lights::LightTables;
use common::task::Task;
use guided::GuidedTracer;
use textbook::whitted::Path;

/// A scene made ready for rendering by its plan.
pub struct Integrator<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    /// The light sources that the path tracer sends rays to; none for the others.
    lights: LightTables,
    wing: ReadyWing<'a>,
}

/// The code that renders, made ready.
enum ReadyWing<'a> {
    Textbook,
    SideBySide(StreamTracer<'a>),
    Guided(GuidedTracer<'a>),
}

impl<'a> Integrator<'a> {
    /// Builds the tables that the plan asks for. An error if a picture of the environment cannot be decoded.
    pub fn new(scene: &'a Scene, plan: &'a Plan) -> Result<Self> {
        let lights = LightTables::new(scene, plan)?;
        let wing = match plan.wing {
            Wing::Textbook => None,
            Wing::SideBySide => Some(ReadyWing::SideBySide(StreamTracer::new(scene, plan))),
            Wing::Guided => GuidedTracer::new(scene, plan, &lights).map(ReadyWing::Guided),
        };
        Ok(Self { scene, plan, lights, wing: wing.unwrap_or(ReadyWing::Textbook) })
    }

    /// Which code renders: the plan's choice, or the textbook where the light needs no guide.
    pub fn wing(&self) -> Wing {
        match self.wing {
            ReadyWing::Textbook => Wing::Textbook,
            ReadyWing::SideBySide(_) => Wing::SideBySide,
            ReadyWing::Guided(_) => Wing::Guided,
        }
    }

    /// The radiance along a camera ray of unit direction that starts inside of the glasses `media`. The counts of rays grow by
    /// what is traced.
    pub fn radiance(&self, ray: &Ray, media: &MediumStack, sampler: &mut PixelSampler, counts: &mut RayCounts) -> Vec3 {
        let ReadyWing::Guided(guided) = &self.wing else {
            return self.watch(ray, media, sampler, counts, &mut Blind);
        };
        counts.camera += 1;
        guided.radiance(&self.lights, ray, media, sampler, counts)
    }

    /// The same by the textbook's code, watched.
    pub fn watch<O: Observer>(
        &self,
        ray: &Ray,
        media: &MediumStack,
        sampler: &mut PixelSampler,
        counts: &mut RayCounts,
        observer: &mut O,
    ) -> Vec3 {
        counts.camera += 1;
        observer.note(|| Event::Ray { kind: RayKind::Camera, ray: *ray, factor: Vec3::ONE });
        let Self { scene, plan, ref lights, .. } = *self;
        let mut task = Task { scene, plan, sampler, counts, observer };
        match plan.integrator {
            IntegratorKind::Normals => textbook::normals::radiance(&mut task, ray),
            IntegratorKind::Phong => textbook::phong::radiance(&mut task, ray),
            IntegratorKind::Whitted => {
                let path = Path { ray: *ray, media: *media, weight: Vec3::ONE, depth: 0 };
                textbook::whitted::radiance(&mut task, &path)
            }
            IntegratorKind::Path => textbook::path::radiance(task, lights, ray, media),
        }
    }

    /// The tracer of whole streams of rays; `None` unless rays are traced side by side.
    pub fn side_by_side(&self) -> Option<&StreamTracer<'a>> {
        if let ReadyWing::SideBySide(tracer) = &self.wing { Some(tracer) } else { None }
    }

    /// What was left out beyond the plan, after a look at the light itself; one sentence an item.
    pub fn left_out(&self) -> Vec<String> {
        let mut items = self.lights.left_out(self.plan);
        let wing = match &self.wing {
            ReadyWing::Textbook => None,
            ReadyWing::SideBySide(_) => Some("rays are traced side by side, with the same bits"),
            ReadyWing::Guided(guided) if guided.has_photons() => Some("photons guide paths, with the same mean"),
            ReadyWing::Guided(_) => Some("both branches of glass are followed, with the same mean"),
        };
        items.extend(wing.map(|wing| format!("{wing}: the textbook code is not used (--textbook uses it)")));
        items
    }

    /// The glasses that enclose a point from which rays start, outermost first: a camera may stand in water.
    pub fn media_around(&self, point: DVec3) -> MediumStack {
        enclosing::media_around(self.scene, self.plan, point)
    }
}
