//! Bundles: rays of the camera that are traced side by side.
//!
//! ```text
//!     one by one      hit surface light  hit surface light  hit surface light
//!     side by side    hit hit hit  surface surface surface  light light light
//! ```
//!
//! The steps of one ray wait for each other: the point for the distance, the light for the point. Those of several rays do
//! not, and the processor works on several of them at once.

use super::whitted::Level;
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::sampling::PixelSampler;
use crate::shapes::Outlook;

/// Rays that set out from the camera together, room for what is found on the way, and their radiance.
///
/// Every ray brings the same bits back as if it were alone.
pub struct Bundle {
    /// The view from the point that all rays start at, if there is one and it may save work.
    pub(super) outlook: Option<Outlook>,
    pub(super) samplers: Vec<PixelSampler>,
    /// The rays of the camera, then by depth those that they send on.
    pub(super) levels: Vec<Level>,
}

impl Bundle {
    /// An empty bundle whose rays may be sent on so many times, by the outlook from where they all start, if there is one.
    pub(super) fn new(depth: u32, outlook: Option<Outlook>) -> Self {
        Self { outlook, samplers: Vec::new(), levels: (0..=depth).map(|_| Level::default()).collect() }
    }

    /// Removes all rays.
    pub fn clear(&mut self) {
        self.samplers.clear();
        self.levels[0].clear();
    }

    /// Adds a ray of the camera along a direction of any length, with the glasses around its origin, and the sampler that
    /// delivers its random decisions.
    #[inline]
    pub fn push(&mut self, origin: DVec3, towards: DVec3, media: &MediumStack, sampler: PixelSampler) {
        // A view from elsewhere says nothing.
        self.outlook.take_if(|outlook| outlook.point() != origin);
        let lane = self.samplers.len();
        self.samplers.push(sampler);
        self.levels[0].push(Ray::new(origin, towards), Vec3::ONE, lane, *media);
    }

    /// Makes the directions of all rays unit vectors: in a loop of its own, where the processor takes several square roots
    /// at once.
    pub(super) fn normalize(&mut self) {
        self.levels[0].paths.iter_mut().for_each(|path| path.ray.direction = path.ray.direction.normalize());
    }

    /// Traces the rays one by one.
    #[inline(always)]
    pub(super) fn each(&mut self, mut radiance: impl FnMut(&Ray, &MediumStack, &mut PixelSampler) -> Vec3) {
        let Level { paths, found, .. } = &mut self.levels[0];
        found.radiances.clear();
        let rays = paths.iter().zip(&mut self.samplers);
        found.radiances.extend(rays.map(|(path, sampler)| radiance(&path.ray, &path.media, sampler)));
    }

    /// The camera's rays, of unit directions once they are traced.
    pub fn rays(&self) -> impl ExactSizeIterator<Item = &Ray> {
        self.levels[0].paths.iter().map(|path| &path.ray)
    }

    /// What they brought back, once they are traced.
    pub fn radiances(&self) -> &[Vec3] {
        &self.levels[0].found.radiances
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::{Integrator, RayCounts};
    use super::*;
    use crate::scene::{Plan, Scene};

    /// Mirrors, glass in glass, highlights and shadows of three kinds of light, of shapes tried one by one.
    const SCENE: &str = r#"
        camera = { position = [0, 1, 6], target = [0, 1, 0], up = [0, 1, 0], size = [24, 16] }
        environment = { kind = "gradient", zenith = [0.2, 0.4, 0.9], horizon = [1, 0.9, 0.8], up = "+y" }
        integrator = { weight_cutoff = 0.1 }
        materials.floor = { kind = "lambert", colour = { checker = [0.3, 0.6], repeat = 1 } }
        materials.glass = { kind = "glass", absorption = [0.4, 0.1, 0.2] }
        materials.mirror = { kind = "mirror", colour = 0.9 }
        materials.shiny = { kind = "phong", diffuse = 0.5, specular = 0.4, exponent = 30 }
        lights = [
            { kind = "point", position = [-4, 6, 5], intensity = 40 },
            { kind = "directional", direction = [1, -2, -1], irradiance = 1 },
            { kind = "spot", position = [3, 5, 3], target = [0, 0, 0], intensity = 20, angle = 25, inner_angle = 10 },
            { kind = "ambient", radiance = 0.1 },
        ]
        shapes = [
            { kind = "plane", normal = [0, 1, 0], material = "floor" },
            { kind = "sphere", centre = [-1.2, 1, 0], material = "glass" },
            { kind = "sphere", centre = [-1.2, 1, 0], radius = 0.5, material = "glass" },
            { kind = "sphere", centre = [1.2, 1, 0], material = "mirror" },
            { kind = "box", minimum = [-0.3, 0, 1], maximum = [0.3, 0.6, 1.6], material = "shiny" },
        ]
    "#;

    #[test]
    fn every_ray_brings_the_same_back_as_if_it_were_alone() {
        let scene = Scene::from_text(SCENE, Path::new("bundle.toml")).unwrap();
        let plan = Plan::new(&scene);
        let integrator = Integrator::new(&scene, &plan).unwrap();
        let media = integrator.media_around(scene.camera.position());
        let [width, height] = scene.camera.size();
        let (mut bundle, mut together, mut alone) =
            (integrator.bundle(Some(scene.camera.position())), RayCounts::default(), RayCounts::default());
        for y in 0..height {
            let sampler = |x: usize| PixelSampler::new(x, y, 0);
            let ray = |x: usize| scene.camera.ray(x as f64 + 0.5, y as f64 + 0.5);
            bundle.clear();
            (0..width).for_each(|x| bundle.push(ray(x).origin, ray(x).direction, &media, sampler(x)));
            integrator.trace(&mut bundle, &mut together);
            let singly: Vec<_> =
                (0..width).map(|x| integrator.radiance(&ray(x), &media, sampler(x), &mut alone)).collect();
            assert_eq!(bundle.radiances(), singly, "row {y}");
        }
        assert_eq!(together, alone);
        assert!(together.refracted > 100 && together.cut_by_weight > 10 && together.shadow > 100, "{together:?}");
    }
}
