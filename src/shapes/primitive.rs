//! A shape placed in the world.

use std::sync::Arc;

use super::flat::Outline;
use super::mesh::Mesh;
use super::{cuboid, sphere};
use crate::math::{Bounds, DVec2, DVec3, Ray, SurfaceId, Transform};

/// A shape with its place and material.
#[derive(Debug, Clone)]
pub struct Primitive {
    pub geometry: Geometry,
    pub transform: Transform,
    pub material: MaterialChoice,
    /// False if light passes the shape as if it were not there.
    pub casts_shadow: bool,
}

/// The form of a shape in its own space.
#[derive(Debug, Clone)]
pub enum Geometry {
    /// Radius 1 around the origin.
    Sphere,
    /// In the plane z = 0, normal +z.
    Flat(Outline),
    /// The cube `[-1, 1]^3`.
    Cuboid,
    /// Shared by all its instances.
    Mesh(Arc<Mesh>),
}

/// Which material a shape has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MaterialChoice {
    /// One for the whole shape: its number in the scene.
    Whole(u32),
    /// One for each group of a mesh.
    PerGroup(Arc<[u32]>),
}

/// Where a ray meets a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance along the ray.
    pub t: f64,
    pub id: SurfaceId,
    /// Weights of the three vertices of a triangle; 0 for other shapes.
    pub barycentric: [f64; 3],
}

/// The surface at a hit, in the world.
#[derive(Debug, Clone, Copy)]
pub struct Surface {
    pub position: DVec3,
    /// Unit normal of the true surface, pointing to its front (outside).
    pub normal: DVec3,
    /// Unit normal to shade with: interpolated over smooth meshes, otherwise the true one.
    pub shading_normal: DVec3,
    /// v grows upwards, 0 at the bottom of a picture.
    pub texture_coordinates: DVec2,
    /// Number of the material in the scene.
    pub material: u32,
    pub id: SurfaceId,
}

impl Primitive {
    /// The nearest hit of a world ray in `(0, limit)`; `shape` is this primitive's number.
    #[inline]
    pub fn intersect(&self, ray: &Ray, shape: u32, limit: f64) -> Option<Hit> {
        let leaving = ray.leaves(shape);
        let to_object = &self.transform.to_object;
        let found = |t: f64, part: u32| Hit { t, id: SurfaceId { shape, part }, barycentric: [0.0; 3] };
        match &self.geometry {
            // A flat surface cannot be hit again by a ray that leaves it.
            Geometry::Flat(_) if leaving.is_some() => None,
            Geometry::Flat(outline) => {
                outline.intersect(to_object, ray.origin, ray.direction, limit).map(|t| found(t, 0))
            }
            Geometry::Sphere => {
                let (origin, direction) = self.to_object(ray);
                sphere::intersect(origin, direction, limit, leaving.map(|departure| departure.side))
                    .map(|t| found(t, 0))
            }
            Geometry::Cuboid => {
                let (origin, direction) = self.to_object(ray);
                cuboid::intersect(origin, direction, limit, leaving).map(|(t, face)| found(t, face))
            }
            Geometry::Mesh(mesh) => {
                let (origin, direction) = self.to_object(ray);
                let leaving = leaving.map(|departure| (departure.surface.part, departure.side));
                mesh.intersect(origin, direction, limit, leaving)
                    .map(|hit| Hit { barycentric: hit.barycentric, ..found(hit.t, hit.triangle) })
            }
        }
    }

    /// True if anything is hit in `(0, limit)`.
    #[inline]
    pub fn occludes(&self, ray: &Ray, shape: u32, limit: f64) -> bool {
        match &self.geometry {
            Geometry::Mesh(mesh) => {
                let (origin, direction) = self.to_object(ray);
                let leaving = ray.leaves(shape).map(|departure| (departure.surface.part, departure.side));
                mesh.occluded(origin, direction, limit, leaving)
            }
            _ => self.intersect(ray, shape, limit).is_some(),
        }
    }

    /// The surface where a ray hit this primitive.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let transform = &self.transform;
        let to_world = |point: DVec3| transform.to_world.transform_point3(point);
        let object_point = || transform.to_object.transform_point3(ray.at(hit.t));
        let smooth = |point: DVec3, normal: DVec3, texture_coordinates: DVec2| {
            let normal = transform.normal_to_world(normal);
            Surface {
                position: to_world(point),
                normal,
                shading_normal: normal,
                texture_coordinates,
                material: self.material.of_group(0),
                id: hit.id,
            }
        };
        // The object-space point is put exactly onto the surface before it is carried back.
        match &self.geometry {
            Geometry::Sphere => {
                let normal = sphere::normal(object_point());
                smooth(normal, normal, sphere::texture_coordinates(normal))
            }
            Geometry::Flat(outline) => {
                let point = DVec3 { z: 0.0, ..object_point() };
                smooth(point, DVec3::Z, outline.texture_coordinates(point))
            }
            Geometry::Cuboid => {
                let mut point = object_point().clamp(DVec3::NEG_ONE, DVec3::ONE);
                let normal = cuboid::normal(hit.id.part);
                let axis = hit.id.part as usize / 2;
                point[axis] = normal[axis];
                smooth(point, normal, cuboid::texture_coordinates(point, hit.id.part))
            }
            Geometry::Mesh(mesh) => {
                let point = mesh.surface(hit.id.part, hit.barycentric);
                Surface {
                    position: to_world(point.position),
                    normal: transform.normal_to_world(point.geometric_normal),
                    shading_normal: transform.normal_to_world(point.shading_normal),
                    texture_coordinates: point.texture_coordinates.as_dvec2(),
                    material: self.material.of_group(point.material),
                    id: hit.id,
                }
            }
        }
    }

    /// The box around the shape in the world; `None` for a plane, which has no end.
    pub fn bounds(&self) -> Option<Bounds> {
        let object = match &self.geometry {
            Geometry::Flat(Outline::Plane) => return None,
            Geometry::Flat(_) => Bounds { minimum: DVec3::new(-1.0, -1.0, 0.0), maximum: DVec3::new(1.0, 1.0, 0.0) },
            Geometry::Sphere | Geometry::Cuboid => Bounds { minimum: DVec3::NEG_ONE, maximum: DVec3::ONE },
            Geometry::Mesh(mesh) => mesh.bounds(),
        };
        Some(object.transformed(&self.transform.to_world))
    }

    fn to_object(&self, ray: &Ray) -> (DVec3, DVec3) {
        let to_object = &self.transform.to_object;
        (to_object.transform_point3(ray.origin), to_object.transform_vector3(ray.direction))
    }
}

impl MaterialChoice {
    /// The scene's number of the material of a group.
    fn of_group(&self, group: u32) -> u32 {
        match self {
            MaterialChoice::Whole(material) => *material,
            MaterialChoice::PerGroup(materials) => materials[group as usize],
        }
    }
}
