//! Fresnel's equations, refraction, absorption.

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades, worst_of};
use super::reference::ulp_f32;
use super::wide::Wide;
use crate::limits::{INDEX, Range};
use crate::materials::beer_lambert;
use crate::materials::fresnel::{boundary, refract};
use crate::math::functions::exponential_f64;
use crate::math::{DVec3, Frame};
use crate::random::Random;

const ENERGY: &str = "|reflection + transmission - 1|, the transmission computed apart, in f32 ulp of 1";

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Optics,
        name: "fresnel-index",
        swept: "index of refraction n1 / n2",
        error: ENERGY,
        unit: "ulp",
        bound: 2.0,
        promised: INDEX.range,
        sweep: fresnel_index,
    },
    Subject {
        group: Group::Optics,
        name: "critical-angle",
        swept: "angle off the critical, rad",
        error: ENERGY,
        unit: "ulp",
        bound: 2.0,
        promised: Range::new(1e-7, 1.0),
        sweep: fresnel_critical,
    },
    Subject {
        group: Group::Optics,
        name: "fresnel-grazing",
        swept: "angle to the surface, rad",
        error: ENERGY,
        unit: "ulp",
        bound: 2.0,
        promised: Range::new(1e-9, 1.0),
        sweep: fresnel_grazing,
    },
    Subject {
        group: Group::Optics,
        name: "fresnel-faint",
        swept: "|n1 / n2 - 1|",
        error: "reflection, in f32 ulp of itself",
        unit: "ulp",
        bound: 2.0,
        promised: Range::new(1e-6, 1.0),
        sweep: fresnel_faint,
    },
    Subject {
        group: Group::Optics,
        name: "snell",
        swept: "index of refraction n1 / n2",
        error: "refracted direction: length, sine and plane, in f32 ulp of 1",
        unit: "ulp",
        bound: 1.0,
        promised: INDEX.range,
        sweep: snell,
    },
    Subject {
        group: Group::Optics,
        name: "attenuation",
        swept: "absorption x distance",
        error: "share of light left, in f32 ulp",
        unit: "ulp",
        bound: 1.0,
        promised: Range::new(1e-30, 1e30),
        sweep: attenuation,
    },
];

/// The true shares of light.
struct Shares {
    reflected: Wide,
    transmitted: Wide,
}

/// Fresnel's equations in their first form, transmission from its own amplitudes (Born and Wolf, section 1.5.2).
fn shares(cos_incident: f64, relative_index: f64) -> Shares {
    let (c, r) = (Wide::from(cos_incident), Wide::from(relative_index));
    let square = Wide::ONE - r.square() * (Wide::ONE - c.square());
    if square <= Wide::ZERO {
        return Shares { reflected: Wide::ONE, transmitted: Wide::ZERO };
    }
    let t = square.sqrt();
    let reflected = |one: Wide, other: Wide| ((one - other) / (one + other)).square();
    // Flux: n_2 cos_t / (n_1 cos_i) times the squared amplitude 2 n_1 cos_i / (...).
    let transmitted = |one: Wide, other: Wide| Wide::from(4.0) * one * other / (one + other).square();
    let mean = |shares: &dyn Fn(Wide, Wide) -> Wide| Wide::from(0.5) * (shares(r * c, t) + shares(r * t, c));
    Shares { reflected: mean(&reflected), transmitted: mean(&transmitted) }
}

/// How far the kernel's reflection and the true transmission are from 1 together, in ulp of `f32`.
fn energy_error(cos_incident: f64, relative_index: f64) -> f64 {
    let reflectance = Wide::from(boundary(cos_incident, relative_index).reflectance);
    (reflectance + shares(cos_incident, relative_index).transmitted - Wide::ONE).abs().value() / ulp_f32(1.0)
}

fn worst_angle(
    effort: Effort,
    magnitude: f64,
    draw: impl Fn(&mut Random) -> (f64, f64) + Sync,
    error: impl Fn(f64, f64) -> f64 + Sync,
) -> Measurement {
    let (worst, (cosine, index)) = worst_of(effort.share(5e-4), magnitude.to_bits(), |random| {
        let (cosine, index) = draw(random);
        (error(cosine, index), (cosine, index))
    });
    Measurement::new(magnitude, worst, format!("cos {cosine:.1e}, n1/n2 {index:.1e}"))
}

