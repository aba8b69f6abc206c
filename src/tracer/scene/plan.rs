//! The plan: what a scene needs, and what the renderer leaves out.

use super::load::Scene;
use super::settings::{Caustics, HierarchyChoice, IntegratorKind, Strategy};
use crate::envmap::EnvironmentKind;
use crate::lights::Light;
use crate::materials::Material;
use crate::math::Vec3;

/// The code that renders a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wing {
    /// The integrator as a lecture shows it.
    Textbook,
    /// A row of rays at once: the same bits.
    SideBySide,
    /// Paths that photons guide to focused light: the same mean.
    Guided,
}

impl Wing {
    /// What `render` calls it.
    pub fn name(self) -> &'static str {
        match self {
            Wing::Textbook => "textbook",
            Wing::SideBySide => "side by side",
            Wing::Guided => "guided",
        }
    }
}

/// Computed once from the scene, obeyed by the integrators, printed by `render`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan {
    /// The integrator that renders.
    pub integrator: IntegratorKind,
    /// Direct light is computed: there is a light source and a surface that shows it.
    pub direct_light: bool,
    /// Shadow rays are cast: there is direct light from a place or direction.
    pub shadow_rays: bool,
    /// How the path tracer finds light sources with an extent.
    pub strategy: Strategy,
    /// The path tracer samples light sources with an extent: the scene has some, and surfaces that are not all mirrors
    /// and smooth glass.
    pub light_sampling: bool,
    /// Tables are built that draw directions by the brightness of the environment.
    pub environment_sampling: bool,
    /// There are mirrors, smooth metal or smooth glass, which can focus light.
    pub focuses: bool,
    /// A photon pass finds the light that mirrors and glass focus: the scene has both, and surfaces to show it. (Left
    /// out after all if no light source is small and bright.)
    pub caustics: bool,
    /// The path tracer follows both branches at smooth glass seen by the camera: the scene has smooth glass.
    pub branches: bool,
    /// The code that renders.
    pub wing: Wing,
    /// Mirror directions are followed: there is a mirror or glass.
    pub reflection: bool,
    /// Rays are followed through surfaces: there is glass.
    pub refraction: bool,
    /// Glass attenuates light: some glass absorbs.
    pub absorption: bool,
    /// A hierarchy over the shapes was built.
    pub hierarchy: bool,
    /// Rays that hit nothing read a picture.
    pub environment_map: bool,
    /// Rays that carry little are followed at random.
    pub roulette: bool,
}

impl Plan {
    /// The plan of a scene.
    pub fn new(scene: &Scene) -> Self {
        let integrator = scene.integrator.kind;
        let (whitted, path) = (integrator == IntegratorKind::Whitted, integrator == IntegratorKind::Path);
        let traces = (whitted || path) && scene.integrator.depth > 0;
        // Materials count only where a shape shows them.
        let numbers = || scene.shapes.primitives().iter().flat_map(|primitive| primitive.material.numbers());
        let any =
            |property: fn(&Material) -> bool| numbers().any(|&number| property(&scene.materials[number as usize]));
        let shadowing = scene.shapes.primitives().iter().any(|primitive| primitive.casts_shadow);
        let shown_by: fn(&Material) -> bool = if path { Material::scatters } else { Material::lit_by_sources };
        let shades = integrator != IntegratorKind::Normals && any(shown_by);
        let refraction = traces && any(Material::transmits);
        let reflection = traces && (any(Material::reflects_specularly) || path && (shades || any(Material::focuses)));
        let strategy = scene.integrator.strategy;
        let samples_lights = path && traces && shades && strategy != Strategy::Bsdf;
        let bright =
            !matches!(scene.environment.kind, EnvironmentKind::Constant(Vec3::ZERO)) && scene.environment.scale > 0.0;
        let environment_sampling = samples_lights && bright;
        let light_sampling = environment_sampling || samples_lights && any(Material::is_emissive);
        let fast = scene.integrator.fast;
        let focuses = any(Material::focuses);
        let caustics = fast && light_sampling && scene.integrator.caustics == Caustics::Auto && focuses;
        let branches = fast && path && traces && any(Material::is_smooth_glass);
        let wing = match integrator {
            IntegratorKind::Phong | IntegratorKind::Whitted if fast => Wing::SideBySide,
            IntegratorKind::Path if caustics || branches => Wing::Guided,
            _ => Wing::Textbook,
        };
        Self {
            integrator,
            strategy,
            focuses,
            caustics,
            branches,
            wing,
            light_sampling,
            environment_sampling,
            // Ambient light stands in for what the path tracer computes.
            direct_light: shades && scene.lights.iter().any(|light| !path || light.casts_shadows()),
            shadow_rays: shades && shadowing && scene.lights.iter().any(Light::casts_shadows),
            reflection,
            refraction,
            absorption: refraction && any(Material::absorbs),
            hierarchy: scene.shapes.has_hierarchy(),
            environment_map: integrator != IntegratorKind::Normals
                && matches!(scene.environment.kind, EnvironmentKind::CubeMap(_) | EnvironmentKind::Equirectangular(_)),
            roulette: reflection && scene.integrator.weight_cutoff > 0.0,
        }
    }

