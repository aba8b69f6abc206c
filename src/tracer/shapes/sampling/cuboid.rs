//! Boxes: one of the faces that can be seen, by its area; then a point of the face.

use super::ShapeSample;
use super::parallelogram::ParallelogramSampler;
use crate::math::{DVec3, Transform};
use crate::shapes::cuboid::normal;

/// Draws points of a box.
#[derive(Debug)]
pub(super) struct CuboidSampler {
    /// +x -x +y -y +z -z in the box's own space.
    faces: [ParallelogramSampler; 6],
}

impl CuboidSampler {
    pub(super) fn new(transform: &Transform) -> Self {
        let faces = std::array::from_fn(|face| {
            let outward = normal(face as u32);
            let right = DVec3::AXES[(face / 2 + 1) % 3];
            ParallelogramSampler::new(&transform.to_world, right, outward.cross(right), outward).with_part(face as u32)
        });
        Self { faces }
    }

    pub(super) fn area(&self) -> f64 {
        self.faces.iter().map(ParallelogramSampler::area).sum()
    }

    /// The areas of the faces that can be seen: outside those that look at the point, inside all.
    #[inline]
    fn seen_areas(&self, point: DVec3) -> [f64; 6] {
        let outer = self.faces.each_ref().map(|face| if face.height_of(point) > 0.0 { face.area() } else { 0.0 });
        if outer == [0.0; 6] { self.faces.each_ref().map(ParallelogramSampler::area) } else { outer }
    }

    #[inline]
    pub(super) fn sample_towards(&self, point: DVec3, place: [f64; 2], choice: f64) -> Option<ShapeSample> {
        let areas = self.seen_areas(point);
        let sum: f64 = areas.iter().sum();
        let mut left = choice * sum;
        let mut drawn = None;
        for (face, area) in areas.into_iter().enumerate().filter(|(_, area)| *area > 0.0) {
            // Rounding may leave a little after the last face: then it is the last one.
            drawn = Some(face);
            if left < area {
                break;
            }
            left -= area;
        }
        let face = drawn?;
        let sample = self.faces[face].sample_towards(point, place)?;
        Some(ShapeSample { density: sample.density * (areas[face] / sum), ..sample })
    }

    #[inline]
    pub(super) fn density_towards(&self, point: DVec3, part: u32, from_area: impl Fn(f64) -> f64) -> f64 {
        let areas = self.seen_areas(point);
        let share = areas[part as usize] / areas.iter().sum::<f64>();
        if share == 0.0 {
            return 0.0;
        }
        let face = &self.faces[part as usize];
        share * face.density_towards(point).unwrap_or_else(|| from_area(face.area()))
    }
}
