//! All light sources with an extent, as one distribution: the environment and emissive shapes.

use crate::envmap::EnvironmentSampler;
use crate::error::Result;
use crate::math::{DVec3, Ray, SurfaceId, Vec3};
use crate::scene::{Plan, Scene, Strategy};
use crate::shapes::{ShapeSampler, Surface};

/// Share of the environment's power in its brightest thousandth from which its light counts as concentrated. Measured
/// skies without a sun have 0.01 or less.
const CONCENTRATED: f64 = 0.1;

/// Up to this share a sky is uniform: under it, rays to its brightest parts cost more than they save (measured by `converge`).
const UNIFORM: f64 = 0.02;

/// The light sources with extent.
pub struct LightTables {
    /// `None` if the plan leaves it out or the environment is black.
    environment: Option<EnvironmentSampler>,
    /// Probability of choosing the environment.
    environment_share: f64,
    /// Share of the environment's power in its brightest thousandth.
    concentration: f64,
    shapes: Vec<ShapeLight>,
    /// By the number of a shape: its place in `shapes`.
    of_shape: Vec<Option<u32>>,
}

/// An emissive shape.
struct ShapeLight {
    shape: u32,
    sampler: ShapeSampler,
    /// Probability of choosing it.
    share: f64,
    /// Sum of the shares up to this one.
    cumulative: f64,
}

/// A direction in which a light was found.
pub struct LightSample {
    pub direction: DVec3,
    /// By solid angle, over all lights.
    pub density: f64,
    /// Probability of choosing the light it comes from.
    pub share: f64,
    /// Infinite for the environment.
    pub distance: f64,
    /// What must be hit there; `None` for the environment.
    target: Option<SurfaceId>,
}

impl LightTables {
    /// Builds what the plan asks for. An error tells that a picture of the environment cannot be decoded.
    pub fn new(scene: &Scene, plan: &Plan) -> Result<Self> {
        let environment =
            if plan.environment_sampling { Some(EnvironmentSampler::new(&scene.environment)?) } else { None };
        let mut environment = environment.filter(|sampler| sampler.power() > 0.0);
        let mut shapes = if plan.light_sampling { shape_lights(scene) } else { Vec::new() };
        let concentration = environment.as_ref().map_or(0.0, EnvironmentSampler::concentration);
        let uniform = plan.strategy == Strategy::Auto && shapes.is_empty() && concentration < UNIFORM;
        if uniform {
            environment = None;
        }
        let environment_share = match (&environment, shapes.is_empty()) {
            (None, _) => 0.0,
            (Some(_), true) => 1.0,
            // How bright a shape is from somewhere depends on where: half and half is never far off.
            (Some(_), false) => 0.5,
        };
        let power: f64 = shapes.iter().map(|light| light.share).sum();
        let mut cumulative = environment_share;
        for light in &mut shapes {
            light.share *= (1.0 - environment_share) / power;
            cumulative += light.share;
            light.cumulative = cumulative;
        }
        let mut of_shape = vec![None; scene.shapes.primitives().len()];
        for (index, light) in shapes.iter().enumerate() {
            of_shape[light.shape as usize] = Some(index as u32);
        }
        Ok(Self { environment, environment_share, concentration, shapes, of_shape })
    }

    /// A direction from a point to a light. `None` if the chosen light cannot be seen from there.
    #[inline]
    pub fn sample(&self, point: DVec3, place: [f64; 2], choice: f64) -> Option<LightSample> {
        if choice < self.environment_share {
            let (direction, density) = self.environment.as_ref()?.sample(place)?;
            return Some(LightSample {
                direction,
                density: density * self.environment_share,
                share: self.environment_share,
                distance: f64::INFINITY,
                target: None,
            });
        }
        let index =
            self.shapes.partition_point(|light| light.cumulative <= choice).min(self.shapes.len().checked_sub(1)?);
        let light = &self.shapes[index];
        // What is left of the number chooses within the shape.
        let rest = ((choice - (light.cumulative - light.share)) / light.share).clamp(0.0, 1.0 - f64::EPSILON);
        let sample = light.sampler.sample_towards(point, place, rest)?;
        let target = Some(SurfaceId { shape: light.shape, part: sample.id_part });
        Some(LightSample {
            direction: sample.to_shape,
            density: sample.density * light.share,
            share: light.share,
            distance: sample.distance,
            target,
        })
    }