    /// What only the path tracer could do and leaves out.
    fn left_out_by_path(&self, scene: &Scene, item: &mut impl FnMut(bool, &str)) {
        let ambient = scene.lights.iter().any(|light| !light.casts_shadows());
        item(ambient, "ambient light: the light between surfaces, for which it stands, is computed");
        let no_depth = scene.integrator.depth == 0;
        let reason = match self.strategy {
            _ if no_depth => "depth 0",
            Strategy::Bsdf => "strategy bsdf",
            _ => "no emissive shape, no environment, or only mirrors and smooth glass",
        };
        item(!self.light_sampling, &format!("{reason}: no shadow rays to area lights and environment"));
        item(self.light_sampling && !self.environment_sampling, "black environment: no tables to sample it");
        let reason = match scene.integrator.caustics {
            _ if no_depth => "depth 0",
            Caustics::Off => "caustics off",
            Caustics::Auto if !self.light_sampling => "no shadow rays to area lights and environment",
            Caustics::Auto if !scene.integrator.fast && self.focuses => "textbook only",
            Caustics::Auto => "no mirrors or smooth glass beside other surfaces",
        };
        item(!self.caustics, &format!("{reason}: no photon pass"));
    }

    /// What is left out and why, one sentence an item.
    pub fn left_out(&self, scene: &Scene) -> Vec<String> {
        let mut items = Vec::new();
        let mut item = |left_out: bool, sentence: &str| {
            if left_out {
                items.push(sentence.to_owned());
            }
        };
        let normals = self.integrator == IntegratorKind::Normals;
        item(normals, "normals only: no light, no environment, no secondary rays");
        if !normals {
            let (lights, consequence) = match self.integrator {
                IntegratorKind::Path => ("no point, spot or directional light", "no shadow rays to them"),
                _ => ("no lights", "no direct light, no shadow rays"),
            };
            let reason = if scene.lights.is_empty() { lights } else { "only surfaces that lights do not shade" };
            item(!self.direct_light, &format!("{reason}: {consequence}"));
            item(self.direct_light && !self.shadow_rays, "nothing can be in shadow: no shadow rays");
            if self.integrator == IntegratorKind::Path {
                self.left_out_by_path(scene, &mut item);
            }
            let local = self.integrator == IntegratorKind::Phong || scene.integrator.depth == 0;
            let reason = if self.integrator == IntegratorKind::Path { "depth 0" } else { "local light only" };
            item(local, &format!("{reason}: no reflected or refracted rays"));
            item(!local && !self.reflection, "no mirror and no glass: no reflected rays");
            item(!local && self.reflection && !self.refraction, "no glass: no refracted rays, no media");
            item(self.refraction && !self.absorption, "only clear glass: no absorption");
            item(!self.environment_map, "no environment picture: nothing to decode");
        }
        item(self.reflection && !self.roulette, "weight cut-off 0: no random cuts");
        let count = scene.shapes.primitives().len();
        let unit = if count == 1 { "shape" } else { "shapes" };
        let reason = if scene.integrator.hierarchy == HierarchyChoice::Off {
            format!("hierarchy off, {count} {unit}")
        } else {
            format!("{count} {unit}, too few")
        };
        item(!self.hierarchy, &format!("{reason}: no hierarchy over them"));
        items
    }
}
