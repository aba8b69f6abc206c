//! The rays of one pixel as JSON: events in order, those of a ray nested inside it.

use serde_json::{Value, json};

use super::events::{blocker, degrees, geometry_name, light_kind, material_kind, probe};
use crate::PixelTrace;
use crate::envmap::{Probe, ProbedTexel};
use crate::integrators::{Event, LightOutcome};
use crate::math::Side;
use crate::render::PixelSample;
use crate::scene::{IntegratorKind, Scene};

/// The whole report.
pub(super) fn report(file: &str, integrator: IntegratorKind, scene: &Scene, trace: &PixelTrace) -> Value {
    let sample = |sample: &PixelSample| {
        let place = sample.place;
        json!({ "place": [place.across, place.down], "weight": place.weight, "radiance": sample.radiance })
    };
    json!({
        "scene": file,
        "integrator": integrator,
        "pixel": trace.pixel,
        "sample": trace.shown,
        "rays": nested(scene, &mut trace.events.iter()),
        "samples": trace.samples.iter().map(sample).collect::<Vec<_>>(),
        "colour": trace.colour,
    })
}

/// The events up to the end of the ray they belong to.
fn nested<'a>(scene: &Scene, events: &mut impl Iterator<Item = &'a Event>) -> Vec<Value> {
    let mut values = Vec::new();
    while let Some(event) = events.next() {
        match event {
            Event::End { radiance: None } => return values,
            Event::End { .. } => {
                values.push(json!(event));
                return values;
            }
            Event::Ray { .. } => {
                let mut value = json!(event);
                value["events"] = json!(nested(scene, events));
                values.push(value);
            }
            _ => values.push(value(scene, event)),
        }
    }
    values
}

/// The numbers of an event, with the names that the scene has for them.
fn value(scene: &Scene, event: &Event) -> Value {
    let mut value = json!(event);
    let mut add = |key: &str, added: Value| value[key] = added;
    match *event {
        Event::Missed { direction, .. } => add("lookup", json!(probe(scene, direction).map(|it| lookup(scene, &it)))),
        Event::Hit { surface, side, cosine, .. } => {
            add("shape", json!(surface.id.shape + 1));
            add("kind", json!(geometry_name(scene, surface.id.shape)));
            add("material", json!(scene.material_names.get(surface.material as usize)));
            add("material_kind", json!(material_kind(scene, surface.material)));
            add("side", json!(if side == Side::Front { "outside" } else { "inside" }));
            add("position", json!(surface.position));
            add("degrees", json!(degrees(cosine)));
        }
        Event::Light { number, outcome } => return light(scene, number, outcome),
        Event::SampledLight { ray, radiance, .. } => {
            add("direction", json!(ray.direction));
            add("blocked", json!(radiance.is_none()));
        }
        Event::Fresnel { reflectance, cos_transmitted, .. } => {
            add("refracted", json!(1.0 - reflectance));
            add("degrees", json!(cos_transmitted.map(degrees)));
        }
        _ => (),
    }
    value
}

/// What a lookup goes through.
fn lookup(scene: &Scene, probe: &Probe) -> Value {
    let texel = |texel: &ProbedTexel| {
        let place = texel.place;
        json!({
            "image": place.map(|place| place.image), "column": place.map(|place| place.column),
            "row": place.map(|place| place.row), "weight": texel.weight, "linear": texel.colour,
        })
    };
    json!({
        "face": probe.point.face, "image": probe.row.image, "u_axis": probe.row.u, "v_axis": probe.row.v,
        "u": probe.point.u, "v": probe.point.v, "position": probe.position,
        "texels": probe.texels.iter().map(texel).collect::<Vec<_>>(), "linear": probe.colour,
        "scale": scene.environment.scale,
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
        "direction": direction.map(|ray| ray.direction), "blocked_by": blocked_by.map(|shape| shape + 1),
        "contribution": contribution,
    })
}
