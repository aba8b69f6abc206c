//! The glasses that rays go through.

use super::view::View;
use crate::materials::{Material, Medium, MediumStack, beer_lambert};
use crate::math::{DVec3, Departure, Ray, Side, SurfaceId, Vec3};
use crate::scene::{Plan, Scene};
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

    /// Share of the light that is left after a way through a glass.
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

/// Surfaces met at most on the way out.
const LONGEST_WAY: usize = 4096;

/// The glasses that enclose a point from which rays start, outermost first: a camera may stand in water.
///
/// Walks straight outwards. A glass that is left without having been entered on the way encloses the point, and those
/// that are left first lie innermost.
pub fn media_around(scene: &Scene, plan: &Plan, point: DVec3) -> MediumStack {
    if !plan.refraction {
        return MediumStack::default();
    }
    let mut entered: Vec<u32> = Vec::new();
    let mut enclosing: Vec<Medium> = Vec::new();
    // No axis, so that it does not run along the faces of boxes.
    let mut ray = Ray::new(point, DVec3::new(0.48, 0.6, 0.64));
    for _ in 0..LONGEST_WAY {
        let Some(hit) = scene.shapes.intersect(&ray) else { break };
        let surface = scene.shapes.surface(&ray, &hit);
        let side = Side::of(-ray.direction, surface.normal);
        let shape = surface.id.shape;
        if scene.materials[surface.material as usize].transmits() {
            match (side, entered.iter().rposition(|&other| other == shape)) {
                (Side::Front, _) => entered.push(shape),
                (Side::Back, Some(place)) => {
                    entered.remove(place);
                }
                (Side::Back, None) => enclosing.push(Medium { shape, material: surface.material }),
            }
        }
        let departure = Departure { surface: surface.id, side: side.opposite() };
        ray = Ray { origin: surface.position, departure: Some(departure), ..ray };
    }
    enclosing.into_iter().rev().collect()
}
