//! Rectangles, and parallelograms that uneven scales make of them.

use super::ShapeSample;
use super::rectangle_view::RectangleView;
use crate::math::{DAffine3, DVec3};

/// Solid angle, in steradians, below which a rectangle is drawn from by area: the excess of four angles near pi has then lost
/// too many digits, and the density by area hardly varies.
const SMALL: f64 = 1e-5;

/// Draws points of a parallelogram: uniform by solid angle if its angles are right, by area otherwise.
#[derive(Debug)]
pub(super) struct ParallelogramSampler {
    corner: DVec3,
    /// From the corner along both sides.
    edges: [DVec3; 2],
    lengths: [f64; 2],
    /// Unit directions of the sides and the unit normal of the front.
    axes: [DVec3; 2],
    normal: DVec3,
    area: f64,
    is_rectangle: bool,
    part: u32,
}

impl ParallelogramSampler {
    /// The square `middle +- right +- up` of the shape's own space; its front is where `right x up` points there.
    pub(super) fn new(to_world: &DAffine3, right: DVec3, up: DVec3, middle: DVec3) -> Self {
        let edges = [right, up].map(|axis| to_world.transform_vector3(2.0 * axis));
        let lengths = edges.map(DVec3::length);
        let area_vector = edges[0].cross(edges[1]);
        // A map that mirrors turns the product round, not the front.
        let normal = area_vector.normalize() * to_world.matrix3.determinant().signum();
        let is_rectangle = edges[0].dot(edges[1]).abs() <= 1e-12 * lengths[0] * lengths[1];
        Self {
            corner: to_world.transform_point3(middle - right - up),
            edges,
            lengths,
            axes: [edges[0] / lengths[0], edges[1] / lengths[1]],
            normal,
            area: area_vector.length(),
            is_rectangle,
            part: 0,
        }
    }

    /// The same as a numbered part of a shape.
    pub(super) fn with_part(self, part: u32) -> Self {
        Self { part, ..self }
    }

    pub(super) fn area(&self) -> f64 {
        self.area
    }

    /// Height of a point above the front.
    #[inline]
    pub(super) fn height_of(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.corner)
    }

    #[inline]
    pub(super) fn sample_towards(&self, point: DVec3, place: [f64; 2]) -> Option<ShapeSample> {
        let Some(view) = self.view(point) else {
            let position = self.at(place);
            return ShapeSample::by_area(point, position, self.normal, self.area, self.part);
        };
        let start = self.start(point);
        let drawn = view.draw(place);
        let position = self.at([0, 1].map(|axis| (drawn[axis] - start[axis]) / self.lengths[axis]));
        ShapeSample::with_density(position - point, position, self.normal, 1.0 / view.solid_angle, self.part)
    }

    /// The density, if it is the same in all directions; `None` if points are drawn by area.
    #[inline]
    pub(super) fn density_towards(&self, point: DVec3) -> Option<f64> {
        self.view(point).map(|view| 1.0 / view.solid_angle)
    }

    /// The rectangle as seen from the point; `None` if it is none or too small.
    #[inline]
    fn view(&self, point: DVec3) -> Option<RectangleView> {
        if !self.is_rectangle {
            return None;
        }
        let [x, y] = self.start(point);
        let depth = self.height_of(point).abs();
        let view = RectangleView::new([x, x + self.lengths[0]], [y, y + self.lengths[1]], depth);
        (view.solid_angle >= SMALL).then_some(view)
    }

    /// Coordinates of the corner along the sides, the point being the origin.
    #[inline]
    fn start(&self, point: DVec3) -> [f64; 2] {
        self.axes.map(|axis| axis.dot(self.corner - point))
    }

    #[inline]
    fn at(&self, place: [f64; 2]) -> DVec3 {
        self.corner + self.edges[0] * place[0] + self.edges[1] * place[1]
    }
}