    /// The radiance along a ray towards a sampled light and the distance to it; `None` if something is in between.
    #[inline]
    pub fn radiance(&self, scene: &Scene, ray: &Ray, light: &LightSample) -> Option<(Vec3, f64)> {
        let Some(target) = light.target else {
            let free = !scene.shapes.blocked(ray, f64::INFINITY);
            return free.then(|| (scene.environment.radiance(ray.direction), f64::INFINITY));
        };
        let hit = scene.shapes.intersect(ray).filter(|hit| hit.id == target)?;
        let surface = scene.shapes.surface(ray, &hit);
        let front = surface.normal.dot(ray.direction) < 0.0;
        front.then(|| (scene.materials[surface.material as usize].emission(), hit.t))
    }

    /// Mean luminance of the environment, over all directions.
    pub fn mean_luminance(&self) -> f64 {
        self.environment.as_ref().map_or(0.0, EnvironmentSampler::power) / (4.0 * std::f64::consts::PI)
    }

    /// True if there is nothing to send rays to.
    pub fn is_empty(&self) -> bool {
        self.environment.is_none() && self.shapes.is_empty()
    }

    /// True if much of the light comes from small sources: then what glass and mirrors make of it is bright and sharp.
    pub fn is_concentrated(&self) -> bool {
        !self.shapes.is_empty() || self.concentration > CONCENTRATED
    }

    /// What was left out after a look at the light itself.
    pub fn left_out(&self, plan: &Plan) -> Vec<String> {
        let share = format!("{:.1} % of its light from its brightest thousandth", 100.0 * self.concentration);
        let mut items = Vec::new();
        if plan.light_sampling && self.is_empty() {
            items.push(format!("the environment is uniform ({share}): no shadow rays to it"));
        }
        if plan.caustics && !self.is_concentrated() {
            items.push(format!("no small bright light ({share}): no photon pass"));
        }
        items
    }

    /// Density with which [`LightTables::sample`] finds a direction of the environment.
    #[inline]
    pub fn environment_density(&self, direction: DVec3) -> f64 {
        self.environment.as_ref().map_or(0.0, |sampler| sampler.density(direction) * self.environment_share)
    }

    /// Density with which [`LightTables::sample`] finds the direction from a point to a place on an emissive shape.
    pub fn shape_density(&self, point: DVec3, direction: DVec3, surface: &Surface) -> f64 {
        let Some(index) = self.of_shape.get(surface.id.shape as usize).copied().flatten() else { return 0.0 };
        let light = &self.shapes[index as usize];
        light.share * light.sampler.density_towards(point, direction, surface.position, surface.normal, surface.id.part)
    }
}

/// The emissive shapes, weighted by their power.
fn shape_lights(scene: &Scene) -> Vec<ShapeLight> {
    let emission = |material: u32| scene.materials[material as usize].emission();
    let emits = |material: u32| emission(material) != Vec3::ZERO;
    let mut lights = Vec::new();
    for (shape, primitive) in scene.shapes.primitives().iter().enumerate() {
        if !primitive.material.numbers().iter().any(|&number| emits(number)) {
            continue;
        }
        let sampler = ShapeSampler::new(primitive, emits);
        let brightest = primitive.material.numbers().iter().map(|&number| emission(number).max_element());
        let share = sampler.area() * f64::from(brightest.fold(0.0, f32::max));
        // A plane has no end: light from it is found by chance only.
        if share > 0.0 && share.is_finite() {
            lights.push(ShapeLight { shape: shape as u32, sampler, share, cumulative: 0.0 });
        }
    }
    lights
}

/// What a sample counts that was chosen with one density where another technique would have chosen it with the other: the
/// power heuristic with exponent 2, in `[0, 1]` (Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997,
/// section 9.2.3). The weights of both techniques add up to 1.
#[inline]
pub fn power_heuristic(density: f64, other: f64) -> f32 {
    // Divided through by the density's square, which may overflow.
    let ratio = other / density;
    (1.0 / (1.0 + ratio * ratio)) as f32
}

/// What light counts that the path met by chance; `sampled` is the density with which rays to the lights would have found it.
pub fn weight_of_chance(strategy: Strategy, chosen: Option<f64>, sampled: impl FnOnce() -> f64) -> f32 {
    match (chosen, strategy) {
        (None, _) | (_, Strategy::Bsdf) => 1.0,
        (_, Strategy::Light) => f32::from(u8::from(sampled() <= 0.0)),
        (Some(density), _) => power_heuristic(density, sampled()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_of_both_techniques_add_up_to_one() {
        for (a, b) in [(1.0, 1.0), (1e-3, 7.0), (1e200, 1e-200), (3.0, 0.0), (1e300, 1e300)] {
            assert!((power_heuristic(a, b) + power_heuristic(b, a) - 1.0).abs() < 1e-6, "{a} {b}");
        }
    }
}
