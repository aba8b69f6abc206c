//! The mean brightness of each texel after filtering.
//!
//! Between texel centres the radiance is interpolated, so a dark texel beside a bright one is not dark. The sampler
//! uses the mean over the texel's square. Along one axis the filtered value is `(1 - s) a + s b` between the centres of
//! a and b; over half a texel, s from 0 to 1/2, the mean share of the neighbour is 1/4, and a texel has two halves:
//!
//! ```text
//!     a     |     b     |     c        mean over b = 1/2 (3/4 b + 1/4 a) + 1/2 (3/4 b + 1/4 c) = (a + 6 b + c) / 8
//! ```
//!
//! In the plane the shares multiply: 36/64 for the texel, 6/64 for the four beside it, 1/64 for the four at its corners.

use crate::colour::luminance;
use crate::math::Vec3;
use crate::parallel;
use crate::picture::Picture;

/// What a texel beyond the left border of the first or the right border of the last column is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beyond {
    /// The border texel again.
    Border,
    /// The texel at the other end of the row.
    OtherEnd,
}

/// So bright that sums of the weights of any picture stay finite.
const BRIGHTEST: f32 = 1e34;

/// The luminance by which a direction is weighed: that of the absolute values. It is positive wherever the radiance is
/// not zero, also for colours outside the gamut, of which a component is negative. What is not a number counts as 0.
pub(super) fn weighed_luminance(colour: Vec3) -> f32 {
    let value = luminance(colour.abs());
    if value > 0.0 { value.min(BRIGHTEST) } else { 0.0 }
}

/// The weighed luminance of every texel, row by row from the top.
pub(super) fn texel_luminances(picture: &Picture) -> Vec<f32> {
    let width = picture.width();
    let mut values = vec![0.0; width * picture.height()];
    parallel::for_each(values.chunks_mut(width).enumerate(), |(row, values)| {
        values.iter_mut().enumerate().for_each(|(column, value)| {
            *value = weighed_luminance(picture.texel(column, row));
        });
    });
    values
}

/// The mean over each texel's square of the bilinear interpolation of `values`; rows go on beyond top and bottom.
pub(super) fn bilinear_means(values: &[f32], width: usize, beyond: Beyond) -> Vec<f32> {
    let height = values.len() / width;
    let mut means = vec![0.0; values.len()];
    parallel::for_each(means.chunks_mut(width).enumerate(), |(row, means)| {
        let line = |row: usize| &values[row * width..(row + 1) * width];
        let (above, here, below) = (line(row.saturating_sub(1)), line(row), line((row + 1).min(height - 1)));
        let mut column_means = vec![0.0; width + 2];
        for (mean, ((above, here), below)) in column_means[1..].iter_mut().zip(above.iter().zip(here).zip(below)) {
            *mean = (above + 6.0 * here + below) / 8.0;
        }
        let (first, last) = (column_means[1], column_means[width]);
        let (before, after) = if beyond == Beyond::Border { (first, last) } else { (last, first) };
        (column_means[0], column_means[width + 1]) = (before, after);
        for (mean, values) in means.iter_mut().zip(column_means.windows(3)) {
            *mean = (values[0] + 6.0 * values[1] + values[2]) / 8.0;
        }
    });
    means
}
