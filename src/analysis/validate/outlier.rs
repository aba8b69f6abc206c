//! Outlier faces, whose image does not belong to the map: another scene, one flat colour, a copy of another face.

use super::borders::border::Borders;
use super::borders::edge::Edge;
use super::copies::Copies;
use super::seam::measure;
use super::search::arrangement::{Arrangement, Problem};
use super::thresholds::outlier::{
    ANOTHER_PATTERN, COPY_RATIO, COPY_STEP, FAMILIAR, GAPING_SEAMS, KINDRED, OUTLIER, OUTLIER_COPY, OUTLIER_FLAT,
    OUTLIER_GLARING, OUTLIER_STEP, STEP_RATIO, VISIBLE,
};
use super::thresholds::seam::UNDECIDED;
use super::thresholds::verdict::TORN_STEP;
use crate::envmap::Face;

/// A face whose image does not belong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outlier {
    /// The face that shows the image.
    pub face: Face,
    /// Why the image does not belong.
    pub reason: Reason,
}

/// What the image is instead.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// One flat colour.
    Flat,
    /// The same pixels as this image.
    CopyOf(Face),
    /// A picture of something else.
    AnotherScene,
}

/// How a face fits among the others, in its best orientation: what the thresholds judge it by.
#[cfg(test)]
pub struct Judged {
    /// The mean fit of its four seams.
    pub fit: f64,
    /// The mean fit of the eight others.
    pub others_fit: f64,
    /// The mean step of its seams.
    pub step: f64,
    /// The mean step of the eight others.
    pub others_step: f64,
    /// The mean score of its seams.
    pub score: f64,
    /// Their mean cost, brightness apart.
    pub pattern: f64,
    /// The agreement of the brightness along them.
    pub agreement: f64,
}

/// Judges a face as the thresholds do.
#[cfg(test)]
pub fn judge(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face) -> Judged {
    let (placed, fit) = best_orientation(problem, arrangement, face);
    Judged {
        fit,
        others_fit: mean_fit(problem, &placed, face, false),
        step: mean_step(problem, images, &placed, face, true),
        others_step: mean_step(problem, images, &placed, face, false),
        score: mean_score(problem, images, &placed, face),
        pattern: pattern_cost(problem, &placed, face),
        agreement: agreement(problem, arrangement, face),
    }
}

/// The face that fits nothing, in any orientation, while the others fit as `arrangement` has them. The image of that face is
/// left as it is given.
pub fn find(
    copies: &Copies,
    problem: &Problem,
    images: &Borders,
    arrangement: &Arrangement,
) -> Option<(Outlier, Arrangement)> {
    if let Some(copied) = copied(copies, problem, images, arrangement) {
        return Some(copied);
    }
    let judged = Face::ALL.map(|face| {
        let (placed, fit) = best_orientation(problem, arrangement, face);
        (stands_out(problem, images, &placed, face), fit, placed)
    });
    let worst = |a: &usize, b: &usize| judged[*a].0.cmp(&judged[*b].0).then(judged[*a].1.total_cmp(&judged[*b].1));
    let worst = (0..6).max_by(worst)?;
    let (face, (stands_out, fit, placed)) = (Face::ALL[worst], &judged[worst]);
    let others_fit = mean_fit(problem, placed, face, false) <= FAMILIAR;
    let reason = reason(copies, images, placed.images[worst]);
    // A square of one colour is seen however coarse the pictures around it are.
    let is_seen = || reason == Reason::Flat || mean_score(problem, images, placed, face) >= VISIBLE;
    let may_be = *stands_out || (others_fit && is_seen());
    if !may_be {
        return None;
    }
    let (threshold, fit) = match reason {
        // A mirrored copy of its original closes the seam between the two, which is no evidence.
        Reason::CopyOf(other) => (OUTLIER_COPY, fit_without(problem, arrangement, face, placed.face_of(other))),
        Reason::Flat => (OUTLIER_FLAT, *fit),
        Reason::AnotherScene => (OUTLIER, *fit),
    };
    let another_pattern =
        pattern_cost(problem, placed, face) >= ANOTHER_PATTERN && agreement(problem, arrangement, face) < KINDRED;
    let unlike = (reason != Reason::AnotherScene || another_pattern)
        && (*stands_out || steps_away(problem, images, placed, face, reason));
    ((*stands_out || fit >= threshold) && unlike)
        .then(|| (Outlier { face, reason }, arrangement.with_orientation(face, 0)))
}

/// True if the seams of a face step as far as those of an image that does not belong.
pub fn steps_away(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face, reason: Reason) -> bool {
    let least = if matches!(reason, Reason::CopyOf(_)) { COPY_STEP } else { OUTLIER_STEP };
    mean_step(problem, images, arrangement, face, true) >= least
}

