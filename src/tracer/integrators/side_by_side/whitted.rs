//! Whitted's integrator, step by step for all rays of a stream; without branches it is Phong's.
//!
//! It has no observer: the textbook's `whitted.rs` defines the result, and a test compares every bit.

use super::queue::{Found, Glass, Lit, Meeting, Mirror, Origin, Path, Queue, Sender};
use super::stream::RayStream;
use crate::integrators::common::media::{Media, enclosed, medium_before};
use crate::integrators::common::task::RayCounts;
use crate::integrators::common::view::{Appearance, View, appearance, shadow_ray};
use crate::lights::Light;
use crate::materials::Material;
use crate::materials::fresnel::{boundary, reflect, refract};
use crate::math::{DVec3, Departure, Ray, Side, Vec3};
use crate::sampling::PixelSampler;
use crate::scene::{IntegratorKind, Plan, Scene};
use crate::shapes::{Surface, ViewCones};

/// A scene made ready for streams of rays.
pub struct StreamTracer<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    glass: Media<'a>,
    /// The spheres as seen from each light source, where it may save work.
    from_lights: Vec<Option<ViewCones>>,
}

impl<'a> StreamTracer<'a> {
    /// Builds the view cones from each light source that shadow rays go to exactly.
    pub fn new(scene: &'a Scene, plan: &'a Plan) -> Self {
        // Rays with a mistake do not go to the light exactly.
        let exact = plan.shadow_rays && scene.integrator.mistake.is_none();
        let position = |light: &Light| light.position().filter(|_| exact);
        let from_lights = scene.lights.iter().map(|light| scene.shapes.view_cones(position(light)?)).collect();
        Self { scene, plan, glass: Media { scene, absorption: plan.absorption }, from_lights }
    }

    /// An empty stream for camera rays; `origin`, if all start at one point, allows view cones.
    pub fn stream(&self, origin: Option<DVec3>) -> RayStream {
        let Plan { integrator, reflection, refraction, .. } = *self.plan;
        let sends_on = integrator == IntegratorKind::Whitted && (reflection || refraction);
        let depth = if sends_on { self.scene.integrator.depth } else { 0 };
        RayStream::new(depth, origin.and_then(|origin| self.scene.shapes.view_cones(origin)))
    }

    /// Finds the radiance along all rays of a stream.
    pub fn trace(&self, stream: &mut RayStream, counts: &mut RayCounts) {
        stream.normalize();
        let RayStream { cones, samplers, queues } = stream;
        counts.camera += samplers.len() as u64;
        Pass { tracer: self, samplers, counts }.trace(cones.as_ref(), queues);
    }
}

/// A stream in progress.
struct Pass<'p, 'a> {
    tracer: &'p StreamTracer<'a>,
    /// For every ray of the camera.
    samplers: &'p mut [PixelSampler],
    counts: &'p mut RayCounts,
}

impl Pass<'_, '_> {
    /// Finds the radiance along the rays of the first queue; the others take the rays that are sent on. `cones` are those from
    /// the point that all rays of the first queue start at.
    fn trace(&mut self, cones: Option<&ViewCones>, queues: &mut [Queue]) {
        let Some((queue, deeper)) = queues.split_first_mut() else { return };
        self.settle(queue);
        self.tracer.scene.shapes.intersect_all(cones, queue.paths.iter().map(|path| &path.ray), &mut queue.hits);
        self.find_surfaces(queue);
        self.find_materials(queue);
        self.illuminate(&mut queue.found);
        self.follow_reflected(queue, deeper);
        self.follow_refracted(queue, deeper);
        let Found { radiances, transmittances, .. } = &mut queue.found;
        radiances.iter_mut().zip(transmittances).for_each(|(radiance, transmittance)| *radiance *= *transmittance);
    }

    /// Drops glasses that the rays are not inside of after all.
    fn settle(&self, queue: &mut Queue) {
        if !self.tracer.plan.refraction {
            return;
        }
        for path in queue.paths.iter_mut().filter(|path| path.media.is_nested()) {
            path.media = self.tracer.scene.shapes.settled(&path.media, &path.ray);
        }
    }

