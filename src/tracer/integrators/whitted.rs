//! Whitted's ray tracing: local light, and both branches at mirrors and glass
//! (Whitted, An Improved Illumination Model for Shaded Display, 1980).
//!
//! ```text
//!            \   |   / reflected, weight R         The branches are weighted by Fresnel's R and 1 - R.
//!     camera  \  |  /                              A branch whose share of the pixel falls below the cut-off
//!              \ | /                               is followed with probability share / cut-off and then
//!     ----------\|/----------                      stands for those that were not: noise, but no bias.
//!                 \ refracted, weight 1 - R
//! ```

use super::direct::{View, local_radiance};
use super::media::{Media, beyond, medium_before};
use super::observer::{Event, Observer, RayKind};
use super::{RayCounts, Task};
use crate::materials::fresnel::{boundary, reflect, refract};
use crate::materials::{Material, MediumStack};
use crate::math::{DVec3, Departure, Ray, Side, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{Plan, Scene};
use crate::shapes::Surface;

/// Radiance along a camera ray.
pub(super) fn radiance<O: Observer>(task: Task<O>, ray: &Ray, media: &MediumStack) -> Vec3 {
    let Task { scene, plan, sampler, counts, observer } = task;
    let media_of = Media { scene, absorption: plan.absorption };
    let mut tracer = Tracer { scene, plan, media_of, sampler, counts, observer };
    tracer.radiance(&Path { ray: *ray, depth: 0, weight: Vec3::ONE, media })
}

/// A ray on its way, with what it carries.
struct Path<'a> {
    ray: Ray,
    /// Reflections and refractions so far.
    depth: u32,
    /// Share of the pixel that this ray's radiance counts for, by channel.
    weight: Vec3,
    /// The glasses the ray is inside of.
    media: &'a MediumStack,
}

/// One branch at a specular surface.
struct Branch<'a> {
    /// True for refraction: the ray passes the surface.
    passes: bool,
    direction: DVec3,
    side: Side,
    /// Factor on the radiance that comes back.
    factor: Vec3,
    media: &'a MediumStack,
}

struct Tracer<'a, O> {
    scene: &'a Scene,
    plan: &'a Plan,
    media_of: Media<'a>,
    sampler: &'a mut PixelSampler,
    counts: &'a mut RayCounts,
    observer: &'a mut O,
}

