//! Intersection of a ray and a shape placed in the world.
//!
//! Rare cases are separate functions that take copies of rays and hits: an argument by reference would have to lie in
//! memory, for all other rays, too.

use super::super::flat::{Height, Outline};
use super::super::mesh::Mesh;
use super::super::{cuboid, sphere};
use super::{Hit, Kernel, Primitive};
use crate::math::{DVec3, Departure, Ray, SurfaceId};

impl Primitive {
    /// The nearest hit of a world ray in `(0, limit)`; `shape` is this primitive's number.
    pub fn intersect(&self, ray: &Ray, shape: u32, limit: f64) -> Option<Hit> {
        if let Kernel::Mesh(mesh) = &self.kernel {
            return self.nearer_triangle(mesh, ray, shape, limit);
        }
        let (t, part) = self.intersect_simple(ray, shape, limit)?;
        Some(Hit { t, id: SurfaceId { shape, part }, barycentric: [0.0; 3] })
    }

    /// The hit of this shape if it is nearer than a hit known, otherwise that one. Of two at the same distance the shape with
    /// the lower number shows.
    #[inline(always)]
    pub fn nearer(&self, ray: &Ray, shape: u32, nearest: Hit) -> Hit {
        let limit = if shape < nearest.id.shape { nearest.t.next_up() } else { nearest.t };
        if let Kernel::Mesh(mesh) = &self.kernel {
            return self.nearer_triangle(mesh, ray, shape, limit).unwrap_or(nearest);
        }
        match self.intersect_simple(ray, shape, limit) {
            Some((t, part)) => Hit { t, id: SurfaceId { shape, part }, barycentric: [0.0; 3] },
            None => nearest,
        }
    }

    #[inline(never)]
    fn nearer_triangle(&self, mesh: &Mesh, ray: &Ray, shape: u32, limit: f64) -> Option<Hit> {
        let (origin, direction) = self.to_object(ray);
        let leaving = ray.leaves(shape).map(|departure| (departure.surface.part, departure.side));
        let hit = mesh.intersect(origin, direction, limit, leaving)?;
        let id = SurfaceId { shape, part: hit.triangle };
        Some(Hit { t: hit.t, id, barycentric: hit.barycentric })
    }

    /// True if anything is hit in `(0, limit)`.
    #[inline(always)]
    pub fn occludes(&self, ray: &Ray, shape: u32, limit: f64) -> bool {
        if let Kernel::Mesh(mesh) = &self.kernel {
            let (origin, direction) = self.to_object(ray);
            let leaving = ray.leaves(shape).map(|departure| (departure.surface.part, departure.side));
            return mesh.occluded(origin, direction, limit, leaving);
        }
        self.intersect_simple(ray, shape, limit).is_some()
    }

    /// Distance and part of the nearest hit in `(0, limit)` of a shape other than a mesh; `None` for meshes. Quick for
    /// round and flat shapes.
    #[inline(always)]
    fn intersect_simple(&self, ray: &Ray, shape: u32, limit: f64) -> Option<(f64, u32)> {
        match &self.kernel {
            // A sphere does not change when it is turned: only its place and size count.
            Kernel::RoundSphere { centre, inverse_radius, .. } => {
                let (origin, direction) = ((ray.origin - *centre) * *inverse_radius, ray.direction * *inverse_radius);
                let side = ray.leaves(shape).map(|departure| departure.side);
                Some((sphere::intersect(origin, direction, limit, side, ray.origin_error())?, 0))
            }
            Kernel::Flat { outline, height, .. } => self.intersect_flat(*outline, height, ray, shape, limit),
            Kernel::Ellipsoid | Kernel::Cuboid | Kernel::Mesh(_) => self.in_own_space(*ray, ray.leaves(shape), limit),
        }
    }

    /// The same, quick for flat shapes alone.
    #[inline(always)]
    pub fn intersect_mostly_flat(&self, ray: &Ray, shape: u32, limit: f64) -> Option<(f64, u32)> {
        match &self.kernel {
            Kernel::Flat { outline, height, .. } => self.intersect_flat(*outline, height, ray, shape, limit),
            _ => self.intersect_not_flat(*ray, shape, limit),
        }
    }

    #[inline(never)]
    fn intersect_not_flat(&self, ray: Ray, shape: u32, limit: f64) -> Option<(f64, u32)> {
        self.intersect_simple(&ray, shape, limit)
    }

    #[inline(always)]
    fn intersect_flat(
        &self,
        outline: Outline,
        height: &Height,
        ray: &Ray,
        shape: u32,
        limit: f64,
    ) -> Option<(f64, u32)> {
        // A flat surface cannot be hit again by a ray that leaves it.
        if ray.leaves(shape).is_some() {
            return None;
        }
        Some((outline.intersect(&self.transform.to_object, height, ray.origin, ray.direction, limit)?, 0))
    }

    /// The same for shapes to whose own space the whole ray is carried.
    #[inline(never)]
    fn in_own_space(&self, ray: Ray, leaving: Option<Departure>, limit: f64) -> Option<(f64, u32)> {
        let (origin, direction) = self.to_object(&ray);
        match self.kernel {
            Kernel::Ellipsoid => {
                let side = leaving.map(|departure| departure.side);
                Some((sphere::intersect(origin, direction, limit, side, ray.origin_error())?, 0))
            }
            Kernel::Cuboid => cuboid::intersect(origin, direction, limit, leaving, ray.origin_error()),
            Kernel::RoundSphere { .. } | Kernel::Flat { .. } | Kernel::Mesh(_) => None,
        }
    }

    #[inline(always)]
    fn to_object(&self, ray: &Ray) -> (DVec3, DVec3) {
        let to_object = &self.transform.to_object;
        (to_object.transform_point3(ray.origin), to_object.transform_vector3(ray.direction))
    }
}