    /// Rays that meet nothing take the environment.
    fn find_surfaces(&mut self, queue: &mut Queue) {
        let StreamTracer { scene, plan, ref glass, .. } = *self.tracer;
        let Queue { paths, hits, meetings, found, .. } = queue;
        meetings.clear();
        found.clear(paths.len());
        if plan.absorption {
            found.transmittances.resize(paths.len(), Vec3::ONE);
        }
        for (number, (path, hit)) in paths.iter().zip(hits).enumerate() {
            if let Some(hit) = hit {
                scene.shapes.with_surface(&path.ray, hit, |surface| {
                    meetings.push(Meeting { path: number, distance: hit.t, surface });
                });
                continue;
            }
            self.counts.environment += 1;
            found.radiances[number] = scene.environment.radiance(path.ray.direction);
            if let Some(transmittance) = found.transmittances.get_mut(number) {
                *transmittance = glass.transmittance(|| path.media.innermost(), f64::INFINITY);
            }
        }
    }

    /// Sorts the surfaces by what has to be done about them.
    fn find_materials(&self, queue: &mut Queue) {
        let StreamTracer { scene, plan, ref glass, .. } = *self.tracer;
        let Queue { paths, meetings, found, .. } = queue;
        for Meeting { path: number, distance, surface } in meetings.iter() {
            let path = &paths[*number];
            let direction = path.ray.direction;
            let view = View::new(surface, direction);
            if let Some(transmittance) = found.transmittances.get_mut(*number) {
                *transmittance = glass.transmittance(|| medium_before(&path.media, surface, &view), *distance);
            }
            let Surface { position, id, material, .. } = *surface;
            let origin = Origin { path: *number, position, id, material, view };
            match &scene.materials[material as usize] {
                Material::Mirror { colour } if plan.reflection => {
                    found.mirrors.push(Mirror { origin, colour: colour.at(surface.texture) });
                }
                Material::Glass { .. } if plan.refraction => {
                    let met = enclosed(id, material);
                    let index_before = glass.index_inside(path.media.before(met, view.side));
                    let index_beyond = glass.index_inside(path.media.innermost_beyond(met, view.side));
                    let relative_index = index_before / index_beyond;
                    let boundary = boundary(-direction.dot(view.shading_normal), relative_index);
                    found.glasses.push(Glass { origin, relative_index, boundary });
                }
                material => match appearance(material, surface, &view, direction) {
                    Appearance::Own(_, colour) => found.radiances[*number] = colour,
                    Appearance::Reflecting(reflection) => found.lit.push(Lit { origin, reflection }),
                },
            }
        }
    }

    /// Adds the light of sources that surfaces reflect: light by light, each for all of them.
    fn illuminate(&mut self, found: &mut Found) {
        let StreamTracer { scene, plan, ref from_lights, .. } = *self.tracer;
        if !plan.direct_light || found.lit.is_empty() {
            return;
        }
        for (light, cones) in scene.lights.iter().zip(from_lights) {
            scene.shapes.stop.check();
            for Lit { origin, reflection } in &found.lit {
                if let Light::Ambient { radiance } = light {
                    found.radiances[origin.path] += reflection.diffuse * *radiance;
                    continue;
                }
                let Origin { position, view, .. } = origin;
                let Some(arriving) = light.illumination(*position) else { continue };
                let cosine = view.shading_normal.dot(arriving.to_light);
                if cosine <= 0.0 || view.normal.dot(arriving.to_light) <= 0.0 {
                    continue;
                }
                let ray = shadow_ray(scene.integrator.mistake, *position, origin.id, view.side, arriving.to_light);
                if plan.shadow_rays {
                    self.counts.shadow += 1;
                    if scene.shapes.occluded_from(cones.as_ref(), &ray, arriving.distance) {
                        continue;
                    }
                }
                let reflectance = reflection.reflectance(arriving.to_light);
                found.radiances[origin.path] += reflectance * arriving.irradiance * cosine as f32;
            }
        }
    }

    /// Adds what mirrors, and glass as far as it reflects, show.
    fn follow_reflected(&mut self, queue: &mut Queue, deeper: &mut [Queue]) {
        let Queue { paths, found, .. } = queue;
        clear_first(deeper);
        for Mirror { origin, colour } in &found.mirrors {
            let branch = Branch::reflected(paths, origin, *colour);
            self.follow(paths, found, origin, branch, deeper.first_mut());
        }
        for Glass { origin, boundary, .. } in found.glasses.iter().filter(|_| self.tracer.plan.reflection) {
            if boundary.reflectance > 0.0 {
                let branch = Branch::reflected(paths, origin, Vec3::splat(boundary.reflectance as f32));
                self.follow(paths, found, origin, branch, deeper.first_mut());
            }
        }
        self.gather(&mut found.radiances, deeper);
    }

