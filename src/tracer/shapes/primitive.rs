//! A shape placed in the world.

use std::sync::Arc;

use super::flat::{Height, Outline};
use super::mesh::Mesh;
use super::{cuboid, sphere};
use crate::math::{DVec2, DVec3, Departure, Ray, SurfaceId, Transform};

/// A shape with its place and material.
#[derive(Debug, Clone)]
pub struct Primitive {
    pub geometry: Geometry,
    pub transform: Transform,
    pub material: MaterialChoice,
    /// False if light passes the shape as if it were not there.
    pub casts_shadow: bool,
    /// False if nobody asks for the texture coordinates: they are then left at 0.
    pub textured: bool,
    kernel: Kernel,
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

/// What is computed for a ray, with what is derived from the transform once.
#[derive(Debug, Clone)]
enum Kernel {
    /// A sphere that the transform leaves round.
    Ball {
        centre: DVec3,
        radius: f64,
        inverse_radius: f64,
    },
    /// A sphere that the transform makes an ellipsoid.
    Ellipsoid,
    /// `normal` is of unit length, in the world.
    Flat {
        outline: Outline,
        height: Height,
        normal: DVec3,
    },
    Cuboid,
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
    /// A shape in its place.
    pub fn new(geometry: Geometry, transform: Transform, material: MaterialChoice, casts_shadow: bool) -> Self {
        let kernel = match &geometry {
            Geometry::Flat(outline) => Kernel::Flat {
                outline: *outline,
                height: Height::of(&transform.to_object),
                normal: transform.normal_to_world(DVec3::Z),
            },
            Geometry::Sphere => transform.uniform_scale().map_or(Kernel::Ellipsoid, |radius| Kernel::Ball {
                centre: transform.to_world.translation,
                radius,
                inverse_radius: 1.0 / radius,
            }),
            Geometry::Cuboid => Kernel::Cuboid,
            Geometry::Mesh(mesh) => Kernel::Mesh(Arc::clone(mesh)),
        };
        Self { geometry, transform, material, casts_shadow, textured: true, kernel }
    }

    /// The nearest hit of a world ray in `(0, limit)`; `shape` is this primitive's number.
    pub fn intersect(&self, ray: &Ray, shape: u32, limit: f64) -> Option<Hit> {
        let mut nearest = Hit { t: limit, id: SurfaceId { shape: u32::MAX, part: 0 }, barycentric: [0.0; 3] };
        self.find_nearer(ray, shape, &mut nearest);
        (nearest.id.shape == shape).then_some(nearest)
    }

    /// Replaces the hit if this shape is hit at a smaller distance.
    #[inline(always)]
    pub fn find_nearer(&self, ray: &Ray, shape: u32, nearest: &mut Hit) {
        if let Kernel::Mesh(mesh) = &self.kernel {
            self.find_nearer_triangle(mesh, ray, shape, nearest);
        } else if let Some((t, part)) = self.analytic(ray, shape, nearest.t) {
            nearest.t = t;
            nearest.id = SurfaceId { shape, part };
        }
    }

    #[inline(never)]
    fn find_nearer_triangle(&self, mesh: &Mesh, ray: &Ray, shape: u32, nearest: &mut Hit) {
        let (origin, direction) = self.to_object(ray);
        let leaving = ray.leaves(shape).map(|departure| (departure.surface.part, departure.side));
        if let Some(hit) = mesh.intersect(origin, direction, nearest.t, leaving) {
            let id = SurfaceId { shape, part: hit.triangle };
            *nearest = Hit { t: hit.t, id, barycentric: hit.barycentric };
        }
    }

    /// True if anything is hit in `(0, limit)`.
    #[inline(always)]
    pub fn occludes(&self, ray: &Ray, shape: u32, limit: f64) -> bool {
        if let Kernel::Mesh(mesh) = &self.kernel {
            let (origin, direction) = self.to_object(ray);
            let leaving = ray.leaves(shape).map(|departure| (departure.surface.part, departure.side));
            return mesh.occluded(origin, direction, limit, leaving);
        }
        self.analytic(ray, shape, limit).is_some()
    }

    /// Distance and part of the nearest hit of a shape that is no mesh.
    #[inline(always)]
    fn analytic(&self, ray: &Ray, shape: u32, limit: f64) -> Option<(f64, u32)> {
        let leaving = ray.leaves(shape);
        let side = leaving.map(|departure| departure.side);
        match &self.kernel {
            // A sphere does not change when it is turned: only its place and size count.
            Kernel::Ball { centre, inverse_radius, .. } => {
                let (origin, direction) = ((ray.origin - *centre) * *inverse_radius, ray.direction * *inverse_radius);
                Some((sphere::intersect(origin, direction, limit, side, ray.origin_error())?, 0))
            }
            // A flat surface cannot be hit again by a ray that leaves it.
            Kernel::Flat { .. } if leaving.is_some() => None,
            Kernel::Flat { outline, height, .. } => {
                Some((outline.intersect(&self.transform.to_object, height, ray.origin, ray.direction, limit)?, 0))
            }
            Kernel::Ellipsoid | Kernel::Cuboid | Kernel::Mesh(_) => self.in_own_space(ray, leaving, limit),
        }
    }

