//! The materials of MTL files as materials of the scene. `scenes.md` has the mapping key by key.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::material::TextureStore;
use crate::colour::decode_srgb;
use crate::error::Result;
use crate::materials::{ColourSource, ImageTexture, Material, Metal, MetalReflectance};
use crate::math::{DVec2, Vec3};
use crate::picture::Filter;
use crate::shapes::mesh::ObjMaterial;

/// How the numbers of `Kd` and `Ks` are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, clap::ValueEnum)]
pub(super) enum MtlColours {
    /// Linear light.
    #[default]
    Linear,
    /// Codes as a colour picker shows them, over 255.
    Srgb,
}

/// The conversion of the materials of one mesh file, and what a user should know of it.
pub(super) struct Conversion<'a> {
    pub textures: &'a mut TextureStore,
    pub colours: MtlColours,
    /// Keys that had no effect, with the materials.
    unused: BTreeMap<String, Vec<String>>,
    glass: Vec<String>,
    lights: Vec<String>,
}

impl<'a> Conversion<'a> {
    pub(super) fn new(textures: &'a mut TextureStore, colours: MtlColours) -> Self {
        Self { textures, colours, unused: BTreeMap::new(), glass: Vec::new(), lights: Vec::new() }
    }

    /// A material: a light source, glass, a mirror, metal, Phong if it has a highlight, or else Lambert.
    pub(super) fn material(&mut self, described: &ObjMaterial) -> Result<Material> {
        described.unread.iter().for_each(|key| self.is_unused(key, described));
        let white = ColourSource::Uniform(Vec3::ONE);
        if let Some(radiance) = self.radiance(described) {
            self.lights.push(described.name.clone());
            return Ok(Material::Light { radiance });
        }
        if is_glass(described) {
            self.glass.push(described.name.clone());
            let index = described.index_of_refraction.map_or(1.5, |index| f64::from(index).clamp(0.1, 100.0));
            return Ok(Material::Glass { index, absorption: Vec3::ZERO, rough: None });
        }
        if described.dissolve.is_some_and(|dissolve| dissolve < 1.0) {
            self.is_unused("d", described);
        }
        let specular = described.specular.map(|colour| self.reflectance(colour, "Ks", described));
        if matches!(described.illumination, Some(3 | 5 | 8)) && specular != Some(Vec3::ZERO) {
            if !is_coloured(described) {
                return Ok(Material::Mirror { colour: specular.map_or(white, ColourSource::Uniform) });
            }
            self.is_unused("the mirror of illum 3, 5 and 8", described);
        }
        let diffuse = self.diffuse(described)?;
        if described.roughness.is_some() || described.metalness.is_some() {
            return Ok(self.by_roughness(diffuse, described));
        }
        match specular.filter(|&specular| specular != Vec3::ZERO && described.illumination != Some(1)) {
            Some(specular) => Ok(Material::Phong { diffuse, specular, exponent: exponent(described.shininess) }),
            None => Ok(Material::Lambert { colour: diffuse }),
        }
    }

    /// What a material sends out, if that is more than it reflects: the tracer has no surface that does both.
    fn radiance(&mut self, described: &ObjMaterial) -> Option<Vec3> {
        let emission = described.emission.unwrap_or(Vec3::ZERO).max(Vec3::ZERO);
        let reflected =
            if described.diffuse_map.is_some() { Vec3::ONE } else { described.diffuse.unwrap_or(Vec3::ZERO) };
        if emission.max_element() > reflected.max_element() {
            return Some(emission);
        }
        if emission != Vec3::ZERO {
            self.is_unused("Ke", described);
        }
        None
    }

    /// The picture, or else the colour; a missing one is white, as in the format's description.
    fn diffuse(&mut self, described: &ObjMaterial) -> Result<ColourSource> {
        let Some(map) = &described.diffuse_map else {
            let colour = described.diffuse.unwrap_or(Vec3::ONE);
            return Ok(ColourSource::Uniform(self.reflectance(colour, "Kd", described)));
        };
        let texture = self.textures.load(map.file.clone(), Filter::Bilinear)?;
        Ok(ColourSource::Image(ImageTexture { texture, repeat: DVec2::from_array(map.repeat) }))
    }