    /// Adds what glass lets through.
    fn follow_refracted(&mut self, queue: &mut Queue, deeper: &mut [Queue]) {
        let Queue { paths, found, .. } = queue;
        clear_first(deeper);
        for glass in found.glasses.iter().filter(|glass| glass.boundary.cos_transmitted.is_some()) {
            let branch = Branch::refracted(paths, glass);
            self.follow(paths, found, &glass.origin, branch, deeper.first_mut());
        }
        self.gather(&mut found.radiances, deeper);
    }

    /// Traces the rays that were sent on and adds what they bring back to the rays that they come from.
    fn gather(&mut self, radiances: &mut [Vec3], deeper: &mut [Queue]) {
        if deeper.first().is_none_or(|next| next.paths.is_empty()) {
            return;
        }
        self.trace(None, deeper);
        let next = &deeper[0];
        for (sender, &radiance) in next.senders.iter().zip(&next.found.radiances) {
            radiances[sender.path] += sender.factor * radiance;
        }
    }

    /// Follows a branch, unless depth (there is no next queue) or weight end it.
    #[inline(always)]
    fn follow(&mut self, paths: &[Path], found: &Found, origin: &Origin, branch: Branch, next: Option<&mut Queue>) {
        let Some(next) = next else {
            self.counts.cut_by_depth += 1;
            return;
        };
        let Branch { direction, side, factor } = branch;
        let path = &paths[origin.path];
        let weight = path.weight * found.transmittance(origin.path) * factor;
        let Some(survival) = self.survival(weight.max_element(), path.camera_ray) else {
            self.counts.cut_by_weight += 1;
            return;
        };
        let departure = Departure { surface: origin.id, side };
        let ray = Ray { origin: origin.position, direction, departure: Some(departure) };
        next.push(ray, weight / survival, path.camera_ray, path.media);
        next.senders.push(Sender { path: origin.path, factor: factor / survival });
        if side == origin.view.side {
            self.counts.reflected += 1;
        } else {
            self.counts.refracted += 1;
            let met = enclosed(origin.id, origin.material);
            next.paths.last_mut().into_iter().for_each(|sent| sent.media.pass(met, origin.view.side));
        }
    }

    /// The probability with which a branch of this weight is followed; `None` if chance ends it.
    #[inline(always)]
    fn survival(&mut self, weight: f32, camera_ray: usize) -> Option<f32> {
        let cutoff = self.tracer.scene.integrator.weight_cutoff;
        if !self.tracer.plan.roulette || weight >= cutoff {
            return Some(1.0);
        }
        let probability = weight / cutoff;
        (self.samplers[camera_ray].uniform() < probability).then_some(probability)
    }
}

/// One of the rays that a mirror or glass sends on.
struct Branch {
    direction: DVec3,
    /// The side of the surface it leaves on.
    side: Side,
    /// What its radiance counts for the ray that it comes from.
    factor: Vec3,
}

impl Branch {
    #[inline(always)]
    fn reflected(paths: &[Path], origin: &Origin, factor: Vec3) -> Self {
        let View { side, normal, shading_normal } = origin.view;
        let direction = reflect(paths[origin.path].ray.direction, shading_normal);
        Self { direction: on_side(direction, normal), side, factor }
    }

    #[inline(always)]
    fn refracted(paths: &[Path], glass: &Glass) -> Self {
        let View { side, normal, shading_normal } = glass.origin.view;
        let direction = refract(paths[glass.origin.path].ray.direction, shading_normal, glass.relative_index);
        let factor = Vec3::splat(1.0 - glass.boundary.reflectance as f32);
        Self { direction: on_side(direction, -normal), side: side.opposite(), factor }
    }
}

fn clear_first(queues: &mut [Queue]) {
    queues.first_mut().into_iter().for_each(Queue::clear);
}

/// A direction that an interpolated normal sent to the wrong side of the true surface, moved into the surface.
#[inline(always)]
fn on_side(direction: DVec3, normal: DVec3) -> DVec3 {
    let height = direction.dot(normal);
    if height >= 0.0 { direction } else { (direction - normal * height).normalize() }
}
