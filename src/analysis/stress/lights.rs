//! Light sources: a sun of one texel, nearly black environments, very small shapes.

use std::f64::consts::{PI, TAU};

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades};
use super::faces::cube_map;
use super::placed::placed;
use crate::colour::luminance;
use crate::envmap::{CubeFilter, Environment, EnvironmentKind, EnvironmentSampler, Preset};
use crate::limits::{LIGHT_AREA, Range};
use crate::math::functions::arctan2;
use crate::math::{DVec3, Vec3};
use crate::shapes::{Geometry, Outline, ShapeSampler};

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Lobes,
        name: "sun",
        swept: "one texel's brightness, sky 1",
        error: "|mean of radiance / density over samples / true light - 1|",
        unit: "",
        bound: 0.01,
        promised: Range::new(1.0, 1e6),
        sweep: sun,
    },
    Subject {
        group: Group::Lobes,
        name: "sun-texel",
        swept: "one bad texel: NaN, infinity",
        error: "share of directions or densities that are not numbers",
        unit: "",
        bound: 0.0,
        promised: Range::new(1.0, 2.0),
        sweep: bad_sun,
    },
    Subject {
        group: Group::Lobes,
        name: "black",
        swept: "radiance of a uniform sky",
        error: "relative error of the density, constant and cube map; infinite if a black sky is sampled",
        unit: "",
        bound: 1e-6,
        promised: Range::new(1e-40, 1e30),
        sweep: black,
    },
    Subject {
        group: Group::Lobes,
        name: "small-light",
        swept: "area of a light at distance 1",
        error: "|mean of 1 / density / solid angle - 1|: sphere, rectangle, disc",
        unit: "",
        bound: 1e-3,
        promised: Range::new(LIGHT_AREA.range.least, 1.0),
        sweep: small_light,
    },
];

const SIZE: usize = 16;

fn sunlit(sun: f32) -> Environment {
    let map = cube_map([SIZE, SIZE], Preset::Course.lookup(), CubeFilter::Nearest, |image, column, row| {
        Vec3::splat(if (image, column, row) == (0, 5, 9) { sun } else { 1.0 })
    });
    Environment { kind: EnvironmentKind::CubeMap(Box::new(map)), scale: 1.0 }
}

/// Solid angle of the rectangle from the centre of a face at distance 1 to (x, y) on it.
fn solid_angle_to(x: f64, y: f64) -> f64 {
    arctan2(x * y, (x * x + y * y + 1.0).sqrt())
}

/// Solid angle of a texel of a face of [`SIZE`].
fn texel_solid_angle(column: usize, row: usize) -> f64 {
    let at = |texel: usize| 2.0 * texel as f64 / SIZE as f64 - 1.0;
    let ((left, right), (top, bottom)) = ((at(column), at(column + 1)), (at(row), at(row + 1)));
    solid_angle_to(right, bottom) - solid_angle_to(left, bottom) - solid_angle_to(right, top)
        + solid_angle_to(left, top)
}

/// Samples along each side of the unit square.
const STRATA: usize = 96;

/// Stratified places of the unit square, the same number at any effort: the figures are means.
fn strata() -> impl Iterator<Item = [f64; 2]> {
    let middle = |stratum: usize| (stratum as f64 + 0.5) / STRATA as f64;
    (0..STRATA * STRATA).map(move |index| [index % STRATA, index / STRATA].map(middle))
}

fn sun(_: Effort) -> Vec<Measurement> {
    let of_brightness = |brightness: f64| {
        let environment = sunlit(brightness as f32);
        let truth = 2.0 * TAU + (f64::from(brightness as f32) - 1.0) * texel_solid_angle(5, 9);
        let Ok(sampler) = EnvironmentSampler::new(&environment) else {
            return Measurement::new(brightness, f64::INFINITY, "no sampler");
        };
        let light =
            |(direction, density): (DVec3, f64)| f64::from(luminance(environment.radiance(direction))) / density;
        let sum: f64 = strata().filter_map(|place| sampler.sample(place).map(light)).sum();
        let error = (sum / (STRATA * STRATA) as f64 / truth - 1.0).abs();
        Measurement::new(brightness, error, format!("mean of {} samples", STRATA * STRATA))
    };
    decades(0, 16).map(of_brightness).collect()
}

