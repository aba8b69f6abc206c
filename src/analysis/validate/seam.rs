//! The seams as the report shows them: step, detail, score and verdict of the twelve edges.

use super::borders::border::{ImageBorders, Row, mean_step};
use super::borders::edge::{Border, Edge};
use super::search::arrangement::{Arrangement, Problem};
use super::thresholds::seam::{BROKEN_COST, BROKEN_FACTOR, LEAST_DETAIL, NOTHING, UNDECIDED};
use super::verdict::Verdict;
use crate::digits::digits;

/// One edge under one lookup.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Seam {
    /// The two faces that meet there.
    pub edge: Edge,
    /// Mean absolute difference across the seam, of 255 display units, over texels and channels.
    #[serde(serialize_with = "digits::<2, _>")]
    pub step: f64,
    /// The same from texel to texel, one and two texels inside both faces.
    #[serde(serialize_with = "digits::<2, _>")]
    pub detail: f64,
    /// How many times larger the step is than the detail: `step / max(detail, 0.5)`. About 1 where two faces continue
    /// each other.
    #[serde(serialize_with = "digits::<2, _>")]
    pub score: f64,
    /// What the step means.
    pub verdict: Verdict,
}

/// Step and detail of an edge; the verdict is still to be found.
pub fn measure(problem: &Problem, images: &[ImageBorders; 6], arrangement: &Arrangement, edge: usize) -> Seam {
    let (names, borders) = problem.ends(arrangement, edge);
    let [one, other] = [0, 1].map(|end| &images[names[end].index()]);
    let texels = one.texels.max(other.texels);
    let row = |image: &ImageBorders, border: Border, depth: usize| -> Row {
        let row = image.row(border.side, depth);
        let nearest = |index: usize| row[(2 * index + 1) * row.len() / (2 * texels)];
        let mut row: Row = (0..texels).map(nearest).collect();
        if border.reversed {
            row.reverse();
        }
        row
    };
    let inside = |image: &ImageBorders, border: Border| {
        let rows = [0, 1, 2].map(|depth| row(image, border, depth));
        (mean_step(&rows[0], &rows[1]) + mean_step(&rows[1], &rows[2])) / 2.0
    };
    let step = mean_step(&row(one, borders[0], 0), &row(other, borders[1], 0));
    let detail = (inside(one, borders[0]) + inside(other, borders[1])) / 2.0;
    let score = step / detail.max(LEAST_DETAIL);
    Seam { edge: Edge::ALL[edge], step, detail, score, verdict: Verdict::Fits }
}

/// Twelve seams with their verdicts. A seam is broken if `found` pairs its borders otherwise and cheaper, or a face
/// at it does not belong; undecidable if its borders go as well with most others.
pub fn seams(
    problem: &Problem,
    images: &[ImageBorders; 6],
    arrangement: &Arrangement,
    found: &Arrangement,
    outlier: &[crate::envmap::Face],
) -> Vec<Seam> {
    let judged = |edge: usize| {
        let mut seam = measure(problem, images, arrangement, edge);
        let cost = problem.edge_cost(arrangement, edge);
        let repaired = problem.cost_of_sides(found, problem.ends(arrangement, edge));
        let at_outlier = outlier.iter().any(|&face| {
            let (names, _) = problem.ends(arrangement, edge);
            names.contains(&found.images[face.index()])
        });
        seam.verdict = if at_outlier || cost > BROKEN_FACTOR * repaired + BROKEN_COST {
            Verdict::Broken
        } else if problem.fit(arrangement, edge) > UNDECIDED {
            Verdict::Undecidable
        } else {
            Verdict::Fits
        };
        seam
    };
    (0..12).map(judged).collect()
}

impl Problem {
    /// The mean cost that the two sides have in another arrangement.
    fn cost_of_sides(&self, arrangement: &Arrangement, ends: ([crate::envmap::Face; 2], [Border; 2])) -> f64 {
        let side = |end: usize| (ends.0[end], ends.1[end].side);
        let mut sum = 0.0;
        for edge in 0..12 {
            let (images, borders) = self.ends(arrangement, edge);
            for end in 0..2 {
                if (0..2).any(|wanted| side(wanted) == (images[end], borders[end].side)) {
                    sum += self.edge_cost(arrangement, edge);
                }
            }
        }
        sum / 2.0
    }

    /// The mean of [`Problem::fit`] over all edges.
    pub fn mean_fit(&self, arrangement: &Arrangement) -> f64 {
        (0..12).map(|edge| self.fit(arrangement, edge)).sum::<f64>() / 12.0
    }

    /// The cost of an edge as a part of what its two borders cost with the borders of all other images on average: near 0
    /// where they continue each other, near 1 where they are as good as outliers, and 1 where nothing costs anything.
    pub fn fit(&self, arrangement: &Arrangement, edge: usize) -> f64 {
        let (images, borders) = self.ends(arrangement, edge);
        let outliers = (0..2).map(|end| self.costs.mean_with_others(images[end], borders[end].side)).sum::<f64>() / 2.0;
        (self.edge_cost(arrangement, edge) + NOTHING) / (outliers + NOTHING)
    }
}
