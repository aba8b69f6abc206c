//! Whitted's ray tracing: local light, and both branches at mirrors and glass.
//!
//! ```text
//!            \   |   / reflected          L(ray) = environment                             if it hits nothing
//!     camera  \  |  /                            = T  colour L(reflected)                   at a mirror
//!              \ | /                             = T (R L(reflected) + (1 - R) L(refracted)) at glass
//!     ----------\|/----------                    = T  light of the sources                  elsewhere
//!                 \
//!                  \ refracted            R: Fresnel's reflectance    T: what glass on the way leaves of the light
//! ```
//!
//! A branch whose share of the pixel falls below the cut-off is followed with probability share / cut-off and then stands
//! for those that were not: noise, but no bias (Russian roulette: Arvo and Kirk, Particle Transport and Image Synthesis,
//! 1990). (Whitted, An Improved Illumination Model for Shaded Display, 1980; Pharr, Jakob and Humphreys, Physically Based
//! Rendering, 4th edition, section 1.2; Shirley and Marschner, Fundamentals of Computer Graphics, chapter "Ray Tracing".)

use super::phong;
use crate::integrators::common::media::{Media, medium_before, medium_beyond, pass};
use crate::integrators::common::observer::{Event, Observer, RayKind};
use crate::integrators::common::task::Task;
use crate::integrators::common::view::View;
use crate::materials::fresnel::{boundary, reflect, refract};
use crate::materials::{Material, MediumStack};
use crate::math::{DVec3, Departure, Ray, Side, Vec3};
use crate::shapes::Surface;

/// A ray from the camera.
pub struct Path {
    pub ray: Ray,
    /// The glasses that the ray is inside of.
    pub media: MediumStack,
    /// Share of the pixel that the ray's radiance counts for.
    pub weight: Vec3,
    /// Reflections and refractions so far.
    pub depth: u32,
}

/// The radiance along a ray.
pub fn radiance<O: Observer>(task: &mut Task<O>, path: &Path) -> Vec3 {
    let (scene, ray) = (task.scene, &path.ray);
    let glass = Media { scene, absorption: task.plan.absorption };
    let media = scene.shapes.settled(&path.media, ray);

    // Nothing is hit: the environment.
    let Some(hit) = scene.shapes.intersect(ray) else {
        let environment = scene.environment.radiance(ray.direction);
        let transmittance = glass.transmittance(|| media.innermost(), f64::INFINITY);
        task.counts.environment += 1;
        task.observer.note(|| Event::Missed { direction: ray.direction, environment, transmittance });
        return end(task, environment * transmittance);
    };

    // The surface, and the transmittance of the glass before it.
    let surface = scene.shapes.surface(ray, &hit);
    let view = View::new(&surface, ray.direction);
    let transmittance = glass.transmittance(|| medium_before(&media, &surface, &view), hit.t);
    task.observer.note(|| view.hit(&surface, ray, hit.t, transmittance));

    // What the surface shows.
    let arrived = Path { media, weight: path.weight * transmittance, ..*path };
    let radiance = match &scene.materials[surface.material as usize] {
        Material::Mirror { colour } if task.plan.reflection => {
            reflected(task, &arrived, &surface, &view, colour.at(surface.texture))
        }
        Material::Glass { .. } if task.plan.refraction => through_glass(task, &arrived, &surface, &view, &glass),
        _ => phong::shade(task, ray, &surface, &view),
    };
    end(task, radiance * transmittance)
}

/// What a mirror shows, or glass as far as it reflects: `factor` times the radiance of the reflected ray.
fn reflected<O: Observer>(task: &mut Task<O>, path: &Path, surface: &Surface, view: &View, factor: Vec3) -> Vec3 {
    let direction = on_side(reflect(path.ray.direction, view.shading_normal), view.normal);
    let branch = Branch { kind: RayKind::Reflected, direction, side: view.side, media: path.media, factor };
    follow(task, path, surface, branch)
}

/// What glass shows: both branches, weighted by Fresnel's R and 1 - R.
fn through_glass<O: Observer>(task: &mut Task<O>, path: &Path, surface: &Surface, view: &View, glass: &Media) -> Vec3 {
    let index_before = glass.index_inside(medium_before(&path.media, surface, view));
    let index_beyond = glass.index_inside(medium_beyond(&path.media, surface, view));
    let relative_index = index_before / index_beyond;
    let boundary = boundary(-path.ray.direction.dot(view.shading_normal), relative_index);
    let (reflectance, cos_transmitted) = (boundary.reflectance, boundary.cos_transmitted);
    task.observer.note(|| Event::Fresnel { index_before, index_beyond, reflectance, cos_transmitted });

    let mut radiance = Vec3::ZERO;
    if task.plan.reflection && reflectance > 0.0 {
        radiance += reflected(task, path, surface, view, Vec3::splat(reflectance as f32));
    }
    // Under total reflection nothing passes.
    if cos_transmitted.is_some() {
        let direction = on_side(refract(path.ray.direction, view.shading_normal, relative_index), -view.normal);
        let mut media = path.media;
        pass(&mut media, surface, view);
        let factor = Vec3::splat(1.0 - reflectance as f32);
        let branch = Branch { kind: RayKind::Refracted, direction, side: view.side.opposite(), media, factor };
        radiance += follow(task, path, surface, branch);
    }
    radiance
}

/// One of the rays that a mirror or glass sends on.
struct Branch {
    kind: RayKind,
    direction: DVec3,
    /// The side of the surface it leaves on.
    side: Side,
    media: MediumStack,
    /// What its radiance counts for the ray that it comes from.
    factor: Vec3,
}

/// Follows a branch, unless depth or weight end it.
fn follow<O: Observer>(task: &mut Task<O>, path: &Path, surface: &Surface, branch: Branch) -> Vec3 {
    let Branch { kind, direction, side, media, factor } = branch;
    let depth = path.depth;
    if depth >= task.scene.integrator.depth {
        task.counts.cut_by_depth += 1;
        task.observer.note(|| Event::CutByDepth { kind, depth });
        return Vec3::ZERO;
    }
    let weight = path.weight * factor;
    let Some(survival) = survival(task, weight.max_element()) else {
        task.counts.cut_by_weight += 1;
        task.observer.note(|| Event::CutByWeight { kind, weight: weight.max_element() });
        return Vec3::ZERO;
    };
    let departure = Some(Departure { surface: surface.id, side });
    let (ray, factor) = (Ray { origin: surface.position, direction, departure }, factor / survival);
    *(if kind == RayKind::Refracted { &mut task.counts.refracted } else { &mut task.counts.reflected }) += 1;
    task.observer.note(|| Event::Ray { kind, ray, factor });
    factor * radiance(task, &Path { ray, media, weight: weight / survival, depth: depth + 1 })
}

/// The probability with which a branch of this weight is followed; `None` if chance ends it.
fn survival<O>(task: &mut Task<O>, weight: f32) -> Option<f32> {
    let cutoff = task.scene.integrator.weight_cutoff;
    if !task.plan.roulette || weight >= cutoff {
        return Some(1.0);
    }
    let probability = weight / cutoff;
    (task.sampler.uniform() < probability).then_some(probability)
}

/// A direction that an interpolated normal sent to the wrong side of the true surface, moved into the surface.
fn on_side(direction: DVec3, normal: DVec3) -> DVec3 {
    let height = direction.dot(normal);
    if height >= 0.0 { direction } else { (direction - normal * height).normalize() }
}

fn end<O: Observer>(task: &mut Task<O>, radiance: Vec3) -> Vec3 {
    task.observer.note(|| Event::End { radiance: Some(radiance) });
    radiance
}
