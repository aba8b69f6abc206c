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
    subject("check-jpeg", "JPEG quality, 128 texels", Range::new(40.0, 100.0), jpeg_quality),
    subject("check-noise", "noise, codes of 255", Range::new(1.0, 8.0), noise),
    subject("check-exposure", "ratio of exposures", Range::new(1.0, 1.25), exposure),
    subject("check-blur", "radius of a blur, texels", Range::new(1.0, 1.0), blur),
    subject("check-gamma", "gamma", Range::new(0.8, 1.25), gamma),
    subject("check-frame", "width of a frame, texels", Range::new(1.0, 1.0), frame),
    subject("check-flat", "flat share of side borders", Range::new(0.01, 0.25), flat),
    subject("check-copies", "noise on a copied face", Range::new(0.1, 8.0), copies),
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

/// The share of undecided answers over all worlds and damages, and the first of the worst answers.
fn step(magnitude: f64, size: usize, damages: &[Damage], defect: Defect) -> Measurement {
    let worlds: Vec<(World, [Picture; 6])> = World::ALL.into_iter().map(|world| (world, world.faces(size))).collect();
    step_of(magnitude, &worlds, damages, defect)
}

fn step_of(magnitude: f64, worlds: &[(World, [Picture; 6])], damages: &[Damage], defect: Defect) -> Measurement {
    let trials: Vec<(usize, Damage)> =
        (0..worlds.len()).flat_map(|world| damages.iter().map(move |&damage| (world, damage))).collect();
    let answers = parallel::map(&trials, |&(world, damage)| {
        let (world, faces) = &worlds[world];
        answer(*world, faces, damage, &|face, picture| defect(face, picture, magnitude))
    });
    let worst = answers.iter().copied().max().unwrap_or(Answer::Right);
    let undecided = answers.iter().filter(|&&answer| answer != Answer::Right).count();
    let error = match worst {
        Answer::Wrong => f64::INFINITY,
        _ => 100.0 * undecided as f64 / answers.len() as f64,
    };
    let first = answers.iter().position(|&answer| answer == worst && worst != Answer::Right);
    let input = first.map_or("none".to_owned(), |at| {
        let (world, damage) = trials[at];
        format!("{}, {}", worlds[world].0.name(), damage.told())
    });
    Measurement::new(magnitude, error, input)
}

/// A sweep over pictures of one size.
fn swept(magnitudes: &[f64], damages: &[Damage], defect: Defect) -> Vec<Measurement> {
    let worlds: Vec<(World, [Picture; 6])> = World::ALL.into_iter().map(|world| (world, world.faces(SIZE))).collect();
    magnitudes.iter().map(|&magnitude| step_of(magnitude, &worlds, damages, defect)).collect()
}

/// Up to 1024 texels with the usual effort; 8192 take a hundred times that, and 8 GB of memory.
fn texels(effort: Effort) -> Vec<Measurement> {
    let affordable = |size: &usize| *size <= 512 || size * size <= effort.rays / 8;
    let sizes = (3..=13).map(|power| 1 << power).take_while(affordable);
    sizes.map(|size| step(size as f64, size, &Damage::USUAL, &|_, picture, _| picture)).collect()
}

fn jpeg_quality(_: Effort) -> Vec<Measurement> {
    let qualities = [1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 40.0, 50.0, 75.0, 90.0, 100.0];
    swept(&qualities, &Damage::USUAL, &|_, picture, quality| jpeg(&picture, quality as u8))
}

fn noise(_: Effort) -> Vec<Measurement> {
    let deviations = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0];
    swept(&deviations, &Damage::USUAL, &|face, picture, deviation| noisy(&picture, face, deviation))
}

fn exposure(_: Effort) -> Vec<Measurement> {
    let factors = [1.0, 1.1, 1.25, 1.5, 2.0, 4.0, 8.0, 16.0];
    swept(&factors, &Damage::USUAL, &|face, picture, factor| exposed(&picture, face, factor))
}

fn blur(_: Effort) -> Vec<Measurement> {
    let radii = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
    swept(&radii, &Damage::USUAL, &|_, picture, radius| blurred(&picture, radius as usize))
}

fn gamma(_: Effort) -> Vec<Measurement> {
    let gammas = [0.01, 0.1, 0.25, 0.5, 0.8, 1.25, 2.0, 4.0, 10.0, 100.0];
    swept(&gammas, &Damage::USUAL, &|_, picture, gamma| with_gamma(&picture, gamma))
}

fn frame(_: Effort) -> Vec<Measurement> {
    let widths = [1.0, 2.0, 3.0, 4.0, 8.0, 16.0, 32.0];
    swept(&widths, &Damage::USUAL, &|_, picture, width| framed(&picture, width as usize))
}

fn copies(_: Effort) -> Vec<Measurement> {
    // Half a code rounds away for the most part.
    let deviations = [0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
    swept(&deviations, &Damage::COPIES, &|face, picture, deviation| noisy(&picture, face, deviation))
}

/// A sky of one colour that comes down over the sides.
fn flat(_: Effort) -> Vec<Measurement> {
    let of_share = |share: f64| {
        let worlds: Vec<(World, [Picture; 6])> =
            World::ALL.into_iter().map(|world| (world, world.faces_below(SIZE, 1.0 - 2.0 * share as f32))).collect();
        step_of(share, &worlds, &Damage::USUAL, &|_, picture, _| picture)
    };
    [0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 1.0].into_iter().map(of_share).collect()
}
