//! Faces whose image belongs to no place in the map: another scene, one flat colour, a copy of another face.

use super::arrangement::{Arrangement, Puzzle};
use super::border::ImageBorders;
use super::edge::Edge;
use super::seam::measure;
use crate::envmap::{CubeMap, Face};
use crate::error::Result;

/// A face whose image does not belong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Foreign {
    pub face: Face,
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

/// The mean fit of the four seams of a face from which on it is a stranger.
const STRANGER: f64 = 0.8;
/// The same for the second of two equal images.
const STRANGER_COPY: f64 = 0.6;
/// The mean fit that the eight other seams must reach.
const FAMILIAR: f64 = 0.7;
/// The mean score (step over detail) below which a seam is not a visible fault.
const VISIBLE: f64 = 3.0;

/// The faces that fit nothing while the others fit.
pub fn find(map: &CubeMap, puzzle: &Puzzle, images: &[ImageBorders; 6], found: &Arrangement) -> Result<Vec<Foreign>> {
    let fits: Vec<f64> = (0..12).map(|edge| puzzle.fit(found, edge)).collect();
    let score = |edge: usize| measure(puzzle, images, found, edge).score;
    let mean_fit = |touching: bool, face: Face| {
        let chosen: Vec<f64> =
            (0..12).filter(|&edge| Edge::ALL[edge].touches(face) == touching).map(|edge| fits[edge]).collect();
        chosen.iter().sum::<f64>() / chosen.len() as f64
    };
    let mut worst: Vec<Face> = Face::ALL.to_vec();
    worst.sort_by(|&a, &b| mean_fit(true, b).total_cmp(&mean_fit(true, a)));
    let face = worst[0];
    let image = found.images[face.index()];
    let copy = copy_of(map, images, image)?;
    let threshold = if copy.is_some() { STRANGER_COPY } else { STRANGER };
    let scores = (0..12).filter(|&edge| Edge::ALL[edge].touches(face)).map(score);
    let visible = scores.sum::<f64>() / 4.0 >= VISIBLE;
    if mean_fit(true, face) < threshold || mean_fit(false, face) > FAMILIAR || !visible {
        return Ok(Vec::new());
    }
    let reason = match copy {
        Some(other) => Reason::CopyOf(other),
        None if images[image.index()].is_flat() => Reason::Flat,
        None => Reason::AnotherScene,
    };
    Ok(vec![Foreign { face, reason }])
}

/// Another image with the same texels.
fn copy_of(map: &CubeMap, borders: &[ImageBorders; 6], image: Face) -> Result<Option<Face>> {
    if borders[image.index()].is_flat() {
        return Ok(None);
    }
    for other in Face::ALL.into_iter().filter(|&other| other != image) {
        if map.picture(image)?.texels() == map.picture(other)?.texels() {
            return Ok(Some(other));
        }
    }
    Ok(None)
}
