//! The rays of one pixel as JSON: events in order, those of a ray nested inside it.

use serde_json::{Value, json};

use super::events::{blocker, degrees, geometry_name, light_kind, material_kind, probe, ray_name};
use crate::PixelTrace;
use crate::integrators::{Event, LightOutcome};
use crate::math::{DVec3, Side, Vec3};
use crate::scene::{IntegratorKind, Scene};

/// The whole report.
pub(super) fn report(file: &str, integrator: IntegratorKind, scene: &Scene, trace: &PixelTrace) -> Value {
    let samples: Vec<Value> = trace
        .samples
        .iter()
        .map(|sample| {
            let place = sample.place;
            json!({ "place": [place.across, place.down], "weight": place.weight, "radiance": colour(sample.radiance) })
        })
        .collect();
    json!({
        "scene": file,
        "integrator": integrator,
        "pixel": trace.pixel,
        "sample": trace.shown,
        "rays": nested(scene, &mut trace.events.iter()),
        "samples": samples,
        "colour": colour(trace.colour),
    })
}

/// The events up to the end of the ray they belong to.
fn nested<'a>(scene: &Scene, events: &mut impl Iterator<Item = &'a Event>) -> Vec<Value> {
    let mut values = Vec::new();
    while let Some(event) = events.next() {
        match event {
            Event::Ray { kind, ray, factor } => {
                let inside = nested(scene, events);
                values.push(json!({
                    "event": "ray", "kind": ray_name(*kind), "origin": vector(ray.origin),
                    "direction": vector(ray.direction), "factor": colour(*factor), "events": inside,
                }));
            }
            Event::End { radiance } => {
                values.extend(radiance.map(|radiance| json!({ "event": "end", "radiance": colour(radiance) })));
                return values;
            }
            _ => values.push(value(scene, event)),
        }
    }
    values
}

fn colour(colour: Vec3) -> [f32; 3] {
    colour.to_array()
}

fn vector(vector: DVec3) -> [f64; 3] {
    vector.to_array()
}

fn value(scene: &Scene, event: &Event) -> Value {
    match *event {
        Event::Missed { direction, environment, transmittance } => missed(scene, direction, environment, transmittance),
        Event::Hit { surface, side, shading_normal, distance, cosine, transmittance } => json!({
            "event": "hit",
            "shape": surface.id.shape + 1,
            "kind": geometry_name(scene, surface.id.shape),
            "material": scene.material_names.get(surface.material as usize),
            "material_kind": material_kind(scene, surface.material),
            "side": if side == Side::Front { "outside" } else { "inside" },
            "position": vector(surface.position),
            "normal": vector(shading_normal),
            "distance": distance,
            "degrees": degrees(cosine),
            "transmittance": colour(transmittance),
        }),
        Event::Own { what, colour: shown } => json!({ "event": "own", "what": what, "colour": colour(shown) }),
        Event::Light { number, outcome } => light(scene, number, outcome),
        Event::SampledLight { ray, density, weight, radiance } => json!({
            "event": "sampled_light", "direction": vector(ray.direction), "density": density, "weight": weight,
            "blocked": radiance.is_none(), "radiance": radiance.map(colour),
        }),
        Event::Added { what, weight, contribution } => {
            json!({ "event": "added", "what": what, "weight": weight, "contribution": colour(contribution) })
        }
        Event::Survived { probability } => json!({ "event": "survived", "probability": probability }),
        _ => branch(event),
    }
}

fn missed(scene: &Scene, direction: DVec3, environment: Vec3, transmittance: Vec3) -> Value {
    let lookup = probe(scene, direction).map(|probe| {
        let texels: Vec<Value> = probe
            .texels
            .iter()
            .map(|texel| {
                let place = texel.place;
                json!({
                    "image": place.map(|place| place.image), "column": place.map(|place| place.column),
                    "row": place.map(|place| place.row), "weight": texel.weight, "linear": colour(texel.colour),
                })
            })
            .collect();
        json!({
            "face": probe.point.face, "image": probe.row.image, "u_axis": probe.row.u.to_string(),
            "v_axis": probe.row.v.to_string(), "u": probe.point.u, "v": probe.point.v, "position": probe.position,
            "texels": texels, "linear": colour(probe.colour), "scale": scene.environment.scale,
        })
    });
    json!({
        "event": "missed", "direction": vector(direction), "environment": colour(environment),
        "transmittance": colour(transmittance), "lookup": lookup,
    })
}

fn light(scene: &Scene, number: usize, outcome: LightOutcome) -> Value {
    let (result, direction, blocked_by, contribution) = match outcome {
        LightOutcome::Ambient { contribution } => ("ambient", None, None, Some(contribution)),
        LightOutcome::Unreached => ("unreached", None, None, None),
        LightOutcome::Behind => ("behind", None, None, None),
        LightOutcome::Blocked { ray, distance } => ("blocked", Some(ray), blocker(scene, &ray, distance), None),
        LightOutcome::Free { ray, contribution, .. } => ("free", Some(ray), None, Some(contribution)),
    };
    json!({
        "event": "light", "light": number + 1, "kind": light_kind(scene, number), "result": result,
        "direction": direction.map(|ray| vector(ray.direction)), "blocked_by": blocked_by.map(|shape| shape + 1),
        "contribution": contribution.map(colour),
    })
}

/// How a ray is sent on, or not.
fn branch(event: &Event) -> Value {
    match *event {
        Event::Fresnel { index_before, index_beyond, reflectance, cos_transmitted } => json!({
            "event": "fresnel", "index_before": index_before, "index_beyond": index_beyond, "reflected": reflectance,
            "refracted": 1.0 - reflectance, "degrees": cos_transmitted.map(degrees),
        }),
        Event::CutByDepth { kind, depth } => json!({ "event": "cut_by_depth", "kind": ray_name(kind), "depth": depth }),
        Event::CutByWeight { kind, weight } => {
            json!({ "event": "cut_by_weight", "kind": ray_name(kind), "weight": weight })
        }
        Event::Scattered { specular, transmitted, density, weight } => json!({
            "event": "scattered", "specular": specular, "transmitted": transmitted, "density": density,
            "weight": colour(weight),
        }),
        _ => json!({ "event": "nothing" }),
    }
}
