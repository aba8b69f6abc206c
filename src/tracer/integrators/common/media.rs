//! The glasses that rays go through.

use super::view::View;
use crate::materials::{Material, Medium, MediumStack, beer_lambert};
use crate::math::{SurfaceId, Vec3};
use crate::scene::Scene;
use crate::shapes::Surface;

/// What the glasses of a scene do with light.
#[derive(Clone, Copy)]
pub struct Media<'a> {
    pub scene: &'a Scene,
    /// False if no glass weakens light.
    pub absorption: bool,
}

impl Media<'_> {
    /// Index of refraction inside a glass, 1 in free space.
    #[inline]
    pub fn index_inside(&self, medium: Option<Medium>) -> f64 {
        self.glass_of(medium).map_or(1.0, |(index, _)| index)
    }

    /// Transmittance over a distance in a glass.
    #[inline(always)]
    pub fn transmittance(&self, medium: impl FnOnce() -> Option<Medium>, distance: f64) -> Vec3 {
        if self.absorption { self.absorbed(medium(), distance) } else { Vec3::ONE }
    }

    #[inline(never)]
    fn absorbed(&self, medium: Option<Medium>, distance: f64) -> Vec3 {
        let Some((_, absorption)) = self.glass_of(medium) else { return Vec3::ONE };
        absorption.to_array().map(|coefficient| beer_lambert(coefficient, distance)).into()
    }

    /// Index and absorption of a glass.
    fn glass_of(&self, medium: Option<Medium>) -> Option<(f64, Vec3)> {
        match &self.scene.materials[medium?.material as usize] {
            Material::Glass { index, absorption, .. } => Some((*index, *absorption)),
            _ => None,
        }
    }
}

/// The glass a ray came through to a surface: see [`MediumStack::before`].
#[inline]
pub fn medium_before(media: &MediumStack, surface: &Surface, view: &View) -> Option<Medium> {
    media.before(met(surface), view.side)
}

/// The glass on the far side of a surface that light passes; `None` if that is free space.
#[inline]
pub fn medium_beyond(media: &MediumStack, surface: &Surface, view: &View) -> Option<Medium> {
    media.innermost_beyond(met(surface), view.side)
}

/// Passes a surface with light: `media` become the glasses on the far side.
#[inline]
pub fn pass(media: &mut MediumStack, surface: &Surface, view: &View) {
    media.pass(met(surface), view.side);
}

/// The glass, if it is one, that a surface encloses.
#[inline]
fn met(surface: &Surface) -> Medium {
    enclosed(surface.id, surface.material)
}

/// The same by the number of its material.
#[inline]
pub fn enclosed(surface: SurfaceId, material: u32) -> Medium {
    Medium { shape: surface.shape, material }
}
