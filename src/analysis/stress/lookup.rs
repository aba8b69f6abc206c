//! Directions to places on the cube.

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, faults_of, worst_of};
use super::reference::ulp_f32;
use crate::envmap::{Face, Lookup, Preset};
use crate::limits::Range;
use crate::math::Vec3;
use crate::random::Random;

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Lookup,
        name: "directions",
        swept: "largest component",
        error: "directions with u or v outside [0, 1] or a wrong face, per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1e-45, 1e38),
        sweep: directions,
    },
    Subject {
        group: Group::Lookup,
        name: "length",
        swept: "largest component",
        error: "change of u and v between d and 2 d, in ulp of 1",
        unit: "ulp",
        bound: 0.0,
        promised: Range::new(1e-45, 1e38),
        sweep: length,
    },
    Subject {
        group: Group::Lookup,
        name: "edges",
        swept: "components beside the edge",
        error: "distance of the two faces' places one ulp to either side of an edge, in ulp of 1",
        unit: "ulp",
        bound: 2.0,
        promised: Range::new(1e-37, 1e37),
        sweep: edges,
    },
    Subject {
        group: Group::Lookup,
        name: "not-numbers",
        swept: "components: 1, 2, 3 of them",
        error: "directions with NaN or infinity whose u or v is outside [0, 1], per million",
        unit: "ppm",
        bound: 0.0,
        promised: Range::new(1.0, 3.0),
        sweep: not_numbers,
    },
];

fn lookup(random: &mut Random) -> Lookup {
    Preset::ALL[random.below(Preset::ALL.len())].lookup()
}

/// A component no larger than `size`: it, something beside it, smaller ones, both zeros.
fn component(random: &mut Random, size: f32) -> f32 {
    let value = match random.below(7) {
        0 => size,
        1 => size.next_down(),
        2 => 0.0,
        3 => size * random.unit() as f32,
        4 => size * 1e-7,
        5 => f32::from_bits(1 + random.below(100) as u32).min(size),
        _ => size * random.decade(-30, 0) as f32,
    };
    if random.unit() < 0.5 { -value } else { value }
}

/// A direction whose largest component is `size`, up to its sign.
fn direction(random: &mut Random, size: f32) -> Vec3 {
    let mut components = [0; 3].map(|_| component(random, size));
    let largest = random.below(3);
    components[largest] = if random.unit() < 0.5 { -size } else { size };
    components.into()
}

/// A direction as it is printed.
fn components(direction: Vec3) -> String {
    let [x, y, z] = direction
        .to_array()
        .map(|component| if component == 0.0 { "0".to_owned() } else { format!("{component:.1e}") });
    format!("({x}, {y}, {z})")
}

fn is_in_square(u: f32, v: f32) -> bool {
    (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v)
}

/// `10^k` as `f32`, the smallest subnormal for `10^-45`.
fn magnitudes() -> impl Iterator<Item = (f64, f32)> {
    decades(-45, 38).step_by(2).chain(decades(38, 38)).map(|size| (size, size as f32))
}

fn directions(effort: Effort) -> Vec<Measurement> {
    let of_size = |(magnitude, size): (f64, f32)| {
        let (faults, first) = faults_of(effort.share(5e-4), magnitude.to_bits(), |random| {
            let direction = direction(random, size);
            let point = lookup(random).locate(direction);
            let largest = direction[point.face.axis()];
            let signed = if point.face.index().is_multiple_of(2) { largest } else { -largest };
            (!is_in_square(point.u, point.v) || signed != direction.abs().max_element()).then_some(direction)
        });
        Measurement::new(magnitude, faults, first.map_or("none".to_owned(), components))
    };
    magnitudes().map(of_size).collect()
}

fn length(effort: Effort) -> Vec<Measurement> {
    let of_size = |(magnitude, size): (f64, f32)| {
        let (error, found) = worst_of(effort.share(5e-4), magnitude.to_bits(), |random| {
            let (lookup, direction) = (lookup(random), direction(random, size));
            let (one, other) = (lookup.locate(direction), lookup.locate(direction * 2.0));
            let moved = f64::from((one.u - other.u).abs().max((one.v - other.v).abs()));
            (if one.face == other.face { moved / ulp_f32(1.0) } else { f64::INFINITY }, direction)
        });
        Measurement::new(magnitude, error, components(found))
    };
    magnitudes().map(of_size).chain([of_size((2e38, 2e38))]).collect()
}

/// The places on the cube, as points of space, of two directions that are an ulp apart and on different faces.
fn edges(effort: Effort) -> Vec<Measurement> {
    let of_size = |magnitude: f64| {
        let size = magnitude as f32;
        let (error, found) = worst_of(effort.share(5e-4), magnitude.to_bits(), |random| {
            let lookup = lookup(random);
            let (first, second) = (random.below(3), random.below(2));
            let second = (first + 1 + second) % 3;
            let mut direction = Vec3::ZERO;
            direction[first] = size;
            direction[second] = if random.unit() < 0.5 { -size } else { size };
            direction[3 - first - second] = component(random, size);
            let mut beside = [direction, direction];
            beside[0][first] = size.next_up();
            beside[1][first] = size.next_down();
            let [one, other] = beside.map(|direction| lookup.locate(direction));
            let apart = (lookup.direction(one) - lookup.direction(other)).abs().max_element();
            (f64::from(apart) / 2.0 / ulp_f32(1.0), direction)
        });
        Measurement::new(magnitude, error, components(found))
    };
    decades(-45, 38).step_by(2).map(of_size).collect()
}

fn not_numbers(effort: Effort) -> Vec<Measurement> {
    const STRANGE: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let of_count = |count: usize| {
        let (faults, first) = faults_of(effort.share(5e-4), count as u64, |random| {
            let mut direction = direction(random, 1.0);
            for axis in 0..count {
                direction[(axis + count) % 3] = STRANGE[random.below(3)];
            }
            let point = lookup(random).locate(direction);
            (!is_in_square(point.u, point.v) || !Face::ALL.contains(&point.face)).then_some(direction)
        });
        Measurement::new(count as f64, faults, first.map_or("none".to_owned(), components))
    };
    (1..=3).map(of_count).collect()
}
