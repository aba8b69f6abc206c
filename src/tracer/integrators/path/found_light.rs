//! The light that a path finds: at its end by chance, and by rays sent to light sources and to where light is focused.

use super::super::direct::{COORDINATES_COLOUR, SHINES, coordinates_colour};
use super::super::normals;
use super::super::observer::{Event, LightOutcome, Observer};
use super::super::view::View;
use super::vertex::Vertex;
use super::weights::power_heuristic;
use super::{Arrival, Path, Walk};
use crate::materials::Material;
use crate::math::{Ray, Side, Vec3};
use crate::scene::Strategy;
use crate::shapes::Surface;

impl<'a, O: Observer> Walk<'a, O> {
    /// The light of the environment at the end of a path that hits nothing.
    pub(super) fn take_environment(&mut self, path: &Path) {
        if matches!(path.arrival, Arrival::Obstructed) {
            self.observer.note(|| Event::OpenSky);
            return;
        }
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
    pub(super) fn take_own_light(&mut self, path: &Path, material: &Material, surface: &Surface, view: &View) -> bool {
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
            // Taken before, as the open sky.
            (Arrival::Obstructed, _) => 0.0,
            (Arrival::Camera, _) | (Arrival::Scattered { .. }, Strategy::Bsdf) => 1.0,
            (Arrival::Scattered { .. }, Strategy::Light) => f32::from(u8::from(light_density() <= 0.0)),
            (Arrival::Scattered { density }, _) => power_heuristic(density, light_density()),
            (Arrival::Focused { density, towards, signature, caustics }, _) => {
                caustics.map_or(1.0, |directions| power_heuristic(density, directions.density(towards, signature)))
            }
        }
    }

    /// The light that arrives straight from light sources, by rays sent to them.
    pub(super) fn take_lights(&mut self, path: &Path<'a>, vertex: &Vertex) {
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
        let transmittance = self.media_of.transmittance(|| vertex.media_of(&ray, &path.media).innermost(), distance);
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
            let transmittance =
                self.media_of.transmittance(|| vertex.media_of(&ray, &path.media).innermost(), arriving.distance);
            let contribution = path.throughput * value * transmittance * arriving.irradiance;
            self.observer.note(|| {
                let (distance, cosine) = (arriving.distance, towards.z);
                Event::Light { number, outcome: LightOutcome::Free { ray, distance, cosine, contribution } }
            });
            self.add("light from a single direction", contribution);
        }
    }
}