/// Cosines over nine decades from grazing to upright.
fn any_cosine(random: &mut Random) -> f64 {
    match random.below(4) {
        0 => 1.0,
        1 => random.decade(-9, 0),
        _ => random.unit(),
    }
}

fn fresnel_index(effort: Effort) -> Vec<Measurement> {
    let of_index = |index: f64| worst_angle(effort, index, |random| (any_cosine(random), index), energy_error);
    decades(-12, 12).map(of_index).collect()
}

fn fresnel_critical(effort: Effort) -> Vec<Measurement> {
    let of_angle = |angle: f64| {
        let draw = |random: &mut Random| {
            let index = 1.0 + random.unit() * random.decade(-3, 1);
            // cos_c^2 = 1 - 1 / r^2; a change of the angle changes the cosine by -sin_c times that.
            let critical = (1.0 - 1.0 / (index * index)).sqrt();
            let sign = if random.unit() < 0.5 { -1.0 } else { 1.0 };
            ((critical + sign * angle / index).clamp(0.0, 1.0), index)
        };
        worst_angle(effort, angle, draw, energy_error)
    };
    decades(-16, 0).map(of_angle).collect()
}

fn fresnel_grazing(effort: Effort) -> Vec<Measurement> {
    let of_angle = |angle: f64| {
        let draw = |random: &mut Random| {
            let index = random.decade(-6, 6);
            (angle.min(1.0), if random.unit() < 0.5 { index } else { 1.0 + random.unit() })
        };
        worst_angle(effort, angle, draw, energy_error)
    };
    decades(-16, 0).map(of_angle).collect()
}

fn fresnel_faint(effort: Effort) -> Vec<Measurement> {
    let error = |cosine: f64, index: f64| {
        let truth = shares(cosine, index).reflected.value();
        (boundary(cosine, index).reflectance - truth).abs() / ulp_f32(truth)
    };
    let of_difference = |difference: f64| {
        let draw = |random: &mut Random| {
            let cosine = 0.05 + 0.95 * random.unit();
            (cosine, if random.unit() < 0.5 { 1.0 + difference } else { 1.0 - 0.999 * difference })
        };
        // Away from Brewster's angle nothing is lost; towards it one of both polarisations vanishes, and its error with it.
        worst_angle(effort, difference, draw, error)
    };
    decades(-14, 0).map(of_difference).collect()
}

/// Rays that pass, drawn by the sine of the refracted one, in a frame that is not aligned with the axes.
fn snell(effort: Effort) -> Vec<Measurement> {
    let of_index = |index: f64| {
        let (error, sine) = worst_of(effort.share(5e-4), index.to_bits(), |random| {
            let sine = any_cosine(random) / index.max(1.0);
            let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
            let frame = Frame::around(random.direction());
            let refracted =
                frame.to_local(refract(frame.to_world(DVec3::new(sine, 0.0, -cosine)), frame.normal, index));
            let errors = [refracted.length() - 1.0, refracted.x - index * sine, refracted.y, refracted.z.max(0.0)];
            (errors.into_iter().fold(0.0, |worst: f64, error| worst.max(error.abs())) / ulp_f32(1.0), sine)
        });
        Measurement::new(index, error, format!("sin {sine:.1e}, n1/n2 {index:.0e}"))
    };
    decades(-9, 12).map(of_index).collect()
}

/// Coefficients and distances whose product is what is swept; also products that overflow `f32`.
fn attenuation(effort: Effort) -> Vec<Measurement> {
    let of_depth = |depth: f64| {
        let (error, coefficient) = worst_of(effort.share(2e-4), depth.to_bits(), |random| {
            let coefficient = (random.decade(-30, 30) * (0.5 + random.unit())) as f32;
            let distance = depth / f64::from(coefficient) * (0.5 + random.unit());
            let truth = exponential_f64(-f64::from(coefficient) * distance);
            let found = f64::from(beer_lambert(coefficient, distance));
            let sound = (0.0..=1.0).contains(&found);
            (if sound { (found - truth).abs() / ulp_f32(truth) } else { f64::INFINITY }, coefficient)
        });
        Measurement::new(depth, error, format!("absorption {coefficient:.1e}"))
    };
    decades(-40, 40).step_by(2).map(of_depth).collect()
}