impl<O: Observer> Tracer<'_, O> {
    fn radiance(&mut self, path: &Path<'_>) -> Vec3 {
        let radiance = self.found_radiance(path);
        self.observer.note(|| Event::End { radiance: Some(radiance) });
        radiance
    }

    /// What the ray brings back.
    #[inline(always)]
    fn found_radiance(&mut self, path: &Path<'_>) -> Vec3 {
        let scene = self.scene;
        if path.media.is_nested() {
            let media = scene.shapes.settled(path.media, &path.ray);
            if media != *path.media {
                return self.radiance(&Path { media: &media, ..*path });
            }
        }
        let Some(hit) = scene.shapes.intersect(&path.ray) else {
            self.counts.environment += 1;
            let radiance = scene.environment.radiance(path.ray.direction);
            // An unbounded way through absorbing glass lets nothing through.
            let transmittance = self.media_of.transmittance(|| path.media.innermost(), f64::INFINITY);
            let direction = path.ray.direction;
            self.observer.note(|| Event::Missed { direction, environment: radiance, transmittance });
            return transmittance * radiance;
        };
        let surface = scene.shapes.surface(&path.ray, &hit);
        let view = View::new(&surface, path.ray.direction);
        let transmittance = self.media_of.transmittance(|| medium_before(path.media, &surface, &view), hit.t);
        self.observer.note(|| view.hit(&surface, &path.ray, hit.t, transmittance));
        let radiance = match &scene.materials[surface.material as usize] {
            Material::Mirror { colour } if self.plan.reflection => {
                self.reflected(path, &surface, &view, colour.at(surface.texture_coordinates), transmittance)
            }
            Material::Glass { .. } if self.plan.refraction => self.refracted(path, &surface, &view, transmittance),
            _ => local_radiance(scene, self.plan, &path.ray, &surface, &view, self.counts, self.observer),
        };
        transmittance * radiance
    }

    /// What a mirror shows.
    fn reflected(
        &mut self,
        path: &Path<'_>,
        surface: &Surface,
        view: &View,
        factor: Vec3,
        transmittance: Vec3,
    ) -> Vec3 {
        let direction = mirror_direction(path.ray.direction, view);
        self.follow(
            path,
            surface,
            transmittance,
            Branch { passes: false, direction, side: view.side, factor, media: path.media },
        )
    }

    /// What a glass shows: reflection and refraction.
    #[inline(never)]
    fn refracted(&mut self, path: &Path<'_>, surface: &Surface, view: &View, transmittance: Vec3) -> Vec3 {
        let beyond = beyond(path.media, surface, view);
        let from = self.media_of.index_inside(medium_before(path.media, surface, view));
        let towards = self.media_of.index_inside(beyond.innermost());
        let relative_index = from / towards;
        let direction = path.ray.direction;
        let cos_incident = -direction.dot(view.shading_normal);
        let boundary = boundary(cos_incident, relative_index);
        self.observer.note(|| Event::Fresnel {
            index_before: from,
            index_beyond: towards,
            reflectance: boundary.reflectance,
            cos_transmitted: boundary.cos_transmitted,
        });
        let reflectance = Vec3::splat(boundary.reflectance as f32);
        let mut radiance = Vec3::ZERO;
        if self.plan.reflection && boundary.reflectance > 0.0 {
            radiance += self.reflected(path, surface, view, reflectance, transmittance);
        }
        if boundary.cos_transmitted.is_some() {
            let refracted = refract(direction, view.shading_normal, relative_index);
            let branch = Branch {
                passes: true,
                direction: on_side(refracted, -view.normal),
                side: view.side.opposite(),
                factor: Vec3::ONE - reflectance,
                media: &beyond,
            };
            radiance += self.follow(path, surface, transmittance, branch);
        }
        radiance
    }

    /// Follows a branch, unless depth or weight end it.
    fn follow(&mut self, path: &Path<'_>, surface: &Surface, transmittance: Vec3, branch: Branch<'_>) -> Vec3 {
        let kind = if branch.passes { RayKind::Refracted } else { RayKind::Reflected };
        if path.depth >= self.scene.integrator.depth {
            self.counts.cut_by_depth += 1;
            self.observer.note(|| Event::CutByDepth { kind, depth: path.depth });
            return Vec3::ZERO;
        }
        let weight = path.weight * transmittance * branch.factor;
        let Some(survival) = self.survival(weight.max_element()) else {
            self.counts.cut_by_weight += 1;
            self.observer.note(|| Event::CutByWeight { kind, weight: weight.max_element() });
            return Vec3::ZERO;
        };
        let count = if branch.passes { &mut self.counts.refracted } else { &mut self.counts.reflected };
        *count += 1;
        let departure = Departure { surface: surface.id, side: branch.side };
        let ray = Ray { origin: surface.position, direction: branch.direction, departure: Some(departure) };
        let next = Path { ray, depth: path.depth + 1, weight: weight / survival, media: branch.media };
        let factor = branch.factor / survival;
        self.observer.note(|| Event::Ray { kind, ray, factor });
        factor * self.radiance(&next)
    }

    /// Probability with which a branch of this weight is followed, if the dice let it live.
    fn survival(&mut self, weight: f32) -> Option<f32> {
        let cutoff = self.scene.integrator.weight_cutoff;
        if !self.plan.roulette || weight >= cutoff {
            return Some(1.0);
        }
        let probability = weight / cutoff;
        (self.sampler.uniform() < probability).then_some(probability)
    }
}

/// The mirrored direction, kept on the ray's side of the true surface.
fn mirror_direction(direction: DVec3, view: &View) -> DVec3 {
    on_side(reflect(direction, view.shading_normal), view.normal)
}

/// A direction that an interpolated normal sent below the true surface is laid into it.
fn on_side(direction: DVec3, normal: DVec3) -> DVec3 {
    let height = direction.dot(normal);
    if height >= 0.0 { direction } else { (direction - normal * height).normalize() }
}
