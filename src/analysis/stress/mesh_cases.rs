//! Triangles: hit points of slivers, meshes far away, leaks.

use std::sync::Arc;

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, faults_of, worst_of};
use super::octasphere::stretched;
use super::placed::placed;
use super::reference::{WideRay, distance, point_at, ulp_f32};
use super::wide_vector::WideVector;
use crate::limits::{Range, VERTEX_REMOTENESS};
use crate::math::{DVec3, Ray, Vec3};
use crate::shapes::mesh::{Mesh, MeshGeometry};
use crate::shapes::{Geometry, Primitive};

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Shapes,
        name: "slivers",
        swept: "length / width of a triangle",
        error: "hit point, in f32 ulp of the distance; infinite if missed",
        unit: "ulp",
        bound: 4.0,
        promised: Range::new(1.0, 1e6),
        sweep: slivers,
    },
    Subject {
        group: Group::Shapes,
        name: "mesh-placed",
        swept: "coordinate of details of 1e-2",
        error: "hit point of a mesh that a transform moves there, in details",
        unit: "detail",
        bound: 1e-3,
        promised: Range::new(1.0, 1e6),
        sweep: mesh_placed,
    },
    Subject {
        group: Group::Shapes,
        name: "mesh-vertices",
        swept: "coordinate / size of a mesh",
        error: "hit point where the f32 vertices themselves lie there, in sizes of the mesh",
        unit: "size",
        bound: 1e-3,
        promised: Range::new(1.0, VERTEX_REMOTENESS.range.most),
        sweep: mesh_vertices,
    },
    Subject {
        group: Group::Shapes,
        name: "leaks-size",
        swept: "size of a closed mesh",
        error: "rays from inside that get out, per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1e-6, 1e6),
        sweep: leaks_by_size,
    },
    Subject {
        group: Group::Shapes,
        name: "leaks-needle",
        swept: "length / width, closed mesh",
        error: "rays from inside that get out, per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1.0, 1e6),
        sweep: leaks_by_aspect,
    },
    Subject {
        group: Group::Shapes,
        name: "leaks-place",
        swept: "coordinate / size, closed",
        error: "rays from inside that get out, per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1.0, 1e6),
        sweep: leaks_by_place,
    },
];

/// Distance between the hit on a mesh and the true point of the plane of the triangle that was hit.
fn mesh_error(primitive: &Primitive, mesh: &Mesh, ray: &Ray) -> f64 {
    let Some(hit) = primitive.intersect(ray, 0, f64::INFINITY) else { return f64::INFINITY };
    let [a, b, c] = mesh.geometry().corners(hit.id.part).map(|corner| WideVector::from(corner.as_dvec3()));
    let normal = (b - a).cross(c - a);
    let local = WideRay::in_space_of(&primitive.transform, ray);
    let parameter = normal.dot(a - local.origin) / normal.dot(local.direction);
    distance(primitive.surface(ray, &hit).position, point_at(ray, parameter))
}

fn slivers(effort: Effort) -> Vec<Measurement> {
    let of_aspect = |aspect: f64| {
        let (error, far) = worst_of(effort.share(5e-4), aspect.to_bits(), |random| {
            let along = random.direction();
            let across = along.any_orthonormal_vector() / aspect;
            let place = random.in_ball();
            let corners = [place, place + along, place + along * random.unit() + across].map(DVec3::as_vec3);
            let geometry =
                MeshGeometry { positions: corners.to_vec(), triangles: vec![[0, 1, 2]], ..MeshGeometry::default() };
            let Ok(mesh) = Mesh::new(geometry).map(Arc::new) else { return (0.0, 0.0) };
            let [a, b, c] = corners.map(|corner| corner.as_dvec3());
            let target = a * 0.3 + b * 0.4 + c * 0.3;
            let normal = (b - a).cross(c - a).normalize();
            let far = random.decade(-1, 3);
            let origin = target + (normal + random.in_ball() * 0.5).normalize() * far;
            let primitive = placed(Geometry::Mesh(mesh.clone()), DVec3::ZERO, DVec3::ZERO, DVec3::ONE);
            let ray = Ray::new(origin, (target - origin).normalize());
            (mesh_error(&primitive, &mesh, &ray) / ulp_f32(far.max(1.0)), far)
        });
        Measurement::new(aspect, error, format!("seen from {far:.0e}"))
    };
    decades(0, 7).map(of_aspect).collect()
}

