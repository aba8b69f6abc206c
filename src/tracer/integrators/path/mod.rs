//! Path tracing: all light, along random paths from the camera (Kajiya, The Rendering Equation, 1986).
//!
//! ```text
//!     camera o
//!             \         * light, sampled from every surface that is not a mirror or smooth glass
//!              \      .
//!               \   .        o light, hit by chance
//!        --------x----------/---       Both ways of finding a light are weighted by how well each could have found
//!                 \________x           it (multiple importance sampling), so none counts twice.
//! ```

mod caustics;
mod focused_light;
mod found_light;
mod lights;
mod obstacles;
mod open_sky;
mod vertex;
mod weights;

use super::RayCounts;
use super::media::{Media, medium_before};
use super::observer::{Event, Observer, RayKind};
use super::view::View;
use crate::error::Result;
use crate::materials::{MediumStack, ScatteringSample};
use crate::math::{DVec3, Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{Plan, Scene};
use crate::shapes::Surface;
use caustics::{CausticGuide, Directions, Signature, SpecularEvent};
use lights::LightTables;
use open_sky::OpenSky;
use vertex::Vertex;

/// Paths that carry less end at random. Measured: a third of it or three times as much costs more time at equal error.
const SMALL_SHARE: f32 = 0.1;

/// Where reflection and refraction both carry as much straight to the camera, both are followed.
const BRANCH_SHARE: f32 = 0.02;

/// What the path tracer looks up.
pub(super) struct PathTables {
    lights: LightTables,
    /// `None` where no caustic is worth the search.
    caustics: Option<CausticGuide>,
    /// `None` where the sky is not even, or no surface is flat and dull.
    open_sky: Option<OpenSky>,
}

impl PathTables {
    /// Builds what the plan asks for. An error tells that a picture of the environment cannot be decoded.
    pub fn new(scene: &Scene, plan: &Plan) -> Result<Self> {
        let lights = LightTables::new(scene, plan)?;
        let caustics = CausticGuide::new(scene, plan, &lights);
        let open_sky = if lights.is_empty() { OpenSky::new(scene, plan)? } else { None };
        Ok(Self { lights, caustics, open_sky })
    }

    /// What was left out after a look at the light itself, one sentence an item.
    pub fn left_out(&self, plan: &Plan) -> Vec<String> {
        let mut items = self.lights.left_out(plan);
        if self.open_sky.is_some() {
            items.push("the open sky over flat surfaces is computed beforehand: rays only to what may hide it".into());
        }
        items
    }
}

/// What a ray of the camera is traced with.
pub(super) struct Task<'a, O> {
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub sampler: &'a mut PixelSampler,
    pub counts: &'a mut RayCounts,
    pub observer: &'a mut O,
}

/// Radiance along a camera ray.
pub(super) fn radiance<O: Observer>(task: Task<O>, tables: &PathTables, ray: &Ray, media: &MediumStack) -> Vec3 {
    let Task { scene, plan, sampler, counts, observer } = task;
    let mut walk = Walk {
        scene,
        plan,
        tables,
        media_of: Media { scene, absorption: plan.absorption },
        sampler,
        counts,
        radiance: Vec3::ZERO,
        observer,
    };
    let mut path =
        Path { ray: *ray, media: *media, throughput: Vec3::ONE, bounces: 0, arrival: Arrival::Camera, caustics: None };
    while walk.step(&mut path) {}
    walk.observer.note(|| Event::End { radiance: None });
    walk.radiance
}

/// A path as far as it is known.
struct Path<'a> {
    /// The last ray, on its way to the next surface.
    ray: Ray,
    media: MediumStack,
    /// Share of the radiance at the end of the ray that reaches the camera, over the probability of the path.
    throughput: Vec3,
    bounces: u32,
    arrival: Arrival<'a>,
    /// Where focused light comes from at the last surface that scattered the path.
    caustics: Option<Directions<'a>>,
}

