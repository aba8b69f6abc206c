//! The plan: what a scene needs, and what is left out because it does not need it.

use super::Aggregate;
use super::load::Scene;
use super::settings::IntegratorKind;
use crate::envmap::EnvironmentKind;
use crate::lights::Light;
use crate::materials::Material;

/// Computed once from the scene, obeyed by the integrators, printed by `render`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan {
    pub integrator: IntegratorKind,
    /// Direct light is computed: there is a light source and a surface that shows it.
    pub direct_light: bool,
    /// Shadow rays are cast: there is direct light from a place or direction.
    pub shadow_rays: bool,
    /// Mirror directions are followed: there is a mirror or glass.
    pub reflection: bool,
    /// Rays are followed through surfaces: there is glass.
    pub refraction: bool,
    /// Light is weakened on its way through glass: some glass absorbs.
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
        let traces = integrator == IntegratorKind::Whitted && scene.integrator.depth > 0;
        // Materials count only where a shape shows them.
        let numbers = || scene.shapes.primitives().iter().flat_map(|primitive| primitive.material.numbers());
        let any =
            |property: fn(&Material) -> bool| numbers().any(|&number| property(&scene.materials[number as usize]));
        let shadowing = scene.shapes.primitives().iter().any(|primitive| primitive.casts_shadow);
        let shades = integrator != IntegratorKind::Normals && any(Material::lit_by_sources);
        let refraction = traces && any(Material::transmits);
        let reflection = traces && any(Material::reflects_specularly);
        Self {
            integrator,
            direct_light: shades && !scene.lights.is_empty(),
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
            let reason = if scene.lights.is_empty() { "no lights" } else { "nothing that lights shade" };
            item(!self.direct_light, &format!("{reason}: no direct light, no shadow rays"));
            item(self.direct_light && !self.shadow_rays, "nothing that could be shadowed: no shadow rays");
            let local = self.integrator == IntegratorKind::Phong || scene.integrator.depth == 0;
            item(local, "local light only: no reflected or refracted rays");
            item(!local && !self.reflection, "no mirror and no glass: no reflected rays");
            item(!local && self.reflection && !self.refraction, "no glass: no refracted rays, no media");
            item(self.refraction && !self.absorption, "clear glass only: no absorption");
            item(!self.environment_map, "no environment picture: nothing decoded");
        }
        item(self.reflection && !self.roulette, "weight cut-off 0: no random cuts");
        let count = scene.shapes.primitives().len();
        let unit = if count == 1 { "shape" } else { "shapes" };
        item(
            !self.hierarchy,
            &format!("{count} {unit} (at most {} with bounds): no hierarchy over them", Aggregate::HANDFUL),
        );
        items
    }
}
