//! Whether the rest of the difference lies along edges only, as between pictures with different numbers of samples.

use serde::Serialize;

use super::finding::{Finding, Kind};
use super::subject::Left;
use super::undoing::Aligned;
use crate::digits::digits;
use crate::metrics::Plane;

/// The step of luma that makes an edge.
const STEP: f32 = 0.1;
/// How far from an edge its pixels may lie.
const RADIUS: usize = 2;
/// The share of the squared difference that must lie there, and the share of the pixels that may.
const DECISIVE: (f64, f64) = (0.9, 0.6);
/// How many times larger the mean squared difference must be there than elsewhere.
const CONTRAST: f64 = 20.0;

/// What is left lies along edges that both pictures have.
#[derive(Serialize)]
struct Edges {
    /// Share of the squared difference on them, `[0, 1]`.
    #[serde(serialize_with = "digits::<3, _>")]
    share: f64,
    /// Share of the pixels that they take, `[0, 1]`.
    #[serde(serialize_with = "digits::<3, _>")]
    area: f64,
    /// Standard deviation of the difference all over, in codes of 255.
    #[serde(serialize_with = "digits::<1, _>")]
    deviation: f64,
    #[serde(skip)]
    subject: &'static str,
}

impl Kind for Edges {
    const NAME: &'static str = "edges";

    fn sentence(&self) -> String {
        let (share, area) = (100.0 * self.share, 100.0 * self.area);
        format!(
            "{} lies along edges ({share:.0} % of it on {area:.0} % of the pixels), where samples within the pixel count: \
             render with as many as the expected picture has, and let a single ray go through the pixel's centre.",
            self.subject
        )
    }
}

/// None if much of the difference lies elsewhere, or there is little but edges.
pub(super) fn found(left: &Left) -> Option<Finding> {
    let (share, area) = along_edges(left.aligned);
    let contrasts = share * (1.0 - area) >= CONTRAST * (1.0 - share) * area;
    let decisive = share >= DECISIVE.0 && area <= DECISIVE.1 && contrasts;
    decisive.then(|| Edges { share, area, deviation: left.residue.deviation, subject: left.subject() }.into())
}

/// The share of the squared difference that lies on edges, and the share of the pixels that they take.
fn along_edges(aligned: &Aligned) -> (f64, f64) {
    let (mine, expected) = (Plane::luma(&aligned.mine), Plane::luma(&aligned.expected));
    let ranges = range(&mine).zip(&range(&expected), f32::min);
    let [mut inside, mut all] = [0.0f64; 2];
    let mut pixels = 0usize;
    for ((&a, &b), &range) in mine.values().iter().zip(expected.values()).zip(ranges.values()) {
        let square = f64::from(a - b) * f64::from(a - b);
        all += square;
        if range > STEP {
            inside += square;
            pixels += 1;
        }
    }
    let area = pixels as f64 / ranges.values().len() as f64;
    (if all > 0.0 { inside / all } else { 0.0 }, area)
}

/// The largest less the smallest value around every pixel.
fn range(plane: &Plane) -> Plane {
    extreme(plane, f32::max).zip(&extreme(plane, f32::min), |most, least| most - least)
}

/// The largest or smallest value around every pixel: along the rows, and of that along the columns.
fn extreme(plane: &Plane, pick: fn(f32, f32) -> f32) -> Plane {
    let (width, height) = (plane.width(), plane.height());
    let along_rows = picked(plane.values(), 1, width, pick);
    Plane::new(width, height, picked(&along_rows, width, width * height, pick))
}

/// Every value with those `stride`, `2 stride`, ... before and after it in its line of `length` values.
fn picked(values: &[f32], stride: usize, length: usize, pick: fn(f32, f32) -> f32) -> Vec<f32> {
    let mut picked = values.to_vec();
    for (line, own) in picked.chunks_exact_mut(length).zip(values.chunks_exact(length)) {
        for reach in (1..=RADIUS).map(|step| step * stride).filter(|&reach| reach < length) {
            for (value, &after) in line.iter_mut().zip(&own[reach..]) {
                *value = pick(*value, after);
            }
            for (value, &before) in line[reach..].iter_mut().zip(own) {
                *value = pick(*value, before);
            }
        }
    }
    picked
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_is_that_of_the_square_around_a_pixel() {
        let (width, height) = (9, 7);
        let plane = Plane::new(width, height, (0..width * height).map(|index| ((index * 29) % 31) as f32).collect());
        let range = range(&plane);
        for (x, y) in (0..width).flat_map(|x| (0..height).map(move |y| (x, y))) {
            let columns = x.saturating_sub(RADIUS)..(x + RADIUS + 1).min(width);
            let rows = y.saturating_sub(RADIUS)..(y + RADIUS + 1).min(height);
            let around: Vec<f32> =
                rows.flat_map(|y| columns.clone().map(move |x| (x, y))).map(|(x, y)| plane.at(x, y)).collect();
            let most = around.iter().copied().fold(f32::MIN, f32::max);
            let least = around.iter().copied().fold(f32::MAX, f32::min);
            assert_eq!(range.at(x, y), most - least);
        }
    }
}
