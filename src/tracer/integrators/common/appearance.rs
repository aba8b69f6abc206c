//! What a surface shows by itself, and what it does with light that arrives from one direction.

use std::f32::consts::PI;

use super::view::View;
use crate::materials::fresnel::reflect;
use crate::materials::{Material, phong_lobe};
use crate::math::{DVec2, DVec3, Departure, Ray, Side, SurfaceId, Vec3};
use crate::scene::Mistake;
use crate::shapes::Surface;

/// What a surface shows to a ray in the light of the sources alone.
pub enum Appearance {
    /// A colour that does not depend on light, and what an observer is told of it.
    Own(&'static str, Vec3),
    Reflecting(Reflection),
}

/// How a surface reflects light from the light sources towards the viewer.
#[derive(Clone, Copy)]
pub struct Reflection {
    /// Share of the light that is reflected in all directions alike.
    pub diffuse: Vec3,
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

impl Reflection {
    /// The reflectance distribution function for light from a unit direction: `diffuse / pi`, and Phong's lobe where the
    /// surface has a highlight.
    #[inline(always)]
    pub fn reflectance(&self, to_light: DVec3) -> Vec3 {
        let mut reflectance = self.diffuse / PI;
        if let Some(Highlight { specular, exponent, mirrored }) = self.highlight {
            reflectance += specular * phong_lobe(mirrored.dot(to_light) as f32, exponent);
        }
        reflectance
    }
}

/// What a surface shows to a ray of a direction.
#[inline(always)]
pub fn appearance(material: &Material, surface: &Surface, view: &View, direction: DVec3) -> Appearance {
    let place = surface.texture_coordinates;
    let reflecting = |diffuse, highlight| Appearance::Reflecting(Reflection { diffuse, highlight });
    match material {
        Material::Normals => Appearance::Own(NORMAL_COLOUR, normal_colour(surface.shading_normal)),
        Material::TextureCoordinates => Appearance::Own(COORDINATES_COLOUR, coordinates_colour(place)),
        Material::Mirror { .. } | Material::Metal(_) | Material::Glass { .. } => {
            Appearance::Own("nothing that this integrator follows: black", Vec3::ZERO)
        }
        Material::Light { radiance } if view.side == Side::Front => Appearance::Own(SHINES, *radiance),
        Material::Light { .. } => Appearance::Own("back of a light: black", Vec3::ZERO),
        Material::Lambert { colour } | Material::Coated { colour, .. } => reflecting(colour.at(place), None),
        Material::Phong { diffuse, specular, exponent } => {
            let mirrored = reflect(direction, view.shading_normal);
            let highlight = Highlight { specular: *specular, exponent: *exponent, mirrored };
            reflecting(diffuse.at(place), Some(highlight))
        }
    }
}

/// The ray from a surface towards a light; for lessons, with the mistake they ask for.
#[inline]
pub fn shadow_ray(mistake: Option<Mistake>, position: DVec3, surface: SurfaceId, side: Side, to_light: DVec3) -> Ray {
    match mistake {
        Some(Mistake::ShadowAcne) => Ray::new(position.as_vec3().as_dvec3(), to_light),
        None => Ray { origin: position, direction: to_light, departure: Some(Departure { surface, side }) },
    }
}

/// A unit vector as a colour: each component from `[-1, 1]` to `[0, 1]`.
pub fn normal_colour(normal: DVec3) -> Vec3 {
    (normal.as_vec3() + 1.0) / 2.0
}

/// The fractions of texture coordinates as red and green.
pub fn coordinates_colour(place: DVec2) -> Vec3 {
    let fraction = (place - place.floor()).as_vec2();
    Vec3::new(fraction.x, fraction.y, 0.0)
}

/// What an observer is told of the colours that surfaces show by themselves.
pub const NORMAL_COLOUR: &str = "shading normal as a colour, (n + 1) / 2";
pub const COORDINATES_COLOUR: &str = "texture coordinates as red and green";
pub const SHINES: &str = "shines by itself";