/// True if the image of a face fits where the best arrangement has it, among other images: files were exchanged. The place
/// does not matter, since the whole cube may be turned.
pub fn fits_elsewhere(
    problem: &Problem,
    images: &Borders,
    given: &Arrangement,
    best: &Arrangement,
    face: Face,
) -> bool {
    let image = given.images[face.index()];
    let fits = |place| mean_fit(problem, best, place, true) <= FAMILIAR && !gapes(problem, images, best, place);
    best.images != given.images && best.face_of(image).is_some_and(fits)
}

/// True if at least three of a face's seams go as well with most other borders, are seen, and neither their patterns nor
/// those in any other orientation say that it belongs here all the same: it may be of another scene. So may a face beside it
/// whose seam with it closes: then nobody can say which. A face in grey or exposed otherwise keeps its patterns.
pub fn gapes(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face) -> bool {
    let touching = (0..12).filter(|&edge| Edge::ALL[edge].touches(face));
    touching.filter(|&edge| problem.fit(arrangement, edge) > UNDECIDED).count() >= GAPING_SEAMS
        && mean_score(problem, images, arrangement, face) >= VISIBLE
        && pattern_cost(problem, arrangement, face) >= ANOTHER_PATTERN
        && agreement(problem, arrangement, face) < KINDRED
}

/// True if at least three of a face's seams show a step that nobody overlooks, and its borders agree with those around it in no
/// orientation.
fn glares(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face) -> bool {
    let glaring = |&edge: &usize| Edge::ALL[edge].touches(face) && is_glaring(problem, images, arrangement, edge);
    (0..12).filter(glaring).count() >= GAPING_SEAMS && agreement(problem, arrangement, face) < KINDRED
}

/// True if a face of one colour, or one whose borders fit others as well, glares, and its seams step much further than those
/// between the others. Where only some images are seen to have a frame, its colour may be what glares.
pub fn stands_out(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face) -> bool {
    let is_flat = images[arrangement.images[face.index()].index()].is_flat();
    let step = |touching: bool| mean_step(problem, images, arrangement, face, touching);
    (is_flat || mean_fit(problem, arrangement, face, true) >= OUTLIER_GLARING)
        && glares(problem, images, arrangement, face)
        && step(true) >= STEP_RATIO * step(false)
        && images.iter().all(|image| image.framed == images[0].framed)
}

/// The only face that stands out; `None` if none does, or several do.
pub fn sole(copies: &Copies, problem: &Problem, images: &Borders, arrangement: &Arrangement) -> Option<Outlier> {
    let mut standing = Face::ALL.into_iter().filter(|&face| stands_out(problem, images, arrangement, face));
    let face = standing.next().filter(|_| standing.next().is_none())?;
    Some(Outlier { face, reason: reason(copies, images, arrangement.images[face.index()]) })
}

/// What an image that does not belong is instead.
fn reason(copies: &Copies, images: &Borders, image: Face) -> Reason {
    match copies.of_image(image) {
        Some(other) => Reason::CopyOf(other),
        None if images[image.index()].is_flat() => Reason::Flat,
        None => Reason::AnotherScene,
    }
}

fn is_glaring(problem: &Problem, images: &Borders, arrangement: &Arrangement, edge: usize) -> bool {
    let seam = measure(problem, images, arrangement, edge);
    seam.step >= TORN_STEP && seam.score >= VISIBLE
}

/// The images that must not tell how the others lie where `outlier` does not belong: itself, and all others that are
/// outliers or copies as well.
pub fn outliers(copies: &Copies, problem: &Problem, arrangement: &Arrangement, outlier: Face) -> Vec<Face> {
    let mut outliers = vec![arrangement.images[outlier.index()]];
    for face in Face::ALL.into_iter().filter(|&face| face != outlier) {
        let image = arrangement.images[face.index()];
        let strange = match copies.of_image(image) {
            Some(other) => {
                let original = arrangement.face_of(other);
                fit_without(problem, arrangement, face, original) >= OUTLIER_COPY
            }
            None => {
                best_orientation(problem, arrangement, face).1 >= OUTLIER
                    && agreement(problem, arrangement, face) < KINDRED
            }
        };
        if strange {
            outliers.push(image);
        }
    }
    outliers
}

/// A face with the picture of another that sees it in its place: its own seams step further than those of the original. In a
/// picture of the world two faces never hold the same detail; in a drawn one they may, and then all seams close.
fn copied(
    copies: &Copies,
    problem: &Problem,
    images: &Borders,
    arrangement: &Arrangement,
) -> Option<(Outlier, Arrangement)> {
    let mut worst: Option<(f64, Outlier)> = None;
    for face in Face::ALL {
        let Some(other) = copies.of_image(arrangement.images[face.index()]) else { continue };
        let Some(original) = arrangement.face_of(other) else {
            continue;
        };
        let (placed, _) = best_orientation(problem, arrangement, face);
        let (gaping, closing) = copy_steps(problem, images, &placed, face, original);
        let others_fit = mean_fit(problem, &placed, face, false) <= FAMILIAR;
        let gapes = others_fit && gaping >= COPY_STEP && gaping >= COPY_RATIO * closing;
        if gapes && worst.is_none_or(|(step, _)| gaping > step) {
            worst = Some((gaping, Outlier { face, reason: Reason::CopyOf(other) }));
        }
    }
    worst.map(|(_, outlier)| (outlier, arrangement.with_orientation(outlier.face, 0)))
}