/// The unit octasphere with triangles of about 0.1, placed so that they are 1e-2 large.
fn mesh_placed(effort: Effort) -> Vec<Measurement> {
    let mesh = Arc::new(Mesh::new(stretched(16, Vec3::ONE, Vec3::ZERO)).expect("a mesh"));
    let of_place = |place: f64| {
        let (error, ()) = worst_of(effort.share(5e-4), place.to_bits(), |random| {
            let (translate, turn) = (random.direction() * place, random.in_ball() * 180.0);
            let primitive = placed(Geometry::Mesh(mesh.clone()), translate, turn, DVec3::splat(0.1));
            let origin = translate + random.direction();
            let target = translate + random.in_ball() * 0.05;
            (mesh_error(&primitive, &mesh, &Ray::new(origin, (target - origin).normalize())) / 1e-2, ())
        });
        Measurement::new(place, error, "512 triangles of 1e-2")
    };
    decades(0, 14).map(of_place).collect()
}

/// The same with the vertices themselves moved: against the mesh before it was moved.
fn mesh_vertices(effort: Effort) -> Vec<Measurement> {
    let near = Arc::new(Mesh::new(stretched(4, Vec3::splat(0.5), Vec3::ZERO)).expect("a mesh"));
    let of_place = |place: f64| {
        let offset = Vec3::new(place as f32, 0.25, -0.5);
        let far = Mesh::new(stretched(4, Vec3::splat(0.5), offset)).map(Arc::new);
        let Ok(far) = far else { return Measurement::new(place, f64::INFINITY, "no triangle is left") };
        let at = |mesh: &Arc<Mesh>| placed(Geometry::Mesh(mesh.clone()), DVec3::ZERO, DVec3::ZERO, DVec3::ONE);
        let (near, far) = (at(&near), at(&far));
        let (error, ()) = worst_of(effort.share(5e-4), place.to_bits(), |random| {
            let origin = random.direction() * 5.0;
            let ray = Ray::new(origin, (random.in_ball() * 0.2 - origin).normalize());
            let moved = Ray::new(ray.origin + offset.as_dvec3(), ray.direction);
            let point = |shape: &Primitive, ray: &Ray| {
                let hit = shape.intersect(ray, 0, f64::INFINITY)?;
                Some(shape.surface(ray, &hit).position)
            };
            let error = match (point(&near, &ray), point(&far, &moved)) {
                (Some(near), Some(far)) => (far - near - offset.as_dvec3()).length(),
                _ => f64::INFINITY,
            };
            (error, ())
        });
        Measurement::new(place, error, "128 triangles of 0.2")
    };
    decades(0, 9).map(of_place).collect()
}

/// Rays that get out of a closed mesh per million: random ones, and ones aimed at points of edges and at vertices.
fn leaks(effort: Effort, magnitude: f64, scale: Vec3, offset: Vec3) -> Measurement {
    let Ok(mesh) = Mesh::new(stretched(6, scale, offset)) else {
        return Measurement::new(magnitude, 1e6, "no triangle is left");
    };
    let centre = offset.as_dvec3();
    let (faults, first) = faults_of(effort.share(4e-3), magnitude.to_bits(), |random| {
        let origin = centre + random.in_ball() * scale.as_dvec3() * 0.4;
        let corners = mesh.geometry().corners(random.below(mesh.geometry().triangles.len()) as u32);
        let [a, b, _] = corners.map(|corner| corner.as_dvec3());
        let (what, target) = match random.below(4) {
            0 => ("at a vertex", a),
            1 => ("at an edge", a.lerp(b, random.unit())),
            2 => ("along an axis", origin + DVec3::AXES[random.below(3)] * scale.as_dvec3().max_element()),
            _ => ("at random", origin + random.direction() * scale.as_dvec3()),
        };
        let direction = target - origin;
        (direction != DVec3::ZERO && mesh.intersect(origin, direction, f64::INFINITY, None).is_none()).then_some(what)
    });
    Measurement::new(magnitude, faults, first.unwrap_or("none leaks"))
}

fn leaks_by_size(effort: Effort) -> Vec<Measurement> {
    decades(-15, 11).map(|size| leaks(effort, size, Vec3::splat(size as f32), Vec3::ZERO)).collect()
}

fn leaks_by_aspect(effort: Effort) -> Vec<Measurement> {
    let of_aspect = |aspect: f64| {
        let root = aspect.sqrt() as f32;
        leaks(effort, aspect, Vec3::new(1.0 / root, 1.0, root), Vec3::ZERO)
    };
    decades(0, 12).map(of_aspect).collect()
}

fn leaks_by_place(effort: Effort) -> Vec<Measurement> {
    // Powers of two, so that the middle of the mesh lies where it should.
    decades(0, 8).map(|place| leaks(effort, place, Vec3::ONE, Vec3::new(place as f32, 0.0, -place as f32))).collect()
}
