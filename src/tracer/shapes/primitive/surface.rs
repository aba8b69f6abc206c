//! The surface where a ray met a shape placed in the world.

use super::super::mesh::Mesh;
use super::super::{cuboid, sphere};
use super::{Hit, Kernel, Primitive, Surface, TexturePoint};
use crate::math::{DVec2, DVec3, Ray};

impl Primitive {
    /// The surface where a ray hit this primitive. The point is put exactly onto the surface: what `ray.at(t)` lacks
    /// is the rounding of `t`.
    #[inline(always)]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.with_surface(ray, hit, |surface| surface)
    }

    /// Passes that surface to `then`, which is compiled for each kind of shape: the numbers can stay in registers.
    #[inline(always)]
    pub fn with_surface<R>(&self, ray: &Ray, hit: &Hit, then: impl FnOnce(Surface) -> R) -> R {
        match &self.kernel {
            Kernel::RoundSphere { centre, radius, .. } => {
                let normal = (ray.at(hit.t) - *centre).normalize();
                let place = || sphere::texture_coordinates(self.turned_to_object(normal));
                then(self.surface_at(*centre + normal * *radius, normal, place, hit))
            }
            Kernel::Flat { outline, normal, .. } => {
                let point = DVec3 { z: 0.0, ..self.object_point(ray, hit) };
                then(self.surface_at(self.to_world(point), *normal, || outline.texture_coordinates(point), hit))
            }
            Kernel::Ellipsoid => then(self.ellipsoid_surface(*ray, *hit)),
            Kernel::Cuboid => then(self.cuboid_surface(*ray, *hit)),
            Kernel::Mesh(mesh) => then(self.mesh_surface(mesh, *hit)),
        }
    }

    #[inline(never)]
    fn ellipsoid_surface(&self, ray: Ray, hit: Hit) -> Surface {
        let point = sphere::normal(self.object_point(&ray, &hit));
        let normal = self.transform.normal_to_world(point);
        self.surface_at(self.to_world(point), normal, || sphere::texture_coordinates(point), &hit)
    }

    #[inline(never)]
    fn cuboid_surface(&self, ray: Ray, hit: Hit) -> Surface {
        let part = hit.id.part;
        let point = cuboid::onto_face(self.object_point(&ray, &hit), part);
        let normal = self.transform.normal_to_world(cuboid::normal(part));
        self.surface_at(self.to_world(point), normal, || cuboid::texture_coordinates(point, part), &hit)
    }

    #[inline(always)]
    fn surface_at(&self, position: DVec3, normal: DVec3, place: impl FnOnce() -> DVec2, hit: &Hit) -> Surface {
        let coordinates = if self.textured { place() } else { DVec2::ZERO };
        let texture = TexturePoint { coordinates, ..TexturePoint::default() };
        let material = self.material.of_group(0);
        Surface { position, normal, shading_normal: normal, texture, material, id: hit.id }
    }

    #[inline(never)]
    fn mesh_surface(&self, mesh: &Mesh, hit: Hit) -> Surface {
        let point = mesh.surface(hit.id.part, hit.barycentric);
        Surface {
            position: self.to_world(point.position),
            normal: self.transform.normal_to_world(point.geometric_normal),
            shading_normal: self.transform.normal_to_world(point.shading_normal),
            texture: TexturePoint {
                coordinates: point.texture_coordinates.as_dvec2(),
                vertex_colour: point.vertex_colour,
            },
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
}
