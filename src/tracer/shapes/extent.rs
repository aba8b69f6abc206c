//! The extent of shapes in the world.

use super::flat::Outline;
use super::primitive::{Geometry, Primitive};
use crate::math::{Bounds, DVec3};

/// A sphere around a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingSphere {
    /// In the world.
    pub centre: DVec3,
    /// In units of the world.
    pub radius: f64,
}

impl Primitive {
    /// The box around the shape in the world; `None` for a plane, which is infinite.
    pub fn bounds(&self) -> Option<Bounds> {
        let object = match &self.geometry {
            Geometry::Flat(Outline::Plane) => return None,
            Geometry::Flat(_) => Bounds { minimum: DVec3::new(-1.0, -1.0, 0.0), maximum: DVec3::new(1.0, 1.0, 0.0) },
            Geometry::Sphere | Geometry::Cuboid => Bounds { minimum: DVec3::NEG_ONE, maximum: DVec3::ONE },
            Geometry::Mesh(mesh) => mesh.bounds(),
        };
        Some(object.transformed(&self.transform.to_world))
    }

    /// A sphere around the shape in the world: a round sphere itself, for others the one around their box; `None` for a plane.
    pub fn bounding_sphere(&self) -> Option<BoundingSphere> {
        if let Some((centre, radius)) = self.as_sphere() {
            return Some(BoundingSphere { centre, radius });
        }
        let bounds = self.bounds()?;
        Some(BoundingSphere { centre: (bounds.minimum + bounds.maximum) / 2.0, radius: bounds.extent().length() / 2.0 })
    }
}
