//! Shapes as light sources: points on them, sampled as seen from the receiving point.
//!
//! Densities are by solid angle at the receiving point. An area `dA` at distance r, its normal at the angle theta to
//! the line of sight, is seen under the solid angle `dA cos(theta) / r^2`, so a density by area is divided by that.

mod cuboid;
mod disc;
mod ellipsoid;
mod mesh;
mod parallelogram;
mod rectangle_view;
mod shape_sample;

pub use shape_sample::ShapeSample;

use super::flat::Outline;
use super::mesh::Mesh;
use super::{Geometry, MaterialChoice, Primitive};
use crate::math::DVec3;
use cuboid::CuboidSampler;
use disc::DiscSampler;
use ellipsoid::EllipsoidSampler;
use mesh::MeshSampler;
use parallelogram::ParallelogramSampler;

/// Samples points on an emissive shape. Built once per emissive shape; holds all derived values.
///
/// Geometry alone counts here: a point is drawn on whichever side of the surface it is seen from. Whether that side
/// emits, the caller knows from `normal`; whether something is in between, from a shadow ray.
#[derive(Debug)]
pub struct ShapeSampler {
    form: Form,
    area: f64,
}

#[derive(Debug)]
enum Form {
    /// Nothing to draw from: a plane has no end, or no part of the shape gives light.
    Nothing,
    Ellipsoid(EllipsoidSampler),
    Parallelogram(ParallelogramSampler),
    Disc(DiscSampler),
    Cuboid(Box<CuboidSampler>),
    Mesh(MeshSampler),
}

impl ShapeSampler {
    /// A sampler of the parts of a shape whose material, by its number in the scene, gives light.
    pub fn new(primitive: &Primitive, emits: impl Fn(u32) -> bool) -> Self {
        let numbers = primitive.material.numbers();
        let form = match &primitive.geometry {
            Geometry::Mesh(mesh) => return Self::of_mesh(mesh, primitive, emits),
            _ if !emits(numbers[0]) => Form::Nothing,
            Geometry::Flat(Outline::Plane) => return Self { form: Form::Nothing, area: f64::INFINITY },
            Geometry::Flat(Outline::Disc) => Form::Disc(DiscSampler::new(&primitive.transform)),
            Geometry::Flat(Outline::Rectangle) => Form::Parallelogram(ParallelogramSampler::new(
                &primitive.transform.to_world,
                DVec3::X,
                DVec3::Y,
                DVec3::ZERO,
            )),
            Geometry::Sphere => Form::Ellipsoid(EllipsoidSampler::new(&primitive.transform)),
            Geometry::Cuboid => Form::Cuboid(Box::new(CuboidSampler::new(&primitive.transform))),
        };
        let area = form.area();
        Self { form, area }
    }

    fn of_mesh(mesh: &std::sync::Arc<Mesh>, primitive: &Primitive, emits: impl Fn(u32) -> bool) -> Self {
        let group_emits = |group: u32| match &primitive.material {
            MaterialChoice::Whole(material) => emits(*material),
            MaterialChoice::PerGroup(materials) => emits(materials[group as usize]),
        };
        let sampler = MeshSampler::new(mesh, &primitive.transform, group_emits);
        let area = sampler.area();
        Self { form: if area > 0.0 { Form::Mesh(sampler) } else { Form::Nothing }, area }
    }

    /// A point of the shape as seen from `point`, with its density by solid angle. `place` is uniform in `[0, 1)^2`,
    /// `choice`, uniform in `[0, 1)`, selects the face of a box or the triangle of a mesh. `None` if nothing of the
    /// shape can be seen: a flat shape edge-on, a plane (which has no end).
    #[inline]
    pub fn sample_towards(&self, point: DVec3, place: [f64; 2], choice: f64) -> Option<ShapeSample> {
        match &self.form {
            Form::Nothing => None,
            Form::Ellipsoid(ellipsoid) => ellipsoid.sample_towards(point, place),
            Form::Parallelogram(parallelogram) => parallelogram.sample_towards(point, place),
            Form::Disc(disc) => disc.sample_towards(point, place),
            Form::Cuboid(cuboid) => cuboid.sample_towards(point, place, choice),
            Form::Mesh(mesh) => mesh.sample_towards(point, place, choice),
        }
    }

    /// The density by solid angle with which [`ShapeSampler::sample_towards`] draws the unit direction from `point` to
    /// a hit on this shape, with the hit's position, true normal (of unit length, either side) and part. 0 for parts
    /// that are never drawn.
    #[inline]
    pub fn density_towards(
        &self,
        point: DVec3,
        direction: DVec3,
        hit_position: DVec3,
        hit_normal: DVec3,
        part: u32,
    ) -> f64 {
        let from_area = |area: f64| shape_sample::density_of_area(area, hit_position - point, hit_normal);
        match &self.form {
            Form::Nothing => 0.0,
            Form::Ellipsoid(ellipsoid) => ellipsoid.density_towards(point, direction),
            Form::Parallelogram(parallelogram) => {
                parallelogram.density_towards(point).unwrap_or_else(|| from_area(parallelogram.area()))
            }
            Form::Disc(disc) => from_area(disc.area()),
            Form::Cuboid(cuboid) => cuboid.density_towards(point, part, from_area),
            Form::Mesh(mesh) => {
                if mesh.draws(part) {
                    from_area(mesh.area())
                } else {
                    0.0
                }
            }
        }
    }

    /// Area of the surface in the world, of the parts that give light only; infinite for a plane. Exact but for
    /// ellipsoids, whose area is an integral computed to five digits.
    pub fn area(&self) -> f64 {
        self.area
    }
}

impl Form {
    fn area(&self) -> f64 {
        match self {
            Form::Nothing => 0.0,
            Form::Ellipsoid(ellipsoid) => ellipsoid.area(),
            Form::Parallelogram(parallelogram) => parallelogram.area(),
            Form::Disc(disc) => disc.area(),
            Form::Cuboid(cuboid) => cuboid.area(),
            Form::Mesh(mesh) => mesh.area(),
        }
    }
}
