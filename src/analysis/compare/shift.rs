//! The shift of a picture, to a fraction of a pixel.

use crate::math::Vec3;
use crate::metrics::{Plane, gaussian};
use crate::picture::Raster;

/// Differences above this are not shifts but other contents, and do not count.
const OUTLIER: f32 = 0.15;
/// Shifts that are this near to a whole or half pixel are taken for it.
const SNAP: f64 = 0.12;
/// The smallest shift that is named.
const SMALLEST: f64 = 0.2;
/// How many times smaller the difference must be without the shift.
const DECISIVE: f64 = 1.3;

/// The shift of mine against the expected picture, x and y in pixels: mine shows at `p + shift` what the expected one
/// shows at `p`. None if there is none within `reach` of `start`, or no shift explains much.
///
/// Lucas and Kanade, An Iterative Image Registration Technique, 1981, for one translation of the whole picture, with
/// the gradients of the expected picture (Baker and Matthews, Lucas-Kanade 20 Years On, 2004, inverse composition).
pub(super) fn estimated(mine: &Plane, expected: &Plane, start: [f64; 2], reach: f64) -> Option<[f64; 2]> {
    let kernel = gaussian(1.0, 3);
    let smooth = |plane: &Plane| plane.filtered(&kernel, &kernel);
    let (mine, expected) = (smooth(mine), smooth(expected));
    let shift = refined(&mine, &expected, start, reach)?.map(snapped);
    let length = (shift[0] * shift[0] + shift[1] * shift[1]).sqrt();
    let decisive = || difference(&mine, &expected, [0.0; 2]) > DECISIVE * difference(&mine, &expected, shift) + 5e-4;
    (length >= SMALLEST && decisive()).then_some(shift)
}

fn snapped(shift: f64) -> f64 {
    let half = (2.0 * shift).round() / 2.0;
    let snapped = if (shift - half).abs() <= SNAP { half } else { (shift * 10.0).round() / 10.0 };
    // No negative zero.
    snapped + 0.0
}

/// Steps towards the shift of least squared difference. None if the picture has no detail to hold on to.
fn refined(mine: &Plane, expected: &Plane, start: [f64; 2], reach: f64) -> Option<[f64; 2]> {
    let mut shift = start;
    for _ in 0..20 {
        let step = step(mine, expected, shift)?;
        shift = [shift[0] - step[0], shift[1] - step[1]];
        if step.iter().all(|step| step.abs() < 2e-3) {
            break;
        }
    }
    let size = [expected.width(), expected.height()];
    // Half of the picture is left to compare.
    let far = |axis: usize| (shift[axis] - start[axis]).abs() > reach || 2.0 * shift[axis].abs() > size[axis] as f64;
    if far(0) || far(1) { None } else { Some(shift) }
}

/// One step: the solution of `(sum of g g^T) step = sum of g e`, g the gradient and e the difference.
fn step(mine: &Plane, expected: &Plane, shift: [f64; 2]) -> Option<[f64; 2]> {
    let [mut xx, mut xy, mut yy, mut xe, mut ye] = [0.0f64; 5];
    each_pixel(mine, expected, shift, |x, y, error| {
        if error.abs() > OUTLIER {
            return;
        }
        let across = f64::from(expected.at(x + 1, y) - expected.at(x - 1, y)) / 2.0;
        let down = f64::from(expected.at(x, y + 1) - expected.at(x, y - 1)) / 2.0;
        let error = f64::from(error);
        xx += across * across;
        xy += across * down;
        yy += down * down;
        xe += across * error;
        ye += down * error;
    });
    let determinant = xx * yy - xy * xy;
    // A picture of parallel stripes leaves the shift along them open.
    if determinant <= 1e-3 * xx * yy || determinant <= 0.0 {
        return None;
    }
    let step = [(yy * xe - xy * ye) / determinant, (xx * ye - xy * xe) / determinant];
    Some(step.map(|step| step.clamp(-2.0, 2.0)))
}

/// The mean absolute difference of mine, shifted back, and the expected plane; without limit where they do not overlap.
fn difference(mine: &Plane, expected: &Plane, shift: [f64; 2]) -> f64 {
    let (mut sum, mut count) = (0.0, 0usize);
    each_pixel(mine, expected, shift, |_, _, error| {
        sum += f64::from(error.abs());
        count += 1;
    });
    if count == 0 { f64::INFINITY } else { sum / count as f64 }
}

/// Calls with column, row and `mine(p + shift) - expected(p)`, one pixel off the border and where mine is.
fn each_pixel(mine: &Plane, expected: &Plane, shift: [f64; 2], mut call: impl FnMut(usize, usize, f32)) {
    let (whole, part) = split(shift);
    let (columns, rows) = (overlap(whole[0], expected.width(), 1), overlap(whole[1], expected.height(), 1));
    let (h, v) = (part[0] as f32, part[1] as f32);
    for y in rows {
        let row = (y as i64 + whole[1]) as usize;
        for x in columns.clone() {
            let column = (x as i64 + whole[0]) as usize;
            let line = |row: usize| (1.0 - h) * mine.at(column, row) + h * mine.at(column + 1, row);
            call(x, y, (1.0 - v) * line(row) + v * line(row + 1) - expected.at(x, y));
        }
    }
}

/// The whole part of a shift, and the rest in `[0, 1)`.
fn split(shift: [f64; 2]) -> ([i64; 2], [f64; 2]) {
    (shift.map(|shift| shift.floor() as i64), shift.map(|shift| shift - shift.floor()))
}

