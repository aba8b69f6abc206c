//! A surface as a ray sees it: its normals, its emission, and its reflection of light from one direction.

use std::f32::consts::PI;

use super::observer::Event;
use crate::materials::fresnel::reflect;
use crate::materials::{Material, phong_lobe};
use crate::math::{DVec3, Departure, Ray, Side, SurfaceId, Vec3};
use crate::scene::Mistake;
use crate::shapes::Surface;

/// A surface as the ray sees it: the normals turned to the ray's side.
#[derive(Debug, Clone, Copy)]
pub struct View {
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
    let place = surface.texture;
    let reflecting = |diffuse, highlight| Appearance::Reflecting(Reflection { diffuse, highlight });
    match material {
        Material::Normals | Material::TextureCoordinates => {
            let (what, colour) = debug_colour(material, surface).unwrap_or_default();
            Appearance::Own(what, colour)
        }
        Material::Mirror { .. } | Material::Metal(_) | Material::Glass { .. } => {
            Appearance::Own("not supported by this integrator: black", Vec3::ZERO)
        }
        Material::Light { radiance } if view.side == Side::Front => Appearance::Own(EMITTED, *radiance),
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

/// The colour of a material for debugging, and what an observer is told of it; `None` for all other materials.
pub fn debug_colour(material: &Material, surface: &Surface) -> Option<(&'static str, Vec3)> {
    match material {
        Material::Normals => Some((NORMAL_COLOUR, normal_colour(surface.shading_normal))),
        Material::TextureCoordinates => {
            let coordinates = surface.texture.coordinates;
            let fraction = (coordinates - coordinates.floor()).as_vec2();
            Some(("texture coordinates as red and green", Vec3::new(fraction.x, fraction.y, 0.0)))
        }
        _ => None,
    }
}

/// A unit vector as a colour: each component from `[-1, 1]` to `[0, 1]`.
pub fn normal_colour(normal: DVec3) -> Vec3 {
    (normal.as_vec3() + 1.0) / 2.0
}

/// What an observer is told of the colours that surfaces show by themselves.
pub const NORMAL_COLOUR: &str = "shading normal as a colour, (n + 1) / 2";
pub const EMITTED: &str = "emitted by the surface";