/// How the last ray was chosen.
#[derive(Clone, Copy)]
enum Arrival<'a> {
    /// By the camera, mirrors or smooth glass, or where nothing else was searched for: no other way could have found what it
    /// hits.
    Camera,
    /// At random to where something may hide the sky, whose light was taken as if nothing did.
    Obstructed,
    /// At random with this density by solid angle, from a surface where lights were sampled, too.
    Scattered { density: f64 },
    /// By mirrors or smooth glass, after it was scattered in the direction `towards`, where caustics may have been searched
    /// for, too: the density of that times the probability of the specular chain since.
    Focused { density: f64, towards: DVec3, signature: Signature, caustics: Option<Directions<'a>> },
}

impl<'a> Arrival<'a> {
    /// The same after a mirror or smooth glass.
    #[inline(always)]
    fn focused(self, path: &Path<'a>, vertex: &Vertex, sample: &ScatteringSample) -> Self {
        let event = SpecularEvent { shape: vertex.surface.id.shape, transmitted: sample.transmitted };
        let (density, towards, signature, caustics) = match self {
            Arrival::Scattered { density } => (density, path.ray.direction, Signature::START, path.caustics),
            Arrival::Focused { density, towards, signature, caustics } => (density, towards, signature, caustics),
            arrival => return arrival,
        };
        Arrival::Focused { density: density * sample.density, towards, signature: signature.then(event), caustics }
    }
}

struct Walk<'a, O> {
    scene: &'a Scene,
    plan: &'a Plan,
    tables: &'a PathTables,
    media_of: Media<'a>,
    sampler: &'a mut PixelSampler,
    counts: &'a mut RayCounts,
    /// What was found so far.
    radiance: Vec3,
    observer: &'a mut O,
}

impl<'a, O: Observer> Walk<'a, O> {
    /// Adds light to the pixel.
    #[inline(always)]
    fn add(&mut self, what: &'static str, contribution: Vec3) {
        self.observer.note(|| Event::Added { what, contribution });
        self.radiance += contribution;
    }

    /// Follows the path to the next surface, through the glass in between. `None` if it hits nothing.
    #[inline(always)]
    fn arrive(&mut self, path: &mut Path<'a>) -> Option<(Surface, View)> {
        let shapes = &self.scene.shapes;
        if path.media.is_nested() {
            path.media = shapes.settled(&path.media, &path.ray);
        }
        let hit = shapes.intersect(&path.ray)?;
        let surface = shapes.surface(&path.ray, &hit);
        let view = View::new(&surface, path.ray.direction);
        let transmittance = self.media_of.transmittance(|| medium_before(&path.media, &surface, &view), hit.t);
        path.throughput *= transmittance;
        self.observer.note(|| view.hit(&surface, &path.ray, hit.t, transmittance));
        Some((surface, view))
    }

    /// Follows the path to the next surface and chooses how to leave it. False at the path's end.
    fn step(&mut self, path: &mut Path<'a>) -> bool {
        let scene = self.scene;
        let before = path.throughput;
        let Some((surface, view)) = self.arrive(path) else {
            self.take_environment(path);
            return false;
        };
        if let Arrival::Obstructed = path.arrival {
            self.return_hidden_sky(path, before);
        }
        let material = &scene.materials[surface.material as usize];
        if !self.take_own_light(path, material, &surface, &view) {
            return false;
        }
        if path.bounces >= scene.integrator.depth {
            self.counts.cut_by_depth += 1;
            self.observer.note(|| Event::CutByDepth { kind: RayKind::Scattered, depth: path.bounces });
            return false;
        }
        let vertex = Vertex::new(&self.media_of, &path.media, path.ray.direction, material, surface, view);
        let Some(vertex) = vertex else { return false };
        if !vertex.scattering.is_specular() {
            self.take_lights(path, &vertex);
            self.take_caustics(path, &vertex);
        }
        if let Some([reflected, refracted]) = self.branches(path, &vertex) {
            self.follow_branch(path, &vertex, &reflected);
            return self.depart(path, &vertex, &refracted);
        }
        match self.open_sky_over(path, &vertex) {
            Some((radiance, obstacles)) => self.leave_under_open_sky(path, &vertex, radiance, &obstacles),
            None => {
                let survival = self.leave(path, &vertex);
                survival.is_some_and(|survival| self.survives(path, path.throughput.max_element(), survival))
            }
        }
    }