/// The places of the expected picture, `margin` off its border, around which mine has `margin` pixels to each side and
/// one more after them.
fn overlap(whole: i64, length: usize, margin: i64) -> std::ops::Range<usize> {
    let start = margin.max(margin - whole);
    let end = (length as i64 - margin).min(length as i64 - margin - 1 - whole).max(start);
    start as usize..end as usize
}

/// Mine shifted back and the expected picture, both cut to what they share; and where the left top corner of the cut
/// lies in the expected picture. Between pixels mine is interpolated by cubics (Keys, 1981).
pub(super) fn undone(mine: &Raster, expected: &Raster, shift: [f64; 2]) -> (Raster, Raster, [usize; 2]) {
    let (whole, part) = split(shift);
    let margin = if part == [0.0; 2] { 0 } else { 1 };
    let (columns, rows) = if margin == 0 {
        (shared(whole[0], expected.width()), shared(whole[1], expected.height()))
    } else {
        (overlap(whole[0], expected.width(), 1), overlap(whole[1], expected.height(), 1))
    };
    let (across, down) = (cubic_weights(part[0]), cubic_weights(part[1]));
    let moved = Raster::from_function(columns.len(), rows.len(), |x, y| {
        let column = (x + columns.start) as i64 + whole[0];
        let row = (y + rows.start) as i64 + whole[1];
        if margin == 0 {
            return mine.pixel(column as usize, row as usize);
        }
        let last = |length: usize| length as i64 - 1;
        let pixel = |x: i64, y: i64| {
            mine.pixel(x.clamp(0, last(mine.width())) as usize, y.clamp(0, last(mine.height())) as usize)
        };
        let mut sum = Vec3::ZERO;
        for (j, v) in down.iter().enumerate() {
            for (i, h) in across.iter().enumerate() {
                sum += pixel(column + i as i64 - 1, row + j as i64 - 1) * (h * v);
            }
        }
        sum.max(Vec3::ZERO)
    });
    let cut =
        Raster::from_function(columns.len(), rows.len(), |x, y| expected.pixel(x + columns.start, y + rows.start));
    (moved, cut, [columns.start, rows.start])
}

/// The places where both are, for a shift by whole pixels.
fn shared(whole: i64, length: usize) -> std::ops::Range<usize> {
    let length = length as i64;
    (-whole).clamp(0, length) as usize..(length - whole).clamp(0, length) as usize
}

/// What the pixels at -1, 0, 1 and 2 count for a point at `t` in `[0, 1)` (Keys, Cubic Convolution, a = -1/2).
fn cubic_weights(t: f64) -> [f32; 4] {
    let (square, cube) = (t * t, t * t * t);
    [
        -0.5 * cube + square - 0.5 * t,
        1.5 * cube - 2.5 * square + 1.0,
        -1.5 * cube + 2.0 * square + 0.5 * t,
        0.5 * cube - 0.5 * square,
    ]
    .map(|weight| weight as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A scene in closed form, seen with an offset.
    fn scene(offset: [f64; 2]) -> Plane {
        let values = (0..90 * 120).map(|index| {
            let (x, y) = ((index % 120) as f64 + offset[0], (index / 120) as f64 + offset[1]);
            (0.5 + 0.2 * (x / 5.0).sin() * (y / 7.0).cos() + 0.1 * (x / 11.0 + y / 4.0).sin()) as f32
        });
        Plane::new(120, 90, values.collect())
    }

    #[test]
    fn finds_what_it_was_shifted_by() {
        for shift in [[1.0, 0.0], [0.5, 0.5], [-0.5, 0.0], [3.0, -2.0], [0.3, -1.3]] {
            // What the expected scene has at p, mine has at p + shift.
            let found = estimated(&scene([-shift[0], -shift[1]]), &scene([0.0; 2]), [0.0; 2], 4.0).unwrap();
            for axis in 0..2 {
                assert!((found[axis] - shift[axis]).abs() < 0.06, "{found:?} for {shift:?}");
            }
        }
        assert_eq!(estimated(&scene([0.0; 2]), &scene([0.0; 2]), [0.0; 2], 4.0), None);
    }

    #[test]
    fn strips_are_no_further_apart_than_they_are_high() {
        let strip = |offset: f64, height: usize| {
            let value = |index: usize| (((index % 120) as f64 + offset) / 5.0).sin() as f32 * 0.2 + 0.5;
            Plane::new(120, height, (0..120 * height).map(value).collect())
        };
        for height in [1, 2, 3, 5] {
            let found = estimated(&strip(2.0, height), &strip(0.0, height), [0.0, 4.0], 4.0);
            assert!(found.is_none_or(|shift| 2.0 * shift[1].abs() <= height as f64), "{found:?}");
        }
        assert_eq!(difference(&strip(0.0, 3), &strip(0.0, 3), [0.0, 7.0]), f64::INFINITY);
    }

    #[test]
    fn whole_shifts_are_undone_exactly_and_cut_to_the_overlap() {
        let raster = |dx: i64, dy: i64| {
            Raster::from_function(9, 7, |x, y| Vec3::new((x as i64 - dx) as f32, (y as i64 - dy) as f32, 0.0))
        };
        let (moved, cut, corner) = undone(&raster(2, -1), &raster(0, 0), [2.0, -1.0]);
        assert_eq!((moved.width(), moved.height(), corner), (7, 6, [0, 1]));
        assert_eq!(moved, cut);
    }

    #[test]
    fn cubic_interpolation_keeps_parabolas() {
        for t in [0.0, 0.25, 0.5, 0.9] {
            let sum: f64 =
                cubic_weights(t).iter().enumerate().map(|(i, &w)| f64::from(w) * (i as f64 - 1.0).powi(2)).sum();
            assert!((sum - t * t).abs() < 1e-6);
        }
    }
}
