//! Sums of many samples on the film, and whole pictures.

use super::case::{Group, Measurement, Subject};
use super::effort::{Effort, decades};
use super::reference::ulp_f32;
use super::wide::Wide;
use crate::limits::Range;
use crate::math::Vec3;
use crate::picture::Raster;
use crate::random::{Random, power_of_ten};
use crate::render::{FilmRow, Keeps, Silent, render};
use crate::scene::{Plan, Scene};

pub(super) const SUBJECTS: &[Subject] = &[
    Subject {
        group: Group::Sums,
        name: "film",
        swept: "brightest / dimmest sample",
        error: "mean of up to 10^6 samples per pixel against the exact sum, in f32 ulp",
        unit: "ulp",
        bound: 1.0,
        promised: Range::new(1.0, 1e12),
        sweep: film_by_contrast,
    },
    Subject {
        group: Group::Sums,
        name: "film-uneven",
        swept: "brightest / dimmest sample",
        error: "the same with unequal filter weights",
        unit: "ulp",
        bound: 1.0,
        promised: Range::new(1.0, 1e12),
        sweep: uneven_film_by_contrast,
    },
    Subject {
        group: Group::Sums,
        name: "scene-scale",
        swept: "scale of a whole scene",
        error: "change of the picture, root mean square; infinite for NaN or negative pixels",
        unit: "",
        bound: 1e-3,
        promised: Range::new(1e-6, 1e6),
        sweep: scene_scale,
    },
];

/// Samples of the same mean, most of them dim and a few bright: a thousandth gives half of the light.
fn film(effort: Effort, contrast: f64, uneven: bool) -> Measurement {
    let samples = effort.share(0.1).min(1_000_000) as u32;
    let mut film = FilmRow::new(Keeps { weights: uneven, layers: false });
    let mut random = Random(contrast.to_bits());
    let [mut weighted, mut plain, mut weights] = [Wide::ZERO; 3];
    for _ in 0..samples {
        let magnitude = if random.unit() < 1e-3 { contrast } else { random.unit() };
        let radiance = (magnitude * (0.5 + random.unit())) as f32;
        let weight = if uneven { 0.5 + random.unit() } else { 1.0 };
        film.add(&[Vec3::splat(radiance)], &[weight]);
        let exact = Wide::from(f64::from(radiance));
        weighted = weighted + exact * weight.into();
        plain = plain + exact;
        weights = weights + weight.into();
    }
    let count = Wide::from(f64::from(samples));
    let correction = plain / count * (weights / count - Wide::ONE);
    let truth = (weighted / count - correction).value();
    let error = (f64::from(film.pixel(0).x) - truth).abs() / ulp_f32(truth);
    Measurement::new(contrast, error, format!("{samples} samples"))
}

fn film_by_contrast(effort: Effort) -> Vec<Measurement> {
    decades(0, 30).step_by(2).map(|contrast| film(effort, contrast, false)).collect()
}

fn uneven_film_by_contrast(effort: Effort) -> Vec<Measurement> {
    decades(0, 30).step_by(2).map(|contrast| film(effort, contrast, true)).collect()
}

/// A ground of a large sphere, glass with colour in it, a mirror, a rough metal, a small light; everything scaled.
fn scene(scale: f64, integrator: &str, samples: u32) -> Option<Scene> {
    let text = format!(
        r#"
camera = {{ position = [0.0, {back:e}, {high:e}], target = [0.0, 0.0, {scale:e}], field_of_view = 50, size = [32, 24], samples = {samples} }}
integrator = {{ kind = "{integrator}", caustics = "off" }}
environment = {{ kind = "gradient", zenith = [0.2, 0.4, 0.9], horizon = [0.9, 0.9, 1.0], nadir = [0.1, 0.1, 0.1] }}
{materials}{shapes}"#,
        back = -8.0 * scale,
        high = 3.0 * scale,
        materials = scaled_materials(scale),
        shapes = scaled_shapes(scale),
    );
    Scene::from_text(&text, "scaled.toml".as_ref()).ok()
}

fn scaled_materials(scale: f64) -> String {
    format!(
        r#"
materials.ground = {{ kind = "lambert", colour = [0.5, 0.5, 0.4] }}
materials.glass = {{ kind = "glass", index = 1.5, absorption = [{absorption:e}, 0.0, {absorption:e}] }}
materials.mirror = {{ kind = "mirror" }}
materials.lamp = {{ kind = "light", radiance = [50.0, 40.0, 30.0] }}
"#,
        absorption = 0.5 / scale,
    )
}

fn scaled_shapes(scale: f64) -> String {
    let by = |number: f64| number * scale;
    format!(
        r#"
shapes = [
    {{ kind = "sphere", centre = [0.0, 0.0, {below:e}], radius = {ground:e}, material = "ground" }},
    {{ kind = "sphere", centre = [{left:e}, 0.0, {one:e}], radius = {one:e}, material = "glass" }},
    {{ kind = "box", minimum = [{small:e}, {left:e}, {small:e}], maximum = [{two:e}, {one:e}, {two:e}], material = "mirror" }},
    {{ kind = "sphere", centre = [0.0, {left:e}, {above:e}], radius = {small:e}, material = "lamp" }},
]
"#,
        below = by(-100.0),
        ground = by(100.0),
        left = by(-1.2),
        one = by(1.0),
        small = by(0.1),
        two = by(2.0),
        above = by(4.0),
    )
}

fn picture(scale: f64, integrator: &str, samples: u32) -> Option<Raster> {
    let scene = scene(scale, integrator, samples)?;
    render(&scene, &Plan::new(&scene), &Silent).ok().map(|rendering| rendering.raster)
}

fn scene_scale(effort: Effort) -> Vec<Measurement> {
    let samples = (effort.share(1e-6) as u32).clamp(1, 8);
    let usual = ["whitted", "path"].map(|integrator| picture(1.0, integrator, samples));
    let of_scale = |exponent: i32| {
        let scale = power_of_ten(exponent);
        let mut worst = Measurement::new(scale, 0.0, "none");
        for (integrator, usual) in ["whitted", "path"].into_iter().zip(&usual) {
            let error = match (usual, picture(scale, integrator, samples)) {
                (Some(usual), Some(found)) => difference(usual, &found),
                _ => f64::INFINITY,
            };
            if error >= worst.error {
                worst = Measurement::new(scale, error, integrator);
            }
        }
        worst
    };
    (-12..=12).step_by(2).map(of_scale).collect()
}

/// The root mean square difference of two pictures, infinite if a pixel is negative or no number.
fn difference(expected: &Raster, found: &Raster) -> f64 {
    let sound = |colour: &Vec3| colour.is_finite() && colour.min_element() >= 0.0;
    if !found.pixels().iter().all(sound) {
        return f64::INFINITY;
    }
    let pairs = expected.pixels().iter().zip(found.pixels());
    let squares: f64 = pairs.map(|(one, other)| f64::from((*one - *other).length_squared())).sum();
    (squares / (3.0 * expected.pixels().len() as f64)).sqrt()
}
