//! The light that mirrors and glass focus, found by rays in the directions from which photons came.

use super::super::observer::{Event, Observer, RayKind};
use super::caustics::{FocusedDirection, SpecularEvent, branch};
use super::vertex::Vertex;
use super::weights::power_heuristic;
use super::{Arrival, Path, Walk};
use crate::math::Vec3;

impl<'a, O: Observer> Walk<'a, O> {
    /// Light that arrives here by one of the known specular chains.
    pub(super) fn take_caustics(&mut self, path: &mut Path<'a>, vertex: &Vertex) {
        let Some(guide) = &self.tables.caustics else { return };
        let directions = guide.around(vertex.surface.position);
        path.caustics = Some(directions);
        let [x, y, choice, _] = self.sampler.four().map(f64::from);
        let Some(FocusedDirection { direction, density, events }) = directions.draw([x, y], choice) else { return };
        let evaluation = vertex.scattering.evaluate(vertex.towards_viewer, vertex.frame.to_local(direction));
        if evaluation.value == Vec3::ZERO || evaluation.density <= 0.0 {
            return;
        }
        let Some(ray) = vertex.ray_towards(direction) else { return };
        let factor = evaluation.value * (1.0 / density) as f32;
        self.counts.shadow += 1;
        self.observer.note(|| Event::Ray { kind: RayKind::Focused, ray, factor });
        let mut focused = Path {
            ray,
            media: vertex.media_of(&ray, &path.media),
            throughput: path.throughput * factor,
            bounces: path.bounces + 1,
            arrival: Arrival::Camera,
            caustics: None,
        };
        if let Some(chance) = self.follow_chain(&mut focused, events) {
            // The other technique would have had to choose the direction and every branch.
            focused.throughput *= power_heuristic(density, evaluation.density * chance);
            self.take_light_at_end(&mut focused);
        }
        self.observer.note(|| Event::End { radiance: None });
    }

    /// Follows a ray along a specular chain. Returns the probability that chance takes it; `None` if it meets other events.
    fn follow_chain(&mut self, path: &mut Path<'a>, events: &[SpecularEvent]) -> Option<f64> {
        let scene = self.scene;
        let mut chance = 1.0;
        for event in events {
            let (surface, view) = self.arrive(path)?;
            if surface.id.shape != event.shape || path.bounces >= scene.integrator.depth {
                return None;
            }
            let material = &scene.materials[surface.material as usize];
            let vertex = Vertex::new(&self.media_of, &path.media, path.ray.direction, material, surface, view)?;
            let (sample, probability) = branch(&vertex, event.transmitted)?;
            if !self.depart(path, &vertex, &sample) {
                return None;
            }
            chance *= probability;
        }
        Some(chance)
    }

    /// The light that a path ends at, if nothing else is in its way.
    fn take_light_at_end(&mut self, path: &mut Path<'a>) {
        let scene = self.scene;
        let Some((surface, view)) = self.arrive(path) else {
            self.take_environment(path);
            return;
        };
        let material = &scene.materials[surface.material as usize];
        if material.shines() {
            self.take_own_light(path, material, &surface, &view);
        }
    }
}
