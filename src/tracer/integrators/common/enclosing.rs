//! The glasses around a point: a camera may stand in water.

use crate::materials::{Medium, MediumStack};
use crate::math::{DVec3, Departure, Ray, Side};
use crate::scene::{Plan, Scene};

/// The most surfaces that the walk outwards meets.
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