    /// The same for shapes to whose own space the whole ray is carried.
    #[inline(never)]
    fn in_own_space(&self, ray: &Ray, leaving: Option<Departure>, limit: f64) -> Option<(f64, u32)> {
        let (origin, direction) = self.to_object(ray);
        match self.kernel {
            Kernel::Ellipsoid => {
                let side = leaving.map(|departure| departure.side);
                Some((sphere::intersect(origin, direction, limit, side, ray.origin_error())?, 0))
            }
            Kernel::Cuboid => cuboid::intersect(origin, direction, limit, leaving, ray.origin_error()),
            Kernel::Ball { .. } | Kernel::Flat { .. } | Kernel::Mesh(_) => None,
        }
    }

    /// Centre and radius in the world, if this is a sphere that its transform leaves round.
    pub fn as_ball(&self) -> Option<(DVec3, f64)> {
        match self.kernel {
            Kernel::Ball { centre, radius, .. } => Some((centre, radius)),
            _ => None,
        }
    }

    /// Unit normal in the world, if this is a flat shape.
    pub fn flat_normal(&self) -> Option<DVec3> {
        match self.kernel {
            Kernel::Flat { normal, .. } => Some(normal),
            _ => None,
        }
    }

    /// The surface where a ray hit this primitive. The point is put exactly onto the surface: what `ray.at(t)` lacks
    /// is the rounding of `t`.
    #[inline(always)]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        match &self.kernel {
            Kernel::Ball { centre, radius, .. } => {
                let normal = (ray.at(hit.t) - *centre).normalize();
                let place = || sphere::texture_coordinates(self.turned_to_object(normal));
                self.surface_at(*centre + normal * *radius, normal, place, hit)
            }
            Kernel::Flat { outline, normal, .. } => {
                let point = DVec3 { z: 0.0, ..self.object_point(ray, hit) };
                self.surface_at(self.to_world(point), *normal, || outline.texture_coordinates(point), hit)
            }
            Kernel::Ellipsoid => self.ellipsoid_surface(ray, hit),
            Kernel::Cuboid => self.cuboid_surface(ray, hit),
            Kernel::Mesh(mesh) => self.mesh_surface(mesh, hit),
        }
    }

    #[inline(never)]
    fn ellipsoid_surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let point = sphere::normal(self.object_point(ray, hit));
        let normal = self.transform.normal_to_world(point);
        self.surface_at(self.to_world(point), normal, || sphere::texture_coordinates(point), hit)
    }

    #[inline(never)]
    fn cuboid_surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let part = hit.id.part;
        let point = cuboid::onto_face(self.object_point(ray, hit), part);
        let normal = self.transform.normal_to_world(cuboid::normal(part));
        self.surface_at(self.to_world(point), normal, || cuboid::texture_coordinates(point, part), hit)
    }

    #[inline(always)]
    fn surface_at(&self, position: DVec3, normal: DVec3, place: impl FnOnce() -> DVec2, hit: &Hit) -> Surface {
        let texture_coordinates = if self.textured { place() } else { DVec2::ZERO };
        let material = self.material.of_group(0);
        Surface { position, normal, shading_normal: normal, texture_coordinates, material, id: hit.id }
    }

    #[inline(never)]
    fn mesh_surface(&self, mesh: &Mesh, hit: &Hit) -> Surface {
        let point = mesh.surface(hit.id.part, hit.barycentric);
        Surface {
            position: self.to_world(point.position),
            normal: self.transform.normal_to_world(point.geometric_normal),
            shading_normal: self.transform.normal_to_world(point.shading_normal),
            texture_coordinates: point.texture_coordinates.as_dvec2(),
            material: self.material.of_group(point.material),
            id: hit.id,
        }
    }

    fn to_world(&self, point: DVec3) -> DVec3 {
        self.transform.to_world.transform_point3(point)
    }

    fn object_point(&self, ray: &Ray, hit: &Hit) -> DVec3 {
        self.transform.to_object.transform_point3(ray.at(hit.t))
    }

    /// A world direction in the shape's own space; its length may change.
    fn turned_to_object(&self, direction: DVec3) -> DVec3 {
        self.transform.to_object.transform_vector3(direction)
    }

    #[inline(always)]
    fn to_object(&self, ray: &Ray) -> (DVec3, DVec3) {
        let to_object = &self.transform.to_object;
        (to_object.transform_point3(ray.origin), to_object.transform_vector3(ray.direction))
    }
}

impl MaterialChoice {
    /// The scene's numbers of all its materials.
    pub fn numbers(&self) -> &[u32] {
        match self {
            MaterialChoice::Whole(material) => std::slice::from_ref(material),
            MaterialChoice::PerGroup(materials) => materials,
        }
    }

    /// The scene's number of the material of a group.
    fn of_group(&self, group: u32) -> u32 {
        match self {
            MaterialChoice::Whole(material) => *material,
            MaterialChoice::PerGroup(materials) => materials[group as usize],
        }
    }
}
