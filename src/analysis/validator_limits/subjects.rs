//! The sweeps.

use super::damage::Damage;
use super::defects::{blurred, exposed, framed, jpeg, noisy, with_gamma};
use super::trial::{Answer, answer};
use super::world::World;
use crate::envmap::Face;
use crate::limits::Range;
use crate::parallel;
use crate::picture::Picture;
use crate::stress::{Effort, Group, Measurement, Subject};

/// All sweeps, in the order of the report.
pub const SUBJECTS: &[Subject] = &[
    subject("check-texels", "texels along a face", Range::new(64.0, 512.0), texels),
    subject("check-jpeg", "JPEG quality", Range::new(40.0, 100.0), jpeg_quality),
    subject("check-noise", "noise, codes of 255", Range::new(1.0, 8.0), noise),
    subject("check-exposure", "ratio of exposures", Range::new(1.0, 1.25), exposure),
    subject("check-blur", "radius of a blur, texels", Range::new(1.0, 1.0), blur),
    subject("check-gamma", "gamma", Range::new(0.8, 1.25), gamma),
    subject("check-frame", "width of a frame, texels", Range::new(1.0, 1.0), frame),
    subject("check-flat", "flat share of side borders", Range::new(0.1, 0.25), flat),
    subject("check-copies", "noise on a copied face", Range::new(0.1, 2.0), copies),
];

/// Texels along a face where nothing else is said.
const SIZE: usize = 128;

const fn subject(
    name: &'static str,
    swept: &'static str,
    promised: Range,
    sweep: fn(Effort) -> Vec<Measurement>,
) -> Subject {
    let error = "answers that are undecided, in percent; infinite if one is wrong";
    Subject { group: Group::Validator, name, swept, error, unit: "%", bound: 0.0, promised, sweep }
}

/// What happens to the picture of a face at a magnitude.
type Defect<'a> = &'a (dyn Fn(Face, Picture, f64) -> Picture + Sync);

/// Worlds and their pictures.
type Drawn = Vec<(World, [Picture; 6])>;

/// The share of undecided answers, and the first of the worst. With the usual effort each damage is done to one of the worlds,
/// in turn from step to step; with more to all of them.
fn measured(
    effort: Effort,
    step: usize,
    magnitude: f64,
    drawn: &Drawn,
    damages: &[Damage],
    defect: Defect,
) -> Measurement {
    let all = effort.rays > Effort::FULL.rays;
    let trials: Vec<(usize, Damage)> = (0..damages.len())
        .flat_map(|at| (0..drawn.len()).map(move |world| (at, world)))
        .filter(|(at, world)| all || (at + step) % drawn.len() == *world)
        .map(|(at, world)| (world, damages[at]))
        .collect();
    let answers = parallel::map(&trials, |&(world, damage)| {
        let (world, faces) = &drawn[world];
        let (answer, said) = answer(*world, faces, damage, &|face, picture| defect(face, picture, magnitude));
        (answer, format!("{}, {}: {said}", world.name(), damage.told()))
    });
    let count = |wanted: Answer| answers.iter().filter(|(answer, _)| *answer == wanted).count();
    let (undecided, wrong) = (count(Answer::Undecided), count(Answer::Wrong));
    let error = if wrong > 0 { f64::INFINITY } else { 100.0 * undecided as f64 / answers.len() as f64 };
    let shown = if wrong > 0 { Answer::Wrong } else { Answer::Undecided };
    let first = answers.into_iter().find(|(answer, _)| *answer == shown);
    Measurement::new(magnitude, error, first.map_or("none".to_owned(), |(_, input)| input))
}

fn drawn(size: usize) -> Drawn {
    World::ALL.into_iter().map(|world| (world, world.faces(size))).collect()
}

/// A sweep over pictures of one size.
fn swept(effort: Effort, magnitudes: &[f64], damages: &[Damage], defect: Defect) -> Vec<Measurement> {
    let drawn = drawn(SIZE);
    let steps = magnitudes.iter().enumerate();
    steps.map(|(step, &magnitude)| measured(effort, step, magnitude, &drawn, damages, defect)).collect()
}

/// Up to 1024 texels with the usual effort; 8192 take a hundred times that, and more than 10 GB of memory: all
/// three worlds, and copies of those that are checked.
fn texels(effort: Effort) -> Vec<Measurement> {
    let affordable = |size: &usize| *size <= 256 || size * size <= effort.rays / 8;
    let sizes = (4..=13).map(|power| 1 << power).take_while(affordable);
    let of_size = |(step, size): (usize, usize)| {
        measured(effort, step, size as f64, &drawn(size), &Damage::USUAL, &|_, picture, _| picture)
    };
    sizes.enumerate().map(of_size).collect()
}

fn jpeg_quality(effort: Effort) -> Vec<Measurement> {
    let qualities = [1.0, 5.0, 10.0, 20.0, 40.0, 75.0, 100.0];
    swept(effort, &qualities, &Damage::USUAL, &|_, picture, quality| jpeg(&picture, quality as u8))
}

fn noise(effort: Effort) -> Vec<Measurement> {
    let deviations = [1.0, 4.0, 8.0, 16.0, 32.0, 64.0];
    swept(effort, &deviations, &Damage::USUAL, &|face, picture, deviation| noisy(&picture, face, deviation))
}

fn exposure(effort: Effort) -> Vec<Measurement> {
    let factors = [1.0, 1.25, 2.0, 4.0, 16.0];
    swept(effort, &factors, &Damage::USUAL, &|face, picture, factor| exposed(&picture, face, factor))
}

fn blur(effort: Effort) -> Vec<Measurement> {
    let radii = [1.0, 4.0, 8.0, 16.0, 32.0];
    swept(effort, &radii, &Damage::USUAL, &|_, picture, radius| blurred(&picture, radius as usize))
}

fn gamma(effort: Effort) -> Vec<Measurement> {
    let gammas = [0.01, 0.1, 0.25, 0.8, 1.25, 4.0, 10.0];
    swept(effort, &gammas, &Damage::USUAL, &|_, picture, gamma| with_gamma(&picture, gamma))
}

fn frame(effort: Effort) -> Vec<Measurement> {
    let widths = [1.0, 2.0, 4.0, 16.0];
    swept(effort, &widths, &Damage::USUAL, &|_, picture, width| framed(&picture, width as usize))
}

fn copies(effort: Effort) -> Vec<Measurement> {
    // Half a code rounds away for the most part.
    let deviations = [0.1, 0.5, 2.0, 8.0, 32.0];
    swept(effort, &deviations, &Damage::COPIES, &|face, picture, deviation| noisy(&picture, face, deviation))
}

/// A sky of one colour that comes down over the sides.
fn flat(effort: Effort) -> Vec<Measurement> {
    let of_share = |(step, share): (usize, f64)| {
        let below = |world: World| (world, world.faces_below(SIZE, 1.0 - 2.0 * share as f32));
        let drawn = World::ALL.map(below).to_vec();
        measured(effort, step, share, &drawn, &Damage::USUAL, &|_, picture, _| picture)
    };
    [0.1, 0.25, 0.5, 0.9, 0.99].into_iter().enumerate().map(of_share).collect()
}
