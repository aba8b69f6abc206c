//! Materials: what a surface does with light.

mod colour_source;
pub mod fresnel;
mod medium;

pub use colour_source::{Checker, ColourSource, ImageTexture};
pub use medium::{Medium, MediumStack};

use crate::math::Vec3;

/// What a surface does with light. Reflectances are linear RGB in `[0, 1]`.
#[derive(Debug, Clone)]
pub enum Material {
    /// Shows the shading normal as a colour, `(n + 1) / 2`: for debugging.
    Normals,
    /// Shows the fractions of the texture coordinates as red and green: for debugging.
    TextureCoordinates,
    /// Ideal diffuse reflection.
    Lambert { colour: ColourSource },
    /// Diffuse reflection and a highlight (Phong, Illumination for Computer Generated Pictures, 1975).
    Phong { diffuse: ColourSource, specular: Vec3, exponent: f32 },
    /// Ideal specular reflection, the same at every angle.
    Mirror { colour: ColourSource },
    /// A smooth dielectric with exact Fresnel reflection and transmission.
    Glass {
        /// Index of refraction relative to vacuum.
        index: f64,
        /// Absorption coefficients of Beer-Lambert's law per unit of length: `transmittance = e^(-absorption * length)`.
        absorption: Vec3,
    },
}

impl Material {
    /// True if light passes through.
    pub fn transmits(&self) -> bool {
        matches!(self, Material::Glass { .. })
    }

    /// True if rays are sent on in one direction: mirrors and glass.
    pub fn reflects_specularly(&self) -> bool {
        matches!(self, Material::Mirror { .. } | Material::Glass { .. })
    }

    /// True if light is weakened on its way through.
    pub fn absorbs(&self) -> bool {
        matches!(self, Material::Glass { absorption, .. } if *absorption != Vec3::ZERO)
    }

    /// True if the colour differs from place to place on a surface.
    pub fn needs_texture_coordinates(&self) -> bool {
        let varies = |colour: &ColourSource| !matches!(colour, ColourSource::Uniform(_));
        match self {
            Material::TextureCoordinates => true,
            Material::Lambert { colour } | Material::Mirror { colour } => varies(colour),
            Material::Phong { diffuse, .. } => varies(diffuse),
            Material::Normals | Material::Glass { .. } => false,
        }
    }

    /// True if light sources shade the surface directly.
    pub fn lit_by_sources(&self) -> bool {
        matches!(self, Material::Lambert { .. } | Material::Phong { .. })
    }
}
