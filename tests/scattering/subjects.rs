//! The materials that are tested.

use std::sync::Arc;

use skycube::materials::{Coat, ColourSource, METALS, Material, Metal, MetalReflectance, RoughGlass, Scattering};
use skycube::math::{DVec3, Vec3};

pub const ROUGHNESSES: [f64; 8] = [1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0];

pub fn white() -> ColourSource {
    ColourSource::Uniform(Vec3::ONE)
}

pub fn lambert() -> Material {
    Material::Lambert { colour: white() }
}

pub fn phong(exponent: f32) -> Material {
    Material::Phong { diffuse: ColourSource::Uniform(Vec3::splat(0.4)), specular: Vec3::splat(0.6), exponent }
}

/// A metal that reflects everything.
pub fn white_metal(roughness: f64) -> Material {
    Material::Metal(Arc::new(Metal::new(MetalReflectance::Schlick { normal: Vec3::ONE }, roughness)))
}

pub fn gold(roughness: f64) -> Material {
    Material::Metal(Arc::new(Metal::new(METALS[0].1, roughness)))
}

/// A coat over a base that reflects everything.
pub fn white_coated(roughness: f64) -> Material {
    Material::Coated { coat: Arc::new(Coat::new(1.5, roughness)), colour: white() }
}

pub fn glass(index: f64, roughness: f64) -> Material {
    let rough = (roughness > 0.0).then(|| Arc::new(RoughGlass::new(index, roughness)));
    Material::Glass { index, absorption: Vec3::ZERO, rough }
}

/// The scattering function of a material; the ratio of indices counts for glass only.
pub fn scattering(material: &Material, relative_index: f64) -> Scattering<'_> {
    material.scattering(Default::default(), relative_index).unwrap()
}

/// A view with a cosine and an azimuth that is no axis.
pub fn view(cosine: f64) -> DVec3 {
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    DVec3::new(sine * 0.8, sine * 0.6, cosine)
}
