//! The rays that mirrors and glass send on.

use super::super::media::{Media, enclosed};
use super::super::observer::{Event, Observer, RayKind};
use super::super::view::{Vertex, View};
use super::Tracer;
use super::level::{Found, Level, Path, Sender};
use crate::materials::fresnel::{Boundary, boundary, reflect, refract};
use crate::math::{DVec3, Departure, Ray, Side, Vec3};

/// A mirror that a ray met.
pub struct Mirror {
    pub vertex: Vertex,
    pub factor: Vec3,
}

/// A glass that a ray met.
pub struct Glass {
    vertex: Vertex,
    index_before: f64,
    index_beyond: f64,
    boundary: Boundary,
}

impl Glass {
    /// A glass that a ray met.
    #[inline(always)]
    pub fn new(vertex: Vertex, path: &Path, media_of: &Media) -> Self {
        let Vertex { id, material, view: View { side, shading_normal, .. }, .. } = vertex;
        let met = enclosed(id, material);
        let index_before = media_of.index_inside(path.media.before(met, side));
        let index_beyond = media_of.index_inside(path.media.innermost_beyond(met, side));
        let boundary = boundary(-path.ray.direction.dot(shading_normal), index_before / index_beyond);
        Self { vertex, index_before, index_beyond, boundary }
    }

    /// What an observer is told of it.
    pub fn event(&self) -> Event {
        Event::Fresnel {
            index_before: self.index_before,
            index_beyond: self.index_beyond,
            reflectance: self.boundary.reflectance,
            cos_transmitted: self.boundary.cos_transmitted,
        }
    }

    /// The reflected branch; `None` if all light passes.
    #[inline(always)]
    fn reflected(&self, direction: DVec3) -> Option<Branch> {
        let reflectance = self.boundary.reflectance;
        (reflectance > 0.0).then(|| Branch::reflected(direction, &self.vertex, Vec3::splat(reflectance as f32)))
    }

    /// The refracted branch; `None` if all light is reflected.
    #[inline(always)]
    fn refracted(&self, direction: DVec3) -> Option<Branch> {
        self.boundary.cos_transmitted?;
        let View { side, normal, shading_normal } = self.vertex.view;
        let refracted = refract(direction, shading_normal, self.index_before / self.index_beyond);
        Some(Branch {
            kind: RayKind::Refracted,
            direction: on_side(refracted, -normal),
            side: side.opposite(),
            factor: Vec3::splat(1.0 - self.boundary.reflectance as f32),
        })
    }
}

/// One branch at a specular surface.
struct Branch {
    kind: RayKind,
    direction: DVec3,
    side: Side,
    /// Factor on the radiance that comes back.
    factor: Vec3,
}

impl Branch {
    /// What a mirror sends on.
    #[inline(always)]
    fn reflected(direction: DVec3, vertex: &Vertex, factor: Vec3) -> Self {
        let View { side, normal, shading_normal } = vertex.view;
        let direction = on_side(reflect(direction, shading_normal), normal);
        Self { kind: RayKind::Reflected, direction, side, factor }
    }
}

impl<O: Observer> Tracer<'_, O> {
    /// Adds what mirrors, and glass as far as it reflects, show.
    pub(super) fn follow_reflected(&mut self, depth: u32, level: &mut Level, deeper: &mut [Level]) {
        let Level { paths, found, .. } = level;
        let mut next = deeper.first_mut();
        next.iter_mut().for_each(|next| next.clear());
        for Mirror { vertex, factor } in &found.mirrors {
            let branch = Branch::reflected(paths[vertex.path].ray.direction, vertex, *factor);
            self.follow(depth, paths, found, vertex, branch, next.as_deref_mut());
        }
        for glass in found.glasses.iter().filter(|_| self.plan.reflection) {
            if let Some(branch) = glass.reflected(paths[glass.vertex.path].ray.direction) {
                self.follow(depth, paths, found, &glass.vertex, branch, next.as_deref_mut());
            }
        }
        self.gather(depth, &mut found.radiances, deeper);
    }

    /// Adds what glass lets through.
    pub(super) fn follow_refracted(&mut self, depth: u32, level: &mut Level, deeper: &mut [Level]) {
        let Level { paths, found, .. } = level;
        let mut next = deeper.first_mut();
        next.iter_mut().for_each(|next| next.clear());
        for glass in &found.glasses {
            if let Some(branch) = glass.refracted(paths[glass.vertex.path].ray.direction) {
                self.follow(depth, paths, found, &glass.vertex, branch, next.as_deref_mut());
            }
        }
        self.gather(depth, &mut found.radiances, deeper);
    }

    /// Traces the rays that were sent on and adds what they bring back to the rays that they come from.
    fn gather(&mut self, depth: u32, radiances: &mut [Vec3], deeper: &mut [Level]) {
        if deeper.first().is_none_or(|next| next.paths.is_empty()) {
            return;
        }
        self.trace(depth + 1, None, deeper);
        let next = &deeper[0];
        for (sender, &radiance) in next.senders.iter().zip(&next.found.radiances) {
            radiances[sender.path] += sender.factor * radiance;
        }
    }

    /// Follows a branch, unless depth or weight end it.
    #[inline(always)]
    fn follow(
        &mut self,
        depth: u32,
        paths: &[Path],
        found: &Found,
        vertex: &Vertex,
        branch: Branch,
        next: Option<&mut Level>,
    ) {
        let Branch { kind, direction, side, factor } = branch;
        let Some(next) = next else {
            self.counts.cut_by_depth += 1;
            self.observer.note(|| Event::CutByDepth { kind, depth });
            return;
        };
        let path = &paths[vertex.path];
        let weight = path.weight * found.transmittance(vertex.path) * factor;
        let Some(survival) = self.survival(weight.max_element(), path.lane) else {
            self.counts.cut_by_weight += 1;
            self.observer.note(|| Event::CutByWeight { kind, weight: weight.max_element() });
            return;
        };
        let departure = Departure { surface: vertex.id, side };
        let ray = Ray { origin: vertex.position, direction, departure: Some(departure) };
        let factor = factor / survival;
        self.observer.note(|| Event::Ray { kind, ray, factor });
        next.push(ray, weight / survival, path.lane, path.media);
        next.senders.push(Sender { path: vertex.path, factor });
        if kind == RayKind::Refracted {
            self.counts.refracted += 1;
            let met = enclosed(vertex.id, vertex.material);
            next.paths.last_mut().into_iter().for_each(|sent| sent.media.pass(met, vertex.view.side));
        } else {
            self.counts.reflected += 1;
        }
    }

    /// Probability with which a branch of this weight is followed, if the dice let it live.
    #[inline(always)]
    fn survival(&mut self, weight: f32, lane: usize) -> Option<f32> {
        let cutoff = self.scene.integrator.weight_cutoff;
        if !self.plan.roulette || weight >= cutoff {
            return Some(1.0);
        }
        let probability = weight / cutoff;
        (self.samplers[lane].uniform() < probability).then_some(probability)
    }
}

/// A direction that an interpolated normal sent below the true surface is laid into it.
#[inline(always)]
fn on_side(direction: DVec3, normal: DVec3) -> DVec3 {
    let height = direction.dot(normal);
    if height >= 0.0 { direction } else { (direction - normal * height).normalize() }
}
