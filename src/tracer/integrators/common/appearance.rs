//! Light that arrives straight from the light sources.

use std::f32::consts::PI;

use super::RayCounts;
use super::normals;
use super::observer::{Event, LightOutcome, Observer};
use super::view::{Vertex, View};
use crate::lights::Light;
use crate::materials::fresnel::reflect;
use crate::materials::{Material, phong_lobe};
use crate::math::{DVec2, DVec3, Departure, Ray, Side, Vec3};
use crate::scene::{IntegratorKind, Mistake, Plan, Scene};
use crate::shapes::{Outlook, Surface};

/// The ray from a surface towards a light; for lessons, with the mistake they ask for.
#[inline]
fn shadow_ray(mistake: Option<Mistake>, vertex: &Vertex, to_light: DVec3) -> Ray {
    match mistake {
        Some(Mistake::ShadowAcne) => Ray::new(vertex.position.as_vec3().as_dvec3(), to_light),
        None => {
            let departure = Departure { surface: vertex.id, side: vertex.view.side };
            Ray { origin: vertex.position, direction: to_light, departure: Some(departure) }
        }
    }
}

/// The fractions of texture coordinates as red and green.
pub(super) fn coordinates_colour(place: DVec2) -> Vec3 {
    let fraction = (place - place.floor()).as_vec2();
    Vec3::new(fraction.x, fraction.y, 0.0)
}

/// What the colours that surfaces show by themselves are called.
pub(super) const COORDINATES_COLOUR: &str = "texture coordinates as red and green";
pub(super) const SHINES: &str = "shines by itself";

/// What a surface does with light that arrives from lights.
#[derive(Clone, Copy)]
pub struct Reflection {
    diffuse: Vec3,
    highlight: Option<Highlight>,
}

/// A Phong highlight.
#[derive(Clone, Copy)]
struct Highlight {
    specular: Vec3,
    exponent: f32,
    /// The direction in which a mirror would send the viewer's ray.
    mirrored: DVec3,
}

/// What a surface shows in light of the sources alone.
pub(super) enum Appearance {
    /// A colour of its own, and what an observer is told of it.
    Own(&'static str, Vec3),
    Reflecting(Reflection),
}

/// What a surface shows to a ray of a direction.
#[inline(always)]
pub(super) fn appearance(material: &Material, surface: &Surface, view: &View, direction: DVec3) -> Appearance {
    let reflecting = |diffuse, highlight| Appearance::Reflecting(Reflection { diffuse, highlight });
    match material {
        Material::Normals => Appearance::Own(normals::NORMAL_COLOUR, normals::colour(surface.shading_normal)),
        Material::TextureCoordinates => {
            Appearance::Own(COORDINATES_COLOUR, coordinates_colour(surface.texture_coordinates))
        }
        Material::Mirror { .. } | Material::Metal(_) | Material::Glass { .. } => {
            Appearance::Own("nothing that this integrator follows: black", Vec3::ZERO)
        }
        Material::Light { radiance } if view.side == Side::Front => Appearance::Own(SHINES, *radiance),
        Material::Light { .. } => Appearance::Own("back of a light: black", Vec3::ZERO),
        Material::Lambert { colour } | Material::Coated { colour, .. } => {
            reflecting(colour.at(surface.texture_coordinates), None)
        }
        Material::Phong { diffuse, specular, exponent } => {
            let mirrored = reflect(direction, view.shading_normal);
            let highlight = Highlight { specular: *specular, exponent: *exponent, mirrored };
            reflecting(diffuse.at(surface.texture_coordinates), Some(highlight))
        }
    }
}

/// A vertex that reflects the light of sources.
pub struct Lit {
    pub vertex: Vertex,
    pub reflection: Reflection,
}

/// The view from each light source, if it has a place and shadow rays go there.
pub(super) fn outlooks(scene: &Scene, plan: &Plan) -> Vec<Option<Outlook>> {
    let asks = matches!(plan.integrator, IntegratorKind::Phong | IntegratorKind::Whitted);
    // Rays with a mistake do not go to the light exactly.
    let exact = asks && plan.shadow_rays && scene.integrator.mistake.is_none();
    let position = |light: &Light| light.position().filter(|_| exact);
    scene.lights.iter().map(|light| scene.shapes.outlook(position(light)?)).collect()
}

/// Adds the light of sources that vertices reflect to the radiance of their rays: light by light, each for all of them.
pub(super) fn illuminate<O: Observer>(
    scene: &Scene,
    plan: &Plan,
    outlooks: &[Option<Outlook>],
    lit: &[Lit],
    radiances: &mut [Vec3],
    counts: &mut RayCounts,
    observer: &mut O,
) {
    if !plan.direct_light || lit.is_empty() {
        return;
    }
    for (number, (light, outlook)) in scene.lights.iter().zip(outlooks).enumerate() {
        let arriving = Arriving { scene, light, shadows: plan.shadow_rays, outlook: outlook.as_ref() };
        for Lit { vertex, reflection } in lit {
            let outcome = arriving.at(vertex, reflection, counts);
            if let LightOutcome::Ambient { contribution } | LightOutcome::Free { contribution, .. } = outcome {
                radiances[vertex.path] += contribution;
            }
            observer.note(|| Event::Light { number, outcome });
        }
    }
}

/// A light, and what may be in its way.
struct Arriving<'a> {
    scene: &'a Scene,
    light: &'a Light,
    /// False if nothing casts shadows.
    shadows: bool,
    /// The view from the light, if it has a place.
    outlook: Option<&'a Outlook>,
}

impl Arriving<'_> {
    /// What the light does at a vertex.
    #[inline(always)]
    fn at(&self, vertex: &Vertex, reflection: &Reflection, counts: &mut RayCounts) -> LightOutcome {
        if let Light::Ambient { radiance } = self.light {
            return LightOutcome::Ambient { contribution: reflection.diffuse * *radiance };
        }
        let Vertex { position, view, .. } = vertex;
        let Some(arriving) = self.light.illumination(*position) else { return LightOutcome::Unreached };
        let cosine = view.shading_normal.dot(arriving.to_light);
        // Light must reach the true surface from the side that is looked at.
        if cosine <= 0.0 || view.normal.dot(arriving.to_light) <= 0.0 {
            return LightOutcome::Behind;
        }
        let ray = shadow_ray(self.scene.integrator.mistake, vertex, arriving.to_light);
        let distance = arriving.distance;
        if self.shadows {
            counts.shadow += 1;
            if self.scene.shapes.occluded_from(self.outlook, &ray, distance) {
                return LightOutcome::Blocked { ray, distance };
            }
        }
        let mut reflectance = reflection.diffuse / PI;
        if let Some(Highlight { specular, exponent, mirrored }) = reflection.highlight {
            reflectance += specular * phong_lobe(mirrored.dot(arriving.to_light) as f32, exponent);
        }
        let contribution = reflectance * arriving.irradiance * cosine as f32;
        LightOutcome::Free { ray, distance, cosine, contribution }
    }
}
