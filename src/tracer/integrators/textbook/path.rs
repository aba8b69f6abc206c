//! Path tracing: all light, along one random path from the camera for every sample of a pixel.
//!
//! ```text
//!     camera o                       L = emitted + integral over directions  f L(direction) |cos| d direction
//!             \         * light
//!              \      .              Where a surface scatters light in all directions, light is looked for in two ways:
//!               \   .        o light     a ray towards a point of a light, chosen at random,
//!        --------x----------/---         and the path itself, which may hit a light by chance.
//!                 \________x         Each counts by how well it could have found that light, p^2 / (p^2 + q^2) with the
//!                                    densities p of its own and q of the other: none counts twice.
//! ```
//!
//! (The equation: Kajiya, The Rendering Equation, 1986; the weights: Veach, Robust Monte Carlo Methods for Light Transport
//! Simulation, 1997, section 9.2; the loop: Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition,
//! section 13.4, "A Better Path Tracer".)

use crate::integrators::common::lights::{LightTables, power_heuristic, weight_of_chance};
use crate::integrators::common::media::{Media, medium_before};
use crate::integrators::common::observer::{Event, LightOutcome, Observer, RayKind};
use crate::integrators::common::task::Task;
use crate::integrators::common::vertex::Vertex;
use crate::integrators::common::view::{EMITTED, View, debug_colour};
use crate::materials::{Material, MediumStack, ScatteringSample};
use crate::math::{Ray, Side, Vec3};
use crate::scene::Strategy;
use crate::shapes::Surface;

/// Paths that carry less may end at random. Measured: a third of it or three times as much costs more time at equal error.
const SMALL_SHARE: f32 = 0.1;

/// A path tracer at work on one sample of a pixel.
pub struct PathTracer<'a, O> {
    pub task: Task<'a, O>,
    pub lights: &'a LightTables,
    pub glass: Media<'a>,
    /// What was found so far.
    pub radiance: Vec3,
}

/// The radiance along a camera ray that starts inside of the given glasses.
pub fn radiance<O: Observer>(task: Task<O>, lights: &LightTables, ray: &Ray, media: &MediumStack) -> Vec3 {
    let glass = Media { scene: task.scene, absorption: task.plan.absorption };
    let mut tracer = PathTracer { task, lights, glass, radiance: Vec3::ZERO };
    tracer.follow(*ray, *media);
    tracer.task.observer.note(|| Event::End { radiance: None });
    tracer.radiance
}

