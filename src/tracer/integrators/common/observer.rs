//! Observers of an integrator, for `skycube trace`.
//!
//! The textbook integrators are generic over an [`Observer`]. [`Blind`] sees nothing and compiles to nothing;
//! [`Recorder`] keeps every event. Closures make the events, so a blind observer does not pay for them.

use serde::{Serialize, Serializer};

use crate::choice::name_of;
use crate::math::{DVec3, Ray, Side, Vec3};
use crate::scene::give_up;
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

/// Keeps everything, and gives up a sample with more than [`Recorder::MOST`] events.
#[derive(Debug, Default)]
pub struct Recorder {
    /// In the order in which they happened.
    pub events: Vec<Event>,
}

impl Recorder {
    /// The most events that are kept: nobody reads more, and a deep tree of rays has more than fit into memory.
    pub const MOST: usize = 1 << 20;
}

impl Observer for Recorder {
    fn note(&mut self, event: impl FnOnce() -> Event) {
        if self.events.len() == Self::MOST {
            give_up();
        }
        self.events.push(event());
    }
}

/// Why a ray is traced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum RayKind {
    /// From the camera.
    #[value(name = "camera ray")]
    Camera,
    /// By reflection at a mirror or glass.
    #[value(name = "reflected ray")]
    Reflected,
    /// Through glass.
    #[value(name = "refracted ray")]
    Refracted,
    /// The next ray of a random path.
    #[value(name = "scattered ray")]
    Scattered,
}

/// By its name.
impl Serialize for RayKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&name_of(*self))
    }
}

/// What happens to a light at a surface.
#[derive(Debug, Clone, Copy)]
pub enum LightOutcome {
    /// Ambient light, unshadowed.
    Ambient {
        /// Radiance towards the viewer.
        contribution: Vec3,
    },
    /// The light does not reach this point: outside the cone of a spot.
    Unreached,
    /// The surface faces away from it, or the material reflects nothing from there.
    Behind,
    /// Something is in between.
    Blocked {
        /// From the surface to the light.
        ray: Ray,
        /// To what is in between.
        distance: f64,
    },
    /// Nothing is in between.
    Free {
        /// From the surface to the light.
        ray: Ray,
        /// To the light; infinite for parallel light.
        distance: f64,
        /// Between the shading normal and the direction to the light.
        cosine: f64,
        /// Radiance towards the viewer.
        contribution: Vec3,
    },
}

/// A step of an integrator. What is between `Ray` and its `End` belongs to that ray. What is skipped in JSON takes a scene to
/// name; `report/trace/json.rs` adds it.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// A ray sets out; what it finds counts `factor` for what sent it out.
    Ray {
        /// Why the ray was sent.
        kind: RayKind,
        /// In the world, of unit direction.
        #[serde(flatten)]
        ray: Ray,
        /// Linear RGB.
        factor: Vec3,
    },
    /// It hit nothing and took the environment; `transmittance` is what is left of it through glass.
    Missed {
        /// Unit direction of the ray, in the world.
        direction: DVec3,
        /// Linear RGB radiance from there.
        environment: Vec3,
        /// Linear RGB in `[0, 1]`.
        transmittance: Vec3,
    },
    /// It hit nothing, and nothing is taken: black.
    Nothing,
    /// It hit a surface; `transmittance` is the share of its light that passes the glass in between.
    Hit {
        /// The surface there, in the world.
        #[serde(skip)]
        surface: Surface,
        /// Which side of the surface the ray met.
        #[serde(skip)]
        side: Side,
        /// Unit length, on the side of the viewer.
        #[serde(rename = "normal")]
        shading_normal: DVec3,
        /// Along the ray, in units of the world.
        distance: f64,
        /// Between the shading normal and the direction back along the ray.
        #[serde(skip)]
        cosine: f64,
        /// Linear RGB in `[0, 1]`.
        transmittance: Vec3,
    },
    /// The colour that a surface shows by itself.
    Own {
        /// What it is, in the words of the report.
        what: &'static str,
        /// Linear RGB radiance.
        colour: Vec3,
    },
    /// Number of the light in the scene.
    Light {
        /// From 0, in the order of the scene file.
        #[serde(skip)]
        number: usize,
        /// Whether its light arrives.
        #[serde(skip)]
        outcome: LightOutcome,
    },
    /// What Fresnel's equations give at a smooth glass.
    Fresnel {
        /// Index of refraction on the side of the ray.
        index_before: f64,
        /// Index of refraction on the other side.
        index_beyond: f64,
        /// Unpolarised, in `[0, 1]`; 1 at total reflection.
        #[serde(rename = "reflected")]
        reflectance: f64,
        /// Cosine of the angle of refraction; `None` at total reflection.
        #[serde(skip)]
        cos_transmitted: Option<f64>,
    },
    /// A branch is not followed: its depth.
    CutByDepth {
        /// What the branch would have been.
        kind: RayKind,
        /// Reflections and refractions up to here.
        depth: u32,
    },
    /// A branch is not followed by a random decision.
    CutByWeight {
        /// What the branch would have been.
        kind: RayKind,
        /// What the branch would have counted.
        weight: f32,
    },
    /// A path went on by a random decision, and counts for those that did not.
    Survived {
        /// The probability of that.
        probability: f32,
    },
    /// A light with an extent was drawn, and counts with the weight of multiple importance sampling.
    SampledLight {
        /// From the surface to the point on the light.
        #[serde(skip)]
        ray: Ray,
        /// Of the drawn direction, per steradian.
        density: f64,
        /// Of multiple importance sampling, in `[0, 1]`.
        weight: f32,
        /// What arrives, linear RGB; `None` if the light is blocked.
        radiance: Option<Vec3>,
    },
    /// A direction was drawn to go on.
    Scattered {
        /// True if no other direction was possible: mirrors and smooth glass.
        specular: bool,
        /// True if the path passes to the other side.
        transmitted: bool,
        /// Of the drawn direction, per steradian; for specular events the probability of the branch.
        density: f64,
        /// Scattering function times cosine over density, linear RGB.
        weight: Vec3,
    },
    /// Light found was added to the pixel: what the path carried to here times what arrives, times the weight that it counts
    /// beside another way to find it.
    Added {
        /// Where the light comes from, in the words of the report.
        what: &'static str,
        /// Of multiple importance sampling, in `[0, 1]`.
        weight: f32,
        /// What the pixel gains, linear RGB.
        contribution: Vec3,
    },
    /// The ray is done: what it brought back; `None` where the path adds to the pixel instead.
    End {
        /// Linear RGB.
        radiance: Option<Vec3>,
    },
}