    /// The keys `Pm` and `Pr` of the extension for physically based rendering: a metal of the colour, or a diffuse base
    /// under a highlight of 4 %, as plastic has it. The exponent is the one whose lobe is about as wide (Walter et al. 2007).
    fn by_roughness(&mut self, diffuse: ColourSource, described: &ObjMaterial) -> Material {
        let alpha = f64::from(described.roughness.unwrap_or(0.5).clamp(0.0, 1.0)).powi(2);
        let metal = described.metalness.is_some_and(|metalness| metalness >= 0.5);
        match diffuse {
            ColourSource::Uniform(normal) if metal => {
                let alpha = if alpha < 1e-4 { 0.0 } else { alpha };
                Material::Metal(Arc::new(Metal::new(MetalReflectance::Schlick { normal }, alpha)))
            }
            diffuse => {
                if metal {
                    self.is_unused("Pm beside map_Kd", described);
                }
                let exponent = (2.0 / (alpha * alpha).max(1e-5) - 2.0) as f32;
                Material::Phong { diffuse, specular: Vec3::splat(0.04), exponent }
            }
        }
    }

    /// A colour of the file as a reflectance: linear, and at most 1.
    fn reflectance(&mut self, colour: Vec3, key: &str, described: &ObjMaterial) -> Vec3 {
        if colour.max_element() > 1.0 || colour.min_element() < 0.0 {
            self.is_unused(&format!("{key} outside 0 to 1"), described);
        }
        let colour = colour.clamp(Vec3::ZERO, Vec3::ONE);
        match self.colours {
            MtlColours::Linear => colour,
            MtlColours::Srgb => Vec3::from(colour.to_array().map(|code| decode_srgb(f64::from(code)) as f32)),
        }
    }

    fn is_unused(&mut self, key: &str, described: &ObjMaterial) {
        self.unused.entry(key.to_owned()).or_default().push(described.name.clone());
    }

    /// What a user should know, in one line; `None` if there is nothing to say.
    pub(super) fn note(&self) -> Option<String> {
        let unused = self.unused.iter().map(|(key, names)| format!("{key} ({})", listed(names)));
        let parts = [
            ("not used", unused.collect::<Vec<_>>().join(", ")),
            ("clear glass", listed(&self.glass)),
            ("light sources", listed(&self.lights)),
        ];
        let said = parts.iter().filter(|(_, list)| !list.is_empty()).map(|(what, list)| format!("{what}: {list}"));
        let note = said.collect::<Vec<_>>().join("; ");
        (!note.is_empty()).then_some(note)
    }
}

/// Names as a list: the first three, and how many more there are.
fn listed(names: &[String]) -> String {
    let shown =
        names.iter().take(3).map(|name| name.chars().take(40).collect::<String>()).collect::<Vec<_>>().join(", ");
    if names.len() > 3 { format!("{shown} and {} more", names.len() - 3) } else { shown }
}

fn is_coloured(described: &ObjMaterial) -> bool {
    described.diffuse_map.is_some() || described.diffuse.is_some_and(|colour| colour != Vec3::ZERO)
}

/// `illum` 4 and 9 stand for transparency, 6 and 7 for refraction; exporters write them for leaves and cloth, too. A material
/// is therefore glass only if it is transparent (`d` below 1) or has no diffuse colour; 6 and 7 without a picture are glass, too.
fn is_glass(described: &ObjMaterial) -> bool {
    let transparent = described.dissolve.is_some_and(|dissolve| dissolve < 1.0);
    match described.illumination {
        Some(4 | 9) => transparent || !is_coloured(described),
        Some(6 | 7) => transparent || described.diffuse_map.is_none(),
        _ => false,
    }
}

fn exponent(shininess: Option<f32>) -> f32 {
    shininess.unwrap_or(32.0).clamp(0.0, 1e6)
}
