//! Observers of an integrator, for `skycube trace`.
//!
//! The textbook integrators are generic over an [`Observer`]. [`Blind`] sees nothing and compiles to nothing;
//! [`Recorder`] keeps every event. Closures make the events, so a blind observer does not pay for them.

use crate::math::{DVec3, Ray, Side, Vec3};
use crate::shapes::Surface;

/// An observer of an integrator.
pub trait Observer {
    /// Something happened.
    fn note(&mut self, event: impl FnOnce() -> Event);
}

/// Sees nothing.
pub struct Blind;

impl Observer for Blind {
    #[inline(always)]
    fn note(&mut self, _: impl FnOnce() -> Event) {}
}

/// Keeps everything.
#[derive(Debug, Default)]
pub struct Recorder {
    /// In the order in which they happened.
    pub events: Vec<Event>,
}

impl Observer for Recorder {
    fn note(&mut self, event: impl FnOnce() -> Event) {
        self.events.push(event());
    }
}

/// Why a ray is traced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RayKind {
    /// From the camera.
    Camera,
    /// By reflection at a mirror or glass.
    Reflected,
    /// Through glass.
    Refracted,
    /// The next ray of a random path.
    Scattered,
}

/// What happens to a light at a surface.
#[derive(Debug, Clone, Copy)]
pub enum LightOutcome {
    /// Ambient light, unshadowed.
    Ambient { contribution: Vec3 },
    /// The light does not reach this point: outside the cone of a spot.
    Unreached,
    /// The surface faces away from it, or the material reflects nothing from there.
    Behind,
    /// Something is in between.
    Blocked { ray: Ray, distance: f64 },
    /// Nothing is in between.
    Free { ray: Ray, distance: f64, cosine: f64, contribution: Vec3 },
}

/// A step of an integrator. What is between `Ray` and its `End` belongs to that ray.
#[derive(Debug, Clone, Copy)]
pub enum Event {
    /// A ray sets out; what it finds counts `factor` for what sent it out.
    Ray { kind: RayKind, ray: Ray, factor: Vec3 },
    /// It hit nothing and took the environment; `transmittance` is what is left of it through glass.
    Missed { direction: DVec3, environment: Vec3, transmittance: Vec3 },
    /// It hit nothing, and nothing is taken: black.
    Nothing,
    /// It hit a surface; `transmittance` is the share of its light that passes the glass in between.
    Hit { surface: Surface, side: Side, shading_normal: DVec3, distance: f64, cosine: f64, transmittance: Vec3 },
    /// The colour that a surface shows by itself.
    Own { what: &'static str, colour: Vec3 },
    /// Number of the light in the scene.
    Light { number: usize, outcome: LightOutcome },
    /// What Fresnel's equations give at a smooth glass.
    Fresnel { index_before: f64, index_beyond: f64, reflectance: f64, cos_transmitted: Option<f64> },
    /// A branch is not followed: its depth.
    CutByDepth { kind: RayKind, depth: u32 },
    /// A branch is not followed by a random decision.
    CutByWeight { kind: RayKind, weight: f32 },
    /// A path went on by a random decision, and counts for those that did not.
    Survived {
        /// The probability of that.
        probability: f32,
    },
    /// A light with an extent was drawn, and counts with the weight of multiple importance sampling.
    SampledLight { ray: Ray, density: f64, weight: f32, radiance: Option<Vec3> },
    /// A direction was drawn to go on.
    Scattered { specular: bool, transmitted: bool, density: f64, weight: Vec3 },
    /// Light found was added to the pixel: what the path carried to here times what arrives, times the weight that it counts
    /// beside another way to find it.
    Added { what: &'static str, weight: f32, contribution: Vec3 },
    /// The ray is done: what it brought back; `None` where the path adds to the pixel instead.
    End { radiance: Option<Vec3> },
}