    /// Reflection and refraction at smooth glass, if both carry much: seen by the camera through nothing but mirrors and
    /// smooth glass, to choose one of them at random would be most of the noise. Not where the path was chosen among others.
    #[inline]
    fn branches(&self, path: &Path<'a>, vertex: &Vertex) -> Option<[ScatteringSample; 2]> {
        if !matches!(path.arrival, Arrival::Camera) || path.throughput.max_element() < 2.0 * BRANCH_SHARE {
            return None;
        }
        let branches = vertex.scattering.branches(vertex.towards_viewer)?;
        let carries_much = |branch: &ScatteringSample| (path.throughput * branch.weight).max_element() >= BRANCH_SHARE;
        branches.iter().all(carries_much).then_some(branches)
    }

    /// Follows one branch of a path to its end.
    #[inline(never)]
    fn follow_branch(&mut self, path: &Path<'a>, vertex: &Vertex, sample: &ScatteringSample) {
        let mut branch = Path { ..*path };
        if self.depart(&mut branch, vertex, sample) {
            let (ray, factor) = (branch.ray, branch.throughput);
            self.observer.note(|| Event::Ray { kind: RayKind::Reflected, ray, factor });
            while self.step(&mut branch) {}
            self.observer.note(|| Event::End { radiance: None });
        }
    }

    /// Chooses the next ray. Returns a random number by which the path may end early; `None` if it ends here.
    fn leave(&mut self, path: &mut Path<'a>, vertex: &Vertex) -> Option<f64> {
        let [x, y, choice, survival] = self.sampler.four().map(f64::from);
        let sample = vertex.scattering.sample(vertex.towards_viewer, [x, y], choice)?;
        self.depart(path, vertex, &sample).then_some(survival)
    }

    /// Sends the path on in a direction. False if none of it leaves the surface there.
    #[inline(always)]
    fn depart(&mut self, path: &mut Path<'a>, vertex: &Vertex, sample: &ScatteringSample) -> bool {
        let Some(ray) = vertex.departure(sample, &mut path.media) else { return false };
        self.observer.note(|| Event::Scattered {
            specular: sample.specular,
            transmitted: sample.transmitted,
            density: sample.density,
            weight: sample.weight,
        });
        let count = if sample.transmitted { &mut self.counts.refracted } else { &mut self.counts.reflected };
        *count += 1;
        path.arrival = match path.arrival {
            _ if !sample.specular => Arrival::Scattered { density: sample.density },
            // A mirror direction of a surface that scatters, too: caustics are not searched for through it.
            _ if !vertex.scattering.is_specular() => Arrival::Camera,
            arrival => arrival.focused(path, vertex, sample),
        };
        path.ray = ray;
        path.throughput *= sample.weight;
        path.bounces += 1;
        true
    }

    /// Ends paths at random that carry little of the pixel; the survivors carry as much more, so nothing is lost on average
    /// (Russian roulette: Arvo and Kirk, Particle Transport and Image Synthesis, 1990).
    #[inline]
    fn survives(&mut self, path: &mut Path, carried: f32, uniform: f64) -> bool {
        if carried <= 0.0 || carried.is_nan() {
            return false;
        }
        if carried >= SMALL_SHARE || !self.plan.roulette {
            return true;
        }
        let chance = carried / SMALL_SHARE;
        if uniform >= f64::from(chance) {
            self.counts.cut_by_weight += 1;
            self.observer.note(|| Event::CutByWeight { kind: RayKind::Scattered, weight: carried });
            return false;
        }
        path.throughput /= chance;
        true
    }
}