/// The mean steps of the seams of a copy and of its original.
pub fn copy_steps(problem: &Problem, images: &Borders, placed: &Arrangement, face: Face, original: Face) -> (f64, f64) {
    let away = |of: Face, from: Face| step_away_from(problem, images, placed, of, from);
    (away(face, original), away(original, face))
}

/// The mean step of the seams of a face but for the one towards another: a copy beside its original may close that one.
fn step_away_from(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face, other: Face) -> f64 {
    let counts = |&edge: &usize| Edge::ALL[edge].touches(face) && !Edge::ALL[edge].touches(other);
    let steps: Vec<f64> = (0..12).filter(counts).map(|edge| measure(problem, images, arrangement, edge).step).collect();
    steps.iter().sum::<f64>() / steps.len().max(1) as f64
}

/// The mean cost of a face's seams but for their mean brightness and colour, which a different exposure explains.
fn pattern_cost(problem: &Problem, arrangement: &Arrangement, face: Face) -> f64 {
    let touching = (0..12).filter(|&edge| Edge::ALL[edge].touches(face));
    touching
        .map(|edge| problem.edge_units(arrangement, edge)[1..].iter().map(|&unit| f64::from(unit)).sum::<f64>())
        .sum::<f64>()
        / 4.0
}

/// How far the brightness along the borders of a face agrees with that along its neighbours', in the orientation that agrees most:
/// see [`super::borders::agreement`].
fn agreement(problem: &Problem, arrangement: &Arrangement, face: Face) -> f64 {
    let along = |placed: &Arrangement, edge: usize| {
        let (images, borders) = problem.ends(placed, edge);
        f64::from(problem.costs.correlation(images, borders).evidence())
    };
    let touching = || (0..12).filter(|&edge| Edge::ALL[edge].touches(face));
    let all = |placed: Arrangement| touching().map(|edge| along(&placed, edge)).sum::<f64>();
    (0..8).map(|orientation| all(arrangement.with_orientation(face, orientation))).fold(f64::NEG_INFINITY, f64::max)
}

/// The mean fit of the seams of a face, in its best orientation, but for the one towards `other`.
fn fit_without(problem: &Problem, arrangement: &Arrangement, face: Face, other: Option<Face>) -> f64 {
    let counts = |&edge: &usize| {
        let edge = Edge::ALL[edge];
        edge.touches(face) && !other.is_some_and(|other| edge.touches(other))
    };
    let edges: Vec<usize> = (0..12).filter(counts).collect();
    let fit =
        |placed: &Arrangement| edges.iter().map(|&edge| problem.fit(placed, edge)).sum::<f64>() / edges.len() as f64;
    (0..8).map(|orientation| fit(&arrangement.with_orientation(face, orientation))).fold(f64::INFINITY, f64::min)
}

/// The arrangement with the cheapest orientation of one face, and the mean fit of that face's seams.
fn best_orientation(problem: &Problem, arrangement: &Arrangement, face: Face) -> (Arrangement, f64) {
    let orientations = (0..8).map(|orientation| arrangement.with_orientation(face, orientation));
    let fits = orientations.map(|placed| (placed, mean_fit(problem, &placed, face, true)));
    fits.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there are eight orientations")
}

/// The mean fit of the seams that touch the face, or of those that do not.
fn mean_fit(problem: &Problem, arrangement: &Arrangement, face: Face, touching: bool) -> f64 {
    let chosen = |&edge: &usize| Edge::ALL[edge].touches(face) == touching;
    let count = if touching { 4.0 } else { 8.0 };
    (0..12).filter(chosen).map(|edge| problem.fit(arrangement, edge)).sum::<f64>() / count
}

fn mean_score(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face) -> f64 {
    let touching = (0..12).filter(|&edge| Edge::ALL[edge].touches(face));
    touching.map(|edge| measure(problem, images, arrangement, edge).score).sum::<f64>() / 4.0
}

/// The mean step of the seams that touch the face, or of those that do not.
fn mean_step(problem: &Problem, images: &Borders, arrangement: &Arrangement, face: Face, touching: bool) -> f64 {
    let chosen = |&edge: &usize| Edge::ALL[edge].touches(face) == touching;
    let steps: Vec<f64> = (0..12).filter(chosen).map(|edge| measure(problem, images, arrangement, edge).step).collect();
    steps.iter().sum::<f64>() / steps.len() as f64
}
