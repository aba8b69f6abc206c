//! Materials: what a surface does with light.

mod coated;
mod colour_source;
mod conductor;
mod diffuse;
mod directional_table;
pub mod fresnel;
mod medium;
mod metal;
mod microfacet;
mod octaves;
mod phong;
mod quadrature;
mod rough_glass;
mod scattering;
mod scattering_sample;
mod specular;
mod visible_average;

pub use coated::{Coat, Coated};
pub use colour_source::{Checker, ColourSource, ImageTexture};
pub use conductor::{METALS, MetalReflectance};
pub use diffuse::{Diffuse, cosine_density, cosine_direction};
pub use medium::{Medium, MediumStack, beer_lambert};
pub use metal::Metal;
pub use phong::{Phong, phong_lobe};
pub use rough_glass::{RoughBoundary, RoughGlass};
pub use scattering::Scattering;
pub use scattering_sample::{Evaluation, ScatteringSample};
pub use specular::{Mirror, SmoothBoundary};

use std::sync::Arc;

use crate::math::Vec3;
use crate::shapes::TexturePoint;

/// What a surface does with light. Reflectances are linear RGB in `[0, 1]`.
#[derive(Debug, Clone)]
pub enum Material {
    /// Shows the shading normal as a colour, `(n + 1) / 2`: for debugging.
    Normals,
    /// Shows the fractions of the texture coordinates as red and green: for debugging.
    TextureCoordinates,
    /// Ideal diffuse reflection.
    Lambert {
        /// Reflectance.
        colour: ColourSource,
    },
    /// Diffuse reflection and a highlight (Phong, Illumination for Computer Generated Pictures, 1975).
    Phong {
        /// Reflectance of the diffuse share.
        diffuse: ColourSource,
        /// Reflectance of the highlight.
        specular: Vec3,
        /// The larger, the smaller the highlight.
        exponent: f32,
    },
    /// Ideal specular reflection, the same at every angle.
    Mirror {
        /// Reflectance.
        colour: ColourSource,
    },
    /// A metal, smooth or rough.
    Metal(Arc<Metal>),
    /// A diffuse base under a dielectric coat.
    Coated {
        /// The dielectric layer.
        coat: Arc<Coat>,
        /// Reflectance of the base.
        colour: ColourSource,
    },
    /// A dielectric with exact Fresnel reflection and transmission.
    Glass {
        /// Index of refraction relative to vacuum.
        index: f64,
        /// Absorption coefficients of Beer-Lambert's law per unit of length: `transmittance = e^(-absorption * length)`.
        absorption: Vec3,
        /// Microfacets of a rough surface; `None` for a smooth one.
        rough: Option<Arc<RoughGlass>>,
    },
    /// A light source: the same radiance in all directions on the front side, black behind. Reflects nothing.
    Light {
        /// Linear RGB, unbounded.
        radiance: Vec3,
    },
}

impl Material {
    /// What the surface does with light at one place; `None` where it scatters none: debugging colours and pure lights.
    ///
    /// `relative_index` is the index of refraction on the viewer's side over that on the other; only glass asks for it.
    #[inline]
    pub fn scattering(&self, point: TexturePoint, relative_index: f64) -> Option<Scattering<'_>> {
        match self {
            Material::Normals | Material::TextureCoordinates | Material::Light { .. } => None,
            Material::Lambert { colour } => Some(Scattering::Diffuse(Diffuse { colour: colour.at(point) })),
            Material::Phong { diffuse, specular, exponent } => {
                Some(Scattering::Phong(Phong { diffuse: diffuse.at(point), specular: *specular, exponent: *exponent }))
            }
            Material::Mirror { colour } => Some(Scattering::Mirror(Mirror { colour: colour.at(point) })),
            Material::Metal(metal) => Some(Scattering::Metal(metal)),
            Material::Coated { coat, colour } => Some(Scattering::Coated(coat.over(colour.at(point)))),
            Material::Glass { .. } if relative_index == 1.0 => Some(Scattering::Passing),
            Material::Glass { rough, .. } => {
                let rough = rough.as_ref().and_then(|glass| glass.boundary(relative_index));
                let smooth = || Scattering::SmoothGlass(SmoothBoundary { relative_index });
                Some(rough.map_or_else(smooth, Scattering::RoughGlass))
            }
        }
    }

    /// Radiance sent out on the front side: the outside of closed shapes, the normal's side of flat ones.
    #[inline]
    pub fn emission(&self) -> Vec3 {
        if let Material::Light { radiance } = self { *radiance } else { Vec3::ZERO }
    }

    /// True if the surface sends out light by itself.
    pub fn is_emissive(&self) -> bool {
        self.emission() != Vec3::ZERO
    }

    /// Share of the light that is reflected or transmitted at one place; 0 for debugging colours and pure lights.
    pub fn albedo(&self, point: TexturePoint) -> Vec3 {
        self.scattering(point, 1.0).map_or(Vec3::ZERO, |scattering| scattering.albedo())
    }

    /// True if light passes through.
    pub fn transmits(&self) -> bool {
        matches!(self, Material::Glass { .. })
    }

    /// True if rays are sent on in one direction: mirrors and glass.
    pub fn reflects_specularly(&self) -> bool {
        matches!(self, Material::Mirror { .. } | Material::Glass { .. })
    }

    /// True if all light goes on in single directions: mirrors, smooth metal and smooth glass, which can focus it.
    pub fn focuses(&self) -> bool {
        self.any_place().is_some_and(|scattering| scattering.is_specular())
    }

    /// True if some light goes on in all directions, so that light sources can be seen by it.
    pub fn scatters(&self) -> bool {
        self.any_place().is_some_and(|scattering| !scattering.is_specular())
    }

    /// The scattering function somewhere, at some boundary.
    fn any_place(&self) -> Option<Scattering<'_>> {
        self.scattering(TexturePoint::default(), 1.5)
    }

    /// True for glass without microfacets.
    pub fn is_smooth_glass(&self) -> bool {
        matches!(self, Material::Glass { rough: None, .. })
    }

    /// True if the material attenuates light inside it.
    pub fn absorbs(&self) -> bool {
        matches!(self, Material::Glass { absorption, .. } if *absorption != Vec3::ZERO)
    }

    /// True if the colour differs from place to place on a surface.
    pub fn needs_texture_coordinates(&self) -> bool {
        let varies = |colour: &ColourSource| matches!(colour, ColourSource::Checker(_) | ColourSource::Image(_));
        matches!(self, Material::TextureCoordinates) || self.colour().is_some_and(varies)
    }

    /// True if it shows the colours of a mesh's vertices.
    pub fn needs_vertex_colours(&self) -> bool {
        matches!(self.colour(), Some(ColourSource::Vertex))
    }

    /// The colour that may differ from place to place.
    fn colour(&self) -> Option<&ColourSource> {
        match self {
            Material::Lambert { colour } | Material::Mirror { colour } | Material::Coated { colour, .. } => {
                Some(colour)
            }
            Material::Phong { diffuse, .. } => Some(diffuse),
            Material::Normals
            | Material::TextureCoordinates
            | Material::Metal(_)
            | Material::Glass { .. }
            | Material::Light { .. } => None,
        }
    }

    /// True if light sources shade the surface directly.
    pub fn lit_by_sources(&self) -> bool {
        matches!(self, Material::Lambert { .. } | Material::Phong { .. } | Material::Coated { .. })
    }
}

#[cfg(test)]
mod tests;