fn bad_sun(_: Effort) -> Vec<Measurement> {
    let of_sun = |(magnitude, sun, name): (f64, f32, &str)| {
        let Ok(sampler) = EnvironmentSampler::new(&sunlit(sun)) else {
            return Measurement::new(magnitude, f64::INFINITY, "no sampler");
        };
        let bad = |place| {
            let (direction, density): (DVec3, f64) = sampler.sample(place)?;
            let sound = direction.is_finite() && density.is_finite() && density > 0.0;
            sound.then(|| sampler.density(direction)).filter(|density| *density > 0.0)
        };
        let faults = strata().filter(|&place| bad(place).is_none()).count();
        Measurement::new(magnitude, faults as f64, name)
    };
    [(1.0, f32::NAN, "NaN"), (2.0, f32::INFINITY, "infinity")].into_iter().map(of_sun).collect()
}

fn black(_: Effort) -> Vec<Measurement> {
    let even = |radiance: f32| {
        let map = cube_map([4, 4], Preset::Course.lookup(), CubeFilter::Bilinear, |_, _, _| Vec3::splat(radiance));
        Environment { kind: EnvironmentKind::CubeMap(Box::new(map)), scale: 1.0 }
    };
    let of_radiance = |radiance: f64| {
        let Ok(sampler) = EnvironmentSampler::new(&even(radiance as f32)) else {
            return Measurement::new(radiance, f64::INFINITY, "no sampler");
        };
        let constant = Environment { kind: EnvironmentKind::Constant(Vec3::splat(radiance as f32)), scale: 1.0 };
        let constant = EnvironmentSampler::new(&constant).expect("no picture to decode");
        let off = |found: f64, truth: f64| (found / truth - 1.0).abs();
        let worst = strata().fold(0.0_f64, |worst, place| {
            let even = constant.sample(place).map_or(f64::INFINITY, |(_, density)| off(density * 2.0 * TAU, 1.0));
            let of_map = sampler.sample(place).map(|(direction, density)| off(sampler.density(direction), density));
            worst.max(even).max(of_map.unwrap_or(f64::INFINITY))
        });
        Measurement::new(radiance, worst, "constant and cube map")
    };
    let nothing = EnvironmentSampler::new(&even(0.0)).expect("nothing to decode");
    let drawn = strata().any(|place| nothing.sample(place).is_some()) || nothing.density(DVec3::X) != 0.0;
    // Black itself stands at the left end.
    let black = Measurement::new(1e-50, if drawn { f64::INFINITY } else { 0.0 }, "black");
    [black].into_iter().chain(decades(-44, 38).step_by(2).map(of_radiance)).collect()
}

/// The solid angle of a sphere, rectangle or disc of an area that is seen from a distance of 1.
fn small_light(_: Effort) -> Vec<Measurement> {
    let of_area = |area: f64| {
        let radius = (area / PI).sqrt();
        let half = area.sqrt() / 2.0;
        let rectangle = 4.0 * solid_angle_to(half, half);
        // 2 pi (1 - cos) without cancellation; of a disc its rim is visible, of a sphere the tangent cone.
        let cone = |sine_square: f64| TAU * sine_square / (1.0 + (1.0 - sine_square).sqrt());
        let square = radius * radius;
        let forms = [
            ("sphere", Geometry::Sphere, radius, cone(square)),
            ("rectangle", Geometry::Flat(Outline::Rectangle), half, rectangle),
            ("disc", Geometry::Flat(Outline::Disc), radius, cone(square / (1.0 + square))),
        ];
        let mut worst = Measurement::new(area, 0.0, "none");
        for (name, geometry, scale, truth) in forms {
            // Its axis points at the viewer.
            let light = placed(geometry, DVec3::Z, DVec3::ZERO, DVec3::splat(scale));
            let sampler = ShapeSampler::new(&light, |_| true);
            let solid_angle =
                |place| sampler.sample_towards(DVec3::ZERO, place, 0.5).map(|sample| 1.0 / sample.density);
            let sum: f64 = strata().map(|place| solid_angle(place).unwrap_or(f64::INFINITY)).sum();
            let error = (sum / (STRATA * STRATA) as f64 / truth - 1.0).abs();
            if error >= worst.error {
                worst = Measurement::new(area, error, name);
            }
        }
        worst
    };
    decades(-24, 0).map(of_area).collect()
}
