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
mod lights;
mod vertex;
mod weights;

use super::RayCounts;
use super::direct::{COORDINATES_COLOUR, SHINES, View, coordinates_colour};
use super::media::{Media, medium_before};
use super::normals;
use super::observer::{Event, LightOutcome, Observer, RayKind};
use crate::error::Result;
use crate::materials::{Material, MediumStack};
use crate::math::{DVec3, Ray, Side, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{Plan, Scene, Strategy};
use crate::shapes::Surface;
use caustics::{CausticGuide, Directions};
use lights::LightTables;
use vertex::Vertex;
use weights::power_heuristic;

/// Bounces before random ends of paths are allowed.
const SURE_BOUNCES: u32 = 3;

/// What the path tracer looks up.
pub(super) struct PathTables {
    lights: LightTables,
    /// `None` where no caustic is worth the search.
    caustics: Option<CausticGuide>,
}

impl PathTables {
    /// Builds what the plan asks for. An error tells that a picture of the environment cannot be decoded.
    pub fn new(scene: &Scene, plan: &Plan) -> Result<Self> {
        let lights = LightTables::new(scene, plan)?;
        let caustics = CausticGuide::new(scene, plan, &lights);
        Ok(Self { lights, caustics })
    }

    /// What was left out after a look at the light itself, one sentence an item.
    pub fn left_out(&self, plan: &Plan) -> Vec<String> {
        self.lights.left_out(plan)
    }
}

/// Radiance along a camera ray.
#[expect(clippy::too_many_arguments, reason = "once a camera ray; they differ in life")]
pub(super) fn radiance<O: Observer>(
    scene: &Scene,
    plan: &Plan,
    tables: &PathTables,
    ray: &Ray,
    media: &MediumStack,
    sampler: &mut PixelSampler,
    counts: &mut RayCounts,
    observer: &mut O,
) -> Vec3 {
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
    walk.observer.note(|| Event::Ray { kind: RayKind::Camera, ray: *ray, factor: Vec3::ONE });
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
    /// By the camera, mirrors or smooth glass: no other way could have found what it hits.
    Camera,
    /// At random with this density by solid angle, from a surface where lights were sampled, too.
    Scattered { density: f64 },
    /// By mirrors or smooth glass, after it was scattered in the direction `towards` with this density, where caustics
    /// may have been searched for, too.
    Focused { density: f64, towards: DVec3, caustics: Option<Directions<'a>> },
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

    /// Follows the path to the next surface and chooses how to leave it. False at the path's end.
    fn step(&mut self, path: &mut Path<'a>) -> bool {
        let scene = self.scene;
        path.media = scene.shapes.settled(&path.media, &path.ray);
        let Some(hit) = scene.shapes.intersect(&path.ray) else {
            self.take_environment(path);
            return false;
        };
        let surface = scene.shapes.surface(&path.ray, &hit);
        let view = View::new(&surface, path.ray.direction);
        let transmittance = self.media_of.transmittance(|| medium_before(&path.media, &surface, &view), hit.t);
        path.throughput *= transmittance;
        self.observer.note(|| view.hit(&surface, &path.ray, hit.t, transmittance));
        let material = &scene.materials[surface.material as usize];
        if !self.take_own_light(path, material, &surface, &view) {
            return false;
        }
        if path.bounces >= scene.integrator.depth {
            self.counts.cut_by_depth += 1;
            self.observer.note(|| Event::CutByDepth { kind: RayKind::Scattered, depth: path.bounces });
            return false;
        }
        let media = path.media;
        let vertex = Vertex::new(&self.media_of, &media, path.ray.direction, material, surface, view);
        let Some(vertex) = vertex else { return false };
        if !vertex.scattering.is_specular() {
            self.take_lights(path, &vertex);
            self.take_caustics(path, &vertex);
        }
        self.leave(path, &vertex)
    }

    /// The light of the environment at the end of a path that hits nothing.
    fn take_environment(&mut self, path: &Path) {
        self.counts.environment += 1;
        let direction = path.ray.direction;
        let weight = self.weight_of(path.arrival, || self.tables.lights.environment_density(direction));
        if weight > 0.0 {
            let transmittance = self.media_of.transmittance(|| path.media.innermost(), f64::INFINITY);
            let environment = self.scene.environment.radiance(direction);
            self.observer.note(|| Event::Missed { direction, environment, transmittance });
            self.add("environment, met by chance", path.throughput * transmittance * environment * weight);
        } else {
            self.observer.note(|| Event::Nothing);
        }
    }

    /// The light that a surface sends out by itself. False if that is all it does.
    fn take_own_light(&mut self, path: &Path, material: &Material, surface: &Surface, view: &View) -> bool {
        let (what, colour) = match material {
            Material::Light { .. } if view.side == Side::Back => return false,
            Material::Light { radiance } => {
                let Ray { origin, direction, .. } = path.ray;
                let lights = &self.tables.lights;
                let weight = self.weight_of(path.arrival, || lights.shape_density(origin, direction, surface));
                (SHINES, *radiance * weight)
            }
            Material::Normals => (normals::NORMAL_COLOUR, normals::colour(surface.shading_normal)),
            Material::TextureCoordinates => (COORDINATES_COLOUR, coordinates_colour(surface.texture_coordinates)),
            _ => return true,
        };
        self.add(what, path.throughput * colour);
        false
    }

    /// What light counts that the last ray hit; `light_density` is the density with which rays sent to light sources would
    /// have found it from the last surface.
    #[inline]
    fn weight_of(&self, arrival: Arrival, light_density: impl FnOnce() -> f64) -> f32 {
        match (arrival, self.plan.strategy) {
            (Arrival::Camera, _) | (Arrival::Scattered { .. }, Strategy::Bsdf) => 1.0,
            (Arrival::Scattered { .. }, Strategy::Light) => f32::from(u8::from(light_density() <= 0.0)),
            (Arrival::Scattered { density }, _) => power_heuristic(density, light_density()),
            (Arrival::Focused { density, towards, caustics }, _) => {
                caustics.map_or(1.0, |directions| power_heuristic(density, directions.density(towards)))
            }
        }
    }

    /// The light that arrives straight from light sources, by rays sent to them.
    fn take_lights(&mut self, path: &Path<'a>, vertex: &Vertex) {
        self.take_delta_lights(path, vertex);
        if self.tables.lights.is_empty() {
            return;
        }
        let [x, y, choice, _] = self.sampler.four().map(f64::from);
        let Some(light) = self.tables.lights.sample(vertex.surface.position, [x, y], choice) else { return };
        let evaluation = vertex.scattering.evaluate(vertex.towards_viewer, vertex.frame.to_local(light.direction));
        if evaluation.value == Vec3::ZERO || light.density <= 0.0 {
            return;
        }
        let Some(ray) = vertex.ray_towards(light.direction) else { return };
        self.counts.shadow += 1;
        let weight = match self.plan.strategy {
            Strategy::Light => 1.0,
            _ => power_heuristic(light.density, evaluation.density),
        };
        let found = self.tables.lights.radiance(self.scene, &ray, &light);
        self.observer.note(|| Event::SampledLight {
            ray,
            density: light.density,
            weight,
            radiance: found.map(|(radiance, _)| radiance),
        });
        let Some((radiance, distance)) = found else { return };
        let transmittance = self.media_of.transmittance(|| vertex.media_of(&ray).innermost(), distance);
        let share = evaluation.value * (f64::from(weight) / light.density) as f32;
        self.add("light, by a ray sent to it", path.throughput * share * transmittance * radiance);
    }

    /// The light of points and directions, which no random ray can hit.
    fn take_delta_lights(&mut self, path: &Path<'a>, vertex: &Vertex) {
        if !self.plan.direct_light {
            return;
        }
        for (number, light) in self.scene.lights.iter().enumerate() {
            let Some(arriving) = light.illumination(vertex.surface.position) else { continue };
            let towards = vertex.frame.to_local(arriving.to_light);
            let value = vertex.scattering.evaluate(vertex.towards_viewer, towards).value;
            if value == Vec3::ZERO {
                continue;
            }
            let Some(ray) = vertex.ray_towards(arriving.to_light) else { continue };
            if self.plan.shadow_rays {
                self.counts.shadow += 1;
                if self.scene.shapes.occluded(&ray, arriving.distance) {
                    let outcome = LightOutcome::Blocked { ray, distance: arriving.distance };
                    self.observer.note(|| Event::Light { number, outcome });
                    continue;
                }
            }
            let transmittance = self.media_of.transmittance(|| vertex.media_of(&ray).innermost(), arriving.distance);
            let contribution = path.throughput * value * transmittance * arriving.irradiance;
            self.observer.note(|| {
                let (distance, cosine) = (arriving.distance, towards.z);
                Event::Light { number, outcome: LightOutcome::Free { ray, distance, cosine, contribution } }
            });
            self.add("light from a single direction", contribution);
        }
    }

    /// Light that glass and mirrors focus here, by rays in the directions that light sent ahead came from.
    fn take_caustics(&mut self, path: &mut Path<'a>, vertex: &Vertex) {
        let Some(guide) = &self.tables.caustics else { return };
        path.caustics = guide.around(vertex.surface.position);
        let Some(directions) = path.caustics else { return };
        let [x, y, choice, _] = self.sampler.four().map(f64::from);
        let (direction, density) = directions.draw([x, y], choice);
        let evaluation = vertex.scattering.evaluate(vertex.towards_viewer, vertex.frame.to_local(direction));
        let Some(ray) = vertex.ray_towards(direction).filter(|_| evaluation.value != Vec3::ZERO) else { return };
        let weight = f64::from(power_heuristic(density, evaluation.density));
        let factor = evaluation.value * (weight / density) as f32;
        self.observer.note(|| Event::Ray { kind: RayKind::Focused, ray, factor });
        self.follow_focused(Path {
            ray,
            media: vertex.media_of(&ray),
            throughput: path.throughput * evaluation.value * (weight / density) as f32,
            bounces: path.bounces + 1,
            arrival: Arrival::Camera,
            caustics: None,
        });
        self.observer.note(|| Event::End { radiance: None });
    }

    /// Follows a ray through mirrors and smooth glass, at least one, to a light source.
    fn follow_focused(&mut self, mut path: Path<'a>) {
        let scene = self.scene;
        let start = path.bounces;
        self.counts.shadow += 1;
        loop {
            path.media = scene.shapes.settled(&path.media, &path.ray);
            let Some(hit) = scene.shapes.intersect(&path.ray) else {
                if path.bounces > start {
                    self.take_environment(&path);
                }
                return;
            };
            let surface = scene.shapes.surface(&path.ray, &hit);
            let view = View::new(&surface, path.ray.direction);
            let transmittance = self.media_of.transmittance(|| medium_before(&path.media, &surface, &view), hit.t);
            path.throughput *= transmittance;
            self.observer.note(|| view.hit(&surface, &path.ray, hit.t, transmittance));
            let material = &scene.materials[surface.material as usize];
            if material.shines() && path.bounces > start {
                self.take_own_light(&path, material, &surface, &view);
            }
            if path.bounces >= scene.integrator.depth {
                return;
            }
            let media = path.media;
            let vertex = Vertex::new(&self.media_of, &media, path.ray.direction, material, surface, view);
            let Some(vertex) = vertex.filter(|vertex| vertex.scattering.is_specular()) else { return };
            if !self.leave(&mut path, &vertex) {
                return;
            }
        }
    }

    /// Chooses the next ray. False if the path ends here.
    fn leave(&mut self, path: &mut Path<'a>, vertex: &Vertex) -> bool {
        let [x, y, choice, survival] = self.sampler.four().map(f64::from);
        let Some(sample) = vertex.scattering.sample(vertex.towards_viewer, [x, y], choice) else { return false };
        let Some((ray, media)) = vertex.departure(&sample) else { return false };
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
            Arrival::Scattered { density } => {
                Arrival::Focused { density, towards: path.ray.direction, caustics: path.caustics }
            }
            arrival => arrival,
        };
        (path.ray, path.media) = (ray, media);
        path.throughput *= sample.weight;
        path.bounces += 1;
        self.survives(path, survival)
    }

    /// Ends paths that carry little at random; the survivors carry as much more, so nothing is lost on average (Russian
    /// roulette: Arvo and Kirk, Particle Transport and Image Synthesis, 1990).
    fn survives(&mut self, path: &mut Path, uniform: f64) -> bool {
        let carried = path.throughput.max_element();
        if carried <= 0.0 {
            return false;
        }
        if path.bounces <= SURE_BOUNCES || carried >= 1.0 || !self.plan.roulette {
            return true;
        }
        if uniform >= f64::from(carried) {
            self.counts.cut_by_weight += 1;
            self.observer.note(|| Event::CutByWeight { kind: RayKind::Scattered, weight: carried });
            return false;
        }
        path.throughput /= carried;
        true
    }
}
