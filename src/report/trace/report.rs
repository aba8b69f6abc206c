//! The report of `skycube trace`: the rays of one pixel as a tree, and their sum.

use std::fmt;

use super::super::json::to_json;
use super::events::{colour, environment, hit, length, light, shape_name, vector};
use super::json;
use crate::PixelTrace;
use crate::choice::name_of;
use crate::colour::{Encoding, ToneMap};
use crate::integrators::{Event, RayKind};
use crate::math::Vec3;
use crate::scene::{OutputSettings, Plan, Scene, Wing};

/// Samples listed one by one at most.
const LISTED: usize = 16;

/// A trace and the scene it is of.
#[derive(Debug, Clone)]
pub struct TraceReport<'a> {
    pub trace: &'a PixelTrace,
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    /// The scene's file.
    pub file: &'a str,
}

impl TraceReport<'_> {
    /// The report for machines.
    pub fn to_json(&self) -> String {
        to_json("trace", &json::report(self.file, self.plan.integrator, self.scene, self.trace))
    }

    fn write_events(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut depth = 0;
        for event in &self.trace.events {
            // The result of a ray stands under what it found.
            for line in self.lines(event) {
                writeln!(formatter, "{}{line}", "  ".repeat(depth))?;
            }
            match event {
                Event::Ray { .. } => depth += 1,
                Event::End { .. } => depth -= 1,
                _ => (),
            }
        }
        Ok(())
    }

    /// An event in words.
    fn lines(&self, event: &Event) -> Vec<String> {
        let scene = self.scene;
        match *event {
            Event::Ray { kind, ray, factor } => vec![ray_line(kind, ray.origin, ray.direction, factor)],
            Event::Missed { direction, environment: radiance, transmittance } => {
                let mut lines = vec![format!("hits nothing: environment {}", colour(radiance))];
                lines.extend(environment(scene, direction).into_iter().map(|line| format!("  {line}")));
                lines.extend(through_glass(transmittance));
                lines
            }
            Event::Nothing => vec!["hits nothing: no contribution".to_owned()],
            Event::Hit { ref surface, side, shading_normal, distance, cosine, transmittance } => {
                let lines = hit(scene, surface, side, shading_normal, distance, cosine);
                lines.into_iter().chain(through_glass(transmittance)).collect()
            }
            Event::Own { what, colour: shown } => vec![format!("{what}: {}", colour(shown))],
            Event::Light { number, ref outcome } => vec![light(scene, number, outcome)],
            Event::SampledLight { ray, density, weight, radiance } => {
                let found = match (radiance, scene.shapes.intersect(&ray)) {
                    (Some(radiance), _) => format!("free, radiance {}", colour(radiance)),
                    (None, Some(hit)) => {
                        format!("blocked by {} after {}", shape_name(scene, hit.id.shape), length(hit.t))
                    }
                    (None, None) => "not met".to_owned(),
                };
                let towards = vector(ray.direction);
                vec![format!("ray to a light towards {towards}, density {density:.6}, weight {weight}: {found}")]
            }
            Event::Added { what, weight, contribution } => {
                let counted = if weight == 1.0 { String::new() } else { format!(", weight {weight}") };
                vec![format!("pixel + {} ({what}{counted})", colour(contribution))]
            }
            Event::Survived { probability } => {
                vec![format!("goes on by a random decision of probability {probability}: x {}", 1.0 / probability)]
            }
            Event::End { radiance } => radiance.map(|radiance| format!("= {}", colour(radiance))).into_iter().collect(),
            _ => vec![branch_line(event)],
        }
    }

    fn write_sum(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let PixelTrace { samples, colour: sum, .. } = self.trace;
        if samples.len() > 1 {
            writeln!(formatter, "\nsample  place in the pixel    weight   radiance")?;
            for (index, sample) in samples.iter().enumerate().take(LISTED) {
                let place = sample.place;
                let at = format!("({:.4}, {:.4})", place.across, place.down);
                writeln!(formatter, "{index:>6}  {at:<20}  {:>6}   {}", place.weight, colour(sample.radiance))?;
            }
            if samples.len() > LISTED {
                writeln!(formatter, "   ...  and {} more", samples.len() - LISTED)?;
            }
        }
        let OutputSettings { tone_map, encoding } = self.scene.output;
        let [red, green, blue] = tone_map.bytes_as(*sum, encoding);
        let code = if encoding == Encoding::Srgb { "sRGB code" } else { "code of linear light, by mistake," };
        let range = if tone_map == ToneMap::Clamp { "clamped" } else { "by the scene's tone map" };
        let how = if samples.len() > 1 { "the mean of all samples" } else { "the only sample" };
        writeln!(formatter, "\npixel = {}, {how}: what an .exr holds", colour(*sum))?;
        writeln!(formatter, "8-bit {code} ({red}, {green}, {blue}), {range}")
    }
}

impl fmt::Display for TraceReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let PixelTrace { pixel: [x, y], samples, shown, .. } = self.trace;
        let integrator = name_of(self.plan.integrator);
        let count = samples.len();
        writeln!(
            formatter,
            "{}: pixel ({x}, {y}), sample {shown} of {count} (counted from 0), {integrator}\n",
            self.file
        )?;
        if self.trace.wing == Wing::Guided {
            let same = "with the same mean and other noise";
            writeln!(formatter, "The picture is rendered by guided paths, {same}; these are the textbook's.\n")?;
        }
        self.write_events(formatter)?;
        self.write_sum(formatter)
    }
}

fn ray_line(kind: RayKind, origin: crate::math::DVec3, direction: crate::math::DVec3, factor: Vec3) -> String {
    let times = if kind == RayKind::Camera { String::new() } else { format!(" x {}", colour(factor)) };
    format!("{}{times} from {} towards {}", name_of(kind), vector(origin), vector(direction))
}

fn through_glass(transmittance: Vec3) -> Option<String> {
    (transmittance != Vec3::ONE).then(|| format!("through glass: x {} for the rest of the ray", colour(transmittance)))
}

/// How a ray is sent on, or not.
fn branch_line(event: &Event) -> String {
    match *event {
        Event::Fresnel { index_before, index_beyond, reflectance, cos_transmitted } => {
            let indices = format!("Fresnel, index {index_before} to {index_beyond}");
            match cos_transmitted {
                None => format!("{indices}: total reflection"),
                Some(cosine) => format!(
                    "{indices}: reflected {reflectance:.6}, refracted {:.6} at {:.2}°",
                    1.0 - reflectance,
                    super::events::degrees(cosine)
                ),
            }
        }
        Event::CutByDepth { kind, depth } => format!("{}: not followed, depth {depth} is the limit", name_of(kind)),
        Event::CutByWeight { kind, weight } => {
            format!("{}: not followed, share {weight} of the pixel, by a random decision", name_of(kind))
        }
        Event::Scattered { specular, transmitted, density, weight } => {
            let how = if transmitted { "continues through the surface" } else { "continues, reflected" };
            let lobe = if specular { "in its single direction, probability" } else { "at random, density" };
            format!("{how}, {lobe} {density:.6}, x {}", colour(weight))
        }
        _ => String::new(),
    }
}