impl<O: Observer> PathTracer<'_, O> {
    /// Follows the path from the camera until something ends it: `None`.
    fn follow(&mut self, mut ray: Ray, mut media: MediumStack) -> Option<()> {
        let (scene, lights, strategy) = (self.task.scene, self.lights, self.task.plan.strategy);
        // Share of the radiance at the end of the ray that reaches the camera, over the probability of the path.
        let mut carried = Vec3::ONE;
        // The density with which the last direction was chosen; `None` where no ray was sent to a light, too.
        let mut chosen: Option<f64> = None;
        for bounce in 0.. {
            // The next surface, through the glass in between.
            media = scene.shapes.settled(&media, &ray);
            let Some(hit) = scene.shapes.intersect(&ray) else {
                let weight = weight_of_chance(strategy, chosen, || lights.environment_density(ray.direction));
                self.add_environment(carried, &ray, &media, weight);
                return None;
            };
            let surface = scene.shapes.surface(&ray, &hit);
            let view = View::new(&surface, ray.direction);
            let transmittance = self.glass.transmittance(|| medium_before(&media, &surface, &view), hit.t);
            carried *= transmittance;
            self.task.observer.note(|| view.hit(&surface, &ray, hit.t, transmittance));

            // The light that the surface emits.
            let material = &scene.materials[surface.material as usize];
            self.add_own_light(carried, material, &surface, &view, || {
                weight_of_chance(strategy, chosen, || lights.shape_density(ray.origin, ray.direction, &surface))
            });
            let vertex = Vertex::new(&self.glass, &media, ray.direction, material, surface, view)?;
            if bounce >= scene.integrator.depth {
                self.task.counts.cut_by_depth += 1;
                self.task.observer.note(|| Event::CutByDepth { kind: RayKind::Scattered, depth: bounce });
                return None;
            }

            // The light that it scatters straight from the light sources.
            if !vertex.scattering.is_specular() {
                self.add_single_directions(carried, &vertex, &media);
                self.add_sampled_light(carried, &vertex, &media);
            }

            // The next direction, chosen much as the material scatters light.
            let [x, y, choice, uniform] = self.task.sampler.four().map(f64::from);
            let sample = vertex.scattering.sample(vertex.towards_viewer, [x, y], choice)?;
            ray = self.leave(&vertex, &sample, &mut media)?;
            chosen = (!sample.specular).then_some(sample.density);
            carried *= sample.weight;

            // Paths that carry little end at random; the survivors stand for them.
            carried /= self.survival(carried.max_element(), uniform)?;
        }
        None
    }

    /// Adds light to the pixel.
    pub fn add(&mut self, what: &'static str, weight: f32, contribution: Vec3) {
        self.task.observer.note(|| Event::Added { what, weight, contribution });
        self.radiance += contribution;
    }

    /// The light of the environment at the end of a path that hits nothing.
    pub fn add_environment(&mut self, carried: Vec3, ray: &Ray, media: &MediumStack, weight: f32) {
        self.task.counts.environment += 1;
        if weight == 0.0 {
            return self.task.observer.note(|| Event::Nothing);
        }
        let direction = ray.direction;
        let transmittance = self.glass.transmittance(|| media.innermost(), f64::INFINITY);
        let environment = self.task.scene.environment.radiance(direction);
        self.task.observer.note(|| Event::Missed { direction, environment, transmittance });
        self.add("environment, hit by a scattered ray", weight, carried * transmittance * environment * weight);
    }

    /// What a surface shows without any light: its emission, which counts `weight`, or a colour for debugging.
    pub fn add_own_light(
        &mut self,
        carried: Vec3,
        material: &Material,
        surface: &Surface,
        view: &View,
        weight: impl FnOnce() -> f32,
    ) -> Option<()> {
        let (what, colour) = match material {
            Material::Light { radiance } if view.side == Side::Front => (EMITTED, *radiance),
            _ => debug_colour(material, surface)?,
        };
        let weight = if material.is_emissive() { weight() } else { 1.0 };
        self.add(what, weight, carried * (colour * weight));
        Some(())
    }

    /// The light of one light source with an extent, by a ray sent to it.
    pub fn add_sampled_light(&mut self, carried: Vec3, vertex: &Vertex, media: &MediumStack) -> Option<()> {
        if self.lights.is_empty() {
            return None;
        }
        let [x, y, choice, _] = self.task.sampler.four().map(f64::from);
        let light = self.lights.sample(vertex.surface.position, [x, y], choice)?;
        let evaluation = vertex.scattering.evaluate(vertex.towards_viewer, vertex.frame.to_local(light.direction));
        if evaluation.value == Vec3::ZERO || light.density <= 0.0 {
            return None;
        }
        let ray = vertex.ray_towards(light.direction)?;
        self.task.counts.shadow += 1;
        let weight = match self.task.plan.strategy {
            Strategy::Light => 1.0,
            _ => power_heuristic(light.density, evaluation.density),
        };
        let found = self.lights.radiance(self.task.scene, &ray, &light);
        let (density, radiance) = (light.density, found.map(|(radiance, _)| radiance));
        self.task.observer.note(|| Event::SampledLight { ray, density, weight, radiance });
        let (radiance, distance) = found?;
        let transmittance = self.glass.transmittance(|| vertex.media_of(&ray, media).innermost(), distance);
        let share = evaluation.value * (f64::from(weight) / light.density) as f32;
        self.add("light, by a shadow ray", weight, carried * share * transmittance * radiance);
        Some(())
    }

    /// The light of points and directions, which no random ray can hit.
    pub fn add_single_directions(&mut self, carried: Vec3, vertex: &Vertex, media: &MediumStack) {
        let scene = self.task.scene;
        for (number, light) in scene.lights.iter().enumerate().filter(|_| self.task.plan.direct_light) {
            let Some(arriving) = light.illumination(vertex.surface.position) else { continue };
            let towards = vertex.frame.to_local(arriving.to_light);
            let value = vertex.scattering.evaluate(vertex.towards_viewer, towards).value;
            let Some(ray) = vertex.ray_towards(arriving.to_light).filter(|_| value != Vec3::ZERO) else { continue };
            let distance = arriving.distance;
            if self.task.plan.shadow_rays {
                self.task.counts.shadow += 1;
                if scene.shapes.occluded(&ray, distance) {
                    self.task
                        .observer
                        .note(|| Event::Light { number, outcome: LightOutcome::Blocked { ray, distance } });
                    continue;
                }
            }
            let transmittance = self.glass.transmittance(|| vertex.media_of(&ray, media).innermost(), distance);
            let contribution = carried * value * transmittance * arriving.irradiance;
            let outcome = LightOutcome::Free { ray, distance, cosine: towards.z, contribution };
            self.task.observer.note(|| Event::Light { number, outcome });
            self.add("light from a single direction", 1.0, contribution);
        }
    }

    /// The ray that leaves a surface in a chosen direction. `None` if the surface lets none pass there.
    pub fn leave(&mut self, vertex: &Vertex, sample: &ScatteringSample, media: &mut MediumStack) -> Option<Ray> {
        let ray = vertex.departure(sample, media)?;
        let ScatteringSample { specular, transmitted, density, weight, .. } = *sample;
        self.task.observer.note(|| Event::Scattered { specular, transmitted, density, weight });
        let counts = &mut *self.task.counts;
        *(if transmitted { &mut counts.refracted } else { &mut counts.reflected }) += 1;
        Some(ray)
    }

    /// The probability with which a path goes on that carries so much of the pixel; `None` if chance ends it (Russian
    /// roulette: Arvo and Kirk, Particle Transport and Image Synthesis, 1990).
    pub fn survival(&mut self, carried: f32, uniform: f64) -> Option<f32> {
        if carried <= 0.0 || carried.is_nan() {
            return None;
        }
        if carried >= SMALL_SHARE || !self.task.plan.roulette {
            return Some(1.0);
        }
        let chance = carried / SMALL_SHARE;
        if uniform >= f64::from(chance) {
            self.task.counts.cut_by_weight += 1;
            self.task.observer.note(|| Event::CutByWeight { kind: RayKind::Scattered, weight: carried });
            return None;
        }
        self.task.observer.note(|| Event::Survived { probability: chance });
        Some(chance)
    }
}
