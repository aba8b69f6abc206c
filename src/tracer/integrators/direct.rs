//! Light that arrives straight from the light sources.

use std::f32::consts::PI;

use super::RayCounts;
use super::normals;
use super::observer::{Event, LightOutcome, Observer};
use crate::lights::Light;
use crate::materials::fresnel::reflect;
use crate::materials::{Material, phong_lobe};
use crate::math::{DVec2, DVec3, Departure, Ray, Side, Vec3};
use crate::scene::{Mistake, Plan, Scene};
use crate::shapes::Surface;

/// A surface as the ray sees it: the normals turned to the ray's side.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    /// Side of the true surface that the ray comes from.
    pub side: Side,
    /// True normal on the ray's side.
    pub normal: DVec3,
    /// Shading normal on the ray's side.
    pub shading_normal: DVec3,
}

impl View {
    /// The surface seen along a direction.
    #[inline]
    pub fn new(surface: &Surface, direction: DVec3) -> Self {
        let side = Side::of(-direction, surface.normal);
        let turned = |normal: DVec3| if side == Side::Front { normal } else { -normal };
        let normal = turned(surface.normal);
        let shading_normal = turned(surface.shading_normal);
        // An interpolated normal may look away from the ray at a silhouette: there the true one serves.
        let visible = shading_normal.dot(direction) < 0.0;
        Self { side, normal, shading_normal: if visible { shading_normal } else { normal } }
    }

    /// The hit as an observer is told of it.
    pub fn hit(&self, surface: &Surface, ray: &Ray, distance: f64, transmittance: Vec3) -> Event {
        let cosine = -ray.direction.dot(self.shading_normal);
        let Self { side, shading_normal, .. } = *self;
        Event::Hit { surface: *surface, side, shading_normal, distance, cosine, transmittance }
    }
}

/// The ray from a surface towards a light; for lessons, with the mistake they ask for.
#[inline]
fn shadow_ray(mistake: Option<Mistake>, surface: &Surface, side: Side, to_light: DVec3) -> Ray {
    match mistake {
        Some(Mistake::ShadowAcne) => Ray::new(surface.position.as_vec3().as_dvec3(), to_light),
        None => {
            let departure = Departure { surface: surface.id, side };
            Ray { origin: surface.position, direction: to_light, departure: Some(departure) }
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
struct Reflection {
    diffuse: Vec3,
    /// Colour and exponent of a Phong highlight.
    highlight: Option<(Vec3, f32)>,
}

/// What a surface shows in light of the sources alone.
enum Appearance {
    /// A colour of its own, and what an observer is told of it.
    Own(&'static str, Vec3),
    Reflecting(Reflection),
}

#[inline(always)]
fn appearance(material: &Material, surface: &Surface, side: Side) -> Appearance {
    let reflecting = |diffuse, highlight| Appearance::Reflecting(Reflection { diffuse, highlight });
    match material {
        Material::Normals => Appearance::Own(normals::NORMAL_COLOUR, normals::colour(surface.shading_normal)),
        Material::TextureCoordinates => {
            Appearance::Own(COORDINATES_COLOUR, coordinates_colour(surface.texture_coordinates))
        }
        Material::Mirror { .. } | Material::Metal(_) | Material::Glass { .. } => {
            Appearance::Own("nothing that this integrator follows: black", Vec3::ZERO)
        }
        Material::Light { radiance } if side == Side::Front => Appearance::Own(SHINES, *radiance),
        Material::Light { .. } => Appearance::Own("back of a light: black", Vec3::ZERO),
        Material::Lambert { colour } | Material::Coated { colour, .. } => {
            reflecting(colour.at(surface.texture_coordinates), None)
        }
        Material::Phong { diffuse, specular, exponent } => {
            reflecting(diffuse.at(surface.texture_coordinates), Some((*specular, *exponent)))
        }
    }
}

/// The colour a surface shows by itself: debugging colours, or reflected light of all sources.
#[inline(always)]
pub(super) fn local_radiance<O: Observer>(
    scene: &Scene,
    plan: &Plan,
    ray: &Ray,
    surface: &Surface,
    view: &View,
    counts: &mut RayCounts,
    observer: &mut O,
) -> Vec3 {
    let reflection = match appearance(&scene.materials[surface.material as usize], surface, view.side) {
        Appearance::Own(what, colour) => {
            observer.note(|| Event::Own { what, colour });
            return colour;
        }
        Appearance::Reflecting(reflection) => reflection,
    };
    if !plan.direct_light {
        return Vec3::ZERO;
    }
    let mirrored = reflect(ray.direction, view.shading_normal);
    let point = Point { scene, shadows: plan.shadow_rays, surface, view, mirrored, reflection };
    let mut radiance = Vec3::ZERO;
    for (number, light) in scene.lights.iter().enumerate() {
        let outcome = point.light(light, counts);
        if let LightOutcome::Ambient { contribution } | LightOutcome::Free { contribution, .. } = outcome {
            radiance += contribution;
        }
        observer.note(|| Event::Light { number, outcome });
    }
    radiance
}

/// A point of a surface that lights shine on.
struct Point<'a> {
    scene: &'a Scene,
    /// False if nothing casts shadows.
    shadows: bool,
    surface: &'a Surface,
    view: &'a View,
    /// The direction in which a mirror would send the viewer's ray.
    mirrored: DVec3,
    reflection: Reflection,
}

impl Point<'_> {
    /// What a light does here.
    #[inline(always)]
    fn light(&self, light: &Light, counts: &mut RayCounts) -> LightOutcome {
        let Self { scene, surface, view, reflection, .. } = self;
        if let Light::Ambient { radiance } = light {
            return LightOutcome::Ambient { contribution: reflection.diffuse * *radiance };
        }
        let Some(arriving) = light.illumination(surface.position) else { return LightOutcome::Unreached };
        let cosine = view.shading_normal.dot(arriving.to_light);
        // Light must reach the true surface from the side that is looked at.
        if cosine <= 0.0 || view.normal.dot(arriving.to_light) <= 0.0 {
            return LightOutcome::Behind;
        }
        let ray = shadow_ray(scene.integrator.mistake, surface, view.side, arriving.to_light);
        let distance = arriving.distance;
        if self.shadows {
            counts.shadow += 1;
            if scene.shapes.occluded(&ray, distance) {
                return LightOutcome::Blocked { ray, distance };
            }
        }
        let mut reflectance = reflection.diffuse / PI;
        if let Some((specular, exponent)) = reflection.highlight {
            reflectance += specular * phong_lobe(self.mirrored.dot(arriving.to_light) as f32, exponent);
        }
        let contribution = reflectance * arriving.irradiance * cosine as f32;
        LightOutcome::Free { ray, distance, cosine, contribution }
    }
}
