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
//!
//! Without branches (a plan for Phong's integrator has none) it is local light alone.

mod branch;
mod level;

use super::RayCounts;
use super::direct::{self, Appearance, appearance};
use super::media::{Media, medium_before};
use super::observer::{Event, Observer};
use super::view::{Vertex, View};
use crate::materials::Material;
use crate::math::Vec3;
use crate::sampling::PixelSampler;
use crate::scene::{Plan, Scene};
use crate::shapes::{Outlook, Surface};
use branch::{Glass, Mirror};
pub(super) use level::Level;
use level::{Found, Meeting, Path};

/// Whitted's integrator at work.
pub(super) struct Tracer<'a, O> {
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    /// The view from each light source, where it may save work.
    pub outlooks: &'a [Option<Outlook>],
    pub media_of: Media<'a>,
    /// For every ray of the camera.
    pub samplers: &'a mut [PixelSampler],
    pub counts: &'a mut RayCounts,
    pub observer: &'a mut O,
}

impl<O: Observer> Tracer<'_, O> {
    /// Finds what the rays of the first level bring back; the others take the rays that are sent on. There may be an outlook
    /// from the point that all rays of the first level start at.
    pub fn trace(&mut self, depth: u32, outlook: Option<&Outlook>, levels: &mut [Level]) {
        let Some((level, deeper)) = levels.split_first_mut() else { return };
        self.settle(level);
        self.scene.shapes.intersect_all(level.paths.iter().map(|path| &path.ray), outlook, &mut level.hits);
        self.find_surfaces(level);
        self.find_materials(level);
        direct::illuminate(
            self.scene,
            self.plan,
            self.outlooks,
            &level.found.lit,
            &mut level.found.radiances,
            self.counts,
            self.observer,
        );
        self.follow_reflected(depth, level, deeper);
        self.follow_refracted(depth, level, deeper);
        let Found { radiances, transmittances, .. } = &mut level.found;
        radiances.iter_mut().zip(transmittances).for_each(|(radiance, transmittance)| *radiance *= *transmittance);
        for &radiance in radiances.iter() {
            self.observer.note(|| Event::End { radiance: Some(radiance) });
        }
    }

    /// Drops glasses that the rays are not inside of after all.
    fn settle(&self, level: &mut Level) {
        if !self.plan.refraction {
            return;
        }
        for path in level.paths.iter_mut().filter(|path| path.media.is_nested()) {
            path.media = self.scene.shapes.settled(&path.media, &path.ray);
        }
    }

    /// Rays that meet nothing take the environment.
    fn find_surfaces(&mut self, level: &mut Level) {
        let Level { paths, hits, meetings, found, .. } = level;
        meetings.clear();
        found.clear(paths.len());
        if self.plan.absorption {
            found.transmittances.resize(paths.len(), Vec3::ONE);
        }
        for (number, (path, hit)) in paths.iter().zip(hits).enumerate() {
            match hit {
                Some(hit) => self.scene.shapes.with_surface(&path.ray, hit, |surface| {
                    meetings.push(Meeting { path: number, distance: hit.t, surface });
                }),
                None => found.radiances[number] = self.environment(number, path, &mut found.transmittances),
            }
        }
    }

    /// What a ray that meets nothing finds.
    #[inline(always)]
    fn environment(&mut self, number: usize, path: &Path, transmittances: &mut [Vec3]) -> Vec3 {
        self.counts.environment += 1;
        let direction = path.ray.direction;
        let environment = self.scene.environment.radiance(direction);
        // An unbounded way through absorbing glass lets nothing through.
        let transmittance = self.media_of.transmittance(|| path.media.innermost(), f64::INFINITY);
        if let Some(known) = transmittances.get_mut(number) {
            *known = transmittance;
        }
        self.observer.note(|| Event::Missed { direction, environment, transmittance });
        environment
    }

    /// Sorts the surfaces by what has to be done about them.
    fn find_materials(&mut self, level: &mut Level) {
        let Level { paths, meetings, found, .. } = level;
        for Meeting { path: number, distance, surface } in meetings.iter() {
            let path = &paths[*number];
            let direction = path.ray.direction;
            let view = View::new(surface, direction);
            let transmittance = self.media_of.transmittance(|| medium_before(&path.media, surface, &view), *distance);
            if let Some(known) = found.transmittances.get_mut(*number) {
                *known = transmittance;
            }
            self.observer.note(|| view.hit(surface, &path.ray, *distance, transmittance));
            let Surface { position, id, material, .. } = *surface;
            let vertex = Vertex { path: *number, position, id, material, view };
            match &self.scene.materials[material as usize] {
                Material::Mirror { colour } if self.plan.reflection => {
                    found.mirrors.push(Mirror { vertex, factor: colour.at(surface.texture_coordinates) });
                }
                Material::Glass { .. } if self.plan.refraction => {
                    let glass = Glass::new(vertex, path, &self.media_of);
                    self.observer.note(|| glass.event());
                    found.glasses.push(glass);
                }
                material => match appearance(material, surface, &view, direction) {
                    Appearance::Own(what, colour) => {
                        self.observer.note(|| Event::Own { what, colour });
                        found.radiances[*number] = colour;
                    }
                    Appearance::Reflecting(reflection) => found.lit.push(direct::Lit { vertex, reflection }),
                },
            }
        }
    }
}
