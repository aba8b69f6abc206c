//! The plain step across each seam, for the drawing of the cross. It measures and does not judge: that takes the
//! comparison with other layings.

use crate::colour::ToneMap;
use crate::envmap::{CubeMap, Face, SignedAxis};
use crate::math::Vec3;
use crate::report::{CrossLayout, SeamMark, SeamVerdict};

/// Places along an edge at most.
const PLACES: usize = 512;

/// All twelve seams, measured through [`CubeMap::sample`].
pub fn measure(map: &CubeMap) -> Vec<SeamMark> {
    let edges = CrossLayout::new(SignedAxis::POS_Z).edges;
    edges
        .iter()
        .map(|edge| SeamMark { edge: edge.faces, verdict: SeamVerdict::Measured, score: score(map, edge.faces) })
        .collect()
}

/// Mean step across the seam over the mean step from texel to texel beside it, which counts as half a code of 255 at
/// least.
fn score(map: &CubeMap, [one, other]: [Face; 2]) -> f64 {
    let size = map.picture(map.lookup().row(one).image).map_or(1, |picture| picture.width());
    let places = size.min(PLACES);
    let (mut across, mut beside) = (0.0, 0.0);
    for place in 0..places {
        let along = (2 * place + 1) as f32 / places as f32 - 1.0;
        let colour = |face, neighbour, depth| colour(map, face, neighbour, along, (2 * depth + 1) as f32 / size as f32);
        let [here, there] =
            [(one, other), (other, one)].map(|(face, neighbour)| [0, 1, 2].map(|depth| colour(face, neighbour, depth)));
        across += step(here[0], there[0]);
        beside += [here, there].iter().map(|row| step(row[0], row[1]) + step(row[1], row[2])).sum::<f64>() / 4.0;
    }
    let count = places as f64;
    (across / count) / (beside / count).max(0.5)
}

/// The display colour on `face` at a distance from its border to `neighbour`, of 255.
fn colour(map: &CubeMap, face: Face, neighbour: Face, along: f32, inwards: f32) -> Vec3 {
    let free = Face::on_axis(3 - face.axis() - neighbour.axis(), true).normal();
    let direction = face.normal() + (1.0 - inwards) * neighbour.normal() + along * free;
    ToneMap::Clamp.display(map.sample(direction)) * 255.0
}

fn step(one: Vec3, other: Vec3) -> f64 {
    f64::from((one - other).abs().element_sum()) / 3.0
}
