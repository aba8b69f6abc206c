//! The solid angle of every texel of a face of the cube, in closed form.
//!
//! The face is the square `[-1, 1]^2` at distance 1. The part of it between its middle and the corner (x, y) is seen
//! under the solid angle `arctan(x y / sqrt(1 + x^2 + y^2))`, with the sign of x y; a texel is a difference of four.
//! (Van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983, for two right triangles.)

use crate::math::functions::arctan2;
use crate::parallel;

/// Solid angle of the rectangle on the face between its middle and (x, y).
pub(super) fn corner_solid_angle(x: f64, y: f64) -> f64 {
    arctan2(x * y, (1.0 + x * x + y * y).sqrt())
}

/// The solid angles of the texels of a face of `width` by `height`, in steradians.
#[derive(Debug, Clone)]
pub(super) struct TexelAngles {
    pub width: usize,
    pub height: usize,
    /// Of one quarter of the face, middle lines included: the others mirror it.
    quarter: Vec<f64>,
}

impl TexelAngles {
    pub(super) fn new(width: usize, height: usize) -> Self {
        let place = |texel: usize, count: usize| 2.0 * texel as f64 / count as f64 - 1.0;
        let (columns, rows) = (width.div_ceil(2), height.div_ceil(2));
        let mut corners = vec![0.0; (columns + 1) * (rows + 1)];
        parallel::for_each(corners.chunks_mut(columns + 1).enumerate(), |(row, corners)| {
            for (column, corner) in corners.iter_mut().enumerate() {
                *corner = corner_solid_angle(place(column, width), place(row, height));
            }
        });
        let mut quarter = vec![0.0; columns * rows];
        parallel::for_each(quarter.chunks_mut(columns).enumerate(), |(row, angles)| {
            let (upper, lower) = corners[row * (columns + 1)..].split_at(columns + 1);
            for (column, angle) in angles.iter_mut().enumerate() {
                *angle = (lower[column + 1] - lower[column]) - (upper[column + 1] - upper[column]);
            }
        });
        Self { width, height, quarter }
    }

    /// Solid angle of the texel in a column and row.
    #[inline]
    pub(super) fn of(&self, column: usize, row: usize) -> f64 {
        let (column, row) = (column.min(self.width - 1 - column), row.min(self.height - 1 - row));
        self.quarter[row * self.width.div_ceil(2) + column]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn six_faces_are_the_whole_sphere() {
        for (width, height) in [(1, 1), (2, 2), (3, 3), (64, 64), (33, 20), (1024, 1024)] {
            let angles = TexelAngles::new(width, height);
            let sum: f64 = (0..height)
                .flat_map(|row| (0..width).map(move |column| (column, row)))
                .map(|(c, r)| angles.of(c, r))
                .sum();
            assert!((6.0 * sum - 4.0 * PI).abs() < 1e-12, "{width} x {height}: {}", 6.0 * sum - 4.0 * PI);
        }
    }

    #[test]
    fn a_texel_agrees_with_numeric_integration() {
        let (width, height, steps) = (5, 4, 200);
        let angles = TexelAngles::new(width, height);
        for (column, row) in [(0, 0), (2, 1), (4, 3), (3, 0)] {
            // Midpoint rule over the texel: dA / (1 + x^2 + y^2)^(3/2).
            let (side_x, side_y) = (2.0 / width as f64, 2.0 / height as f64);
            let mut sum = 0.0;
            for i in 0..steps {
                for j in 0..steps {
                    let x = -1.0 + side_x * (column as f64 + (f64::from(i) + 0.5) / f64::from(steps));
                    let y = -1.0 + side_y * (row as f64 + (f64::from(j) + 0.5) / f64::from(steps));
                    let square = 1.0 + x * x + y * y;
                    sum += 1.0 / (square * square.sqrt());
                }
            }
            let numeric = sum * side_x * side_y / f64::from(steps * steps);
            assert!((angles.of(column, row) - numeric).abs() < 1e-6, "{column} {row}");
        }
    }
}
