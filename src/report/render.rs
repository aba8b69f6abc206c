//! The report of `skycube render`: time, rays, and the work it left out.

use std::fmt;
use std::path::Path;
use std::time::Duration;

use serde::Serialize;

use super::grouped::grouped;
use super::json::to_json;
use crate::choice::name_of;
use crate::colour::Encoding;
use crate::envmap::Face;
use crate::integrators::RayCounts;
use crate::render::Rendering;
use crate::scene::{Mistake, Plan, Scene, Wing};

/// The report of `skycube render`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RenderReport {
    /// The picture that was written.
    pub picture: String,
    pub width: usize,
    pub height: usize,
    /// Samples per pixel.
    pub samples: u32,
    /// True if Ctrl-C ended it before all samples were taken.
    pub stopped: bool,
    /// Rows without a sample, which show a coarse picture.
    pub coarse_rows: usize,
    pub integrator: String,
    /// The code that rendered.
    pub wing: Wing,
    pub seconds: Seconds,
    pub rays: RayCounts,
    /// Rays traced a second while rendering.
    pub rays_per_second: f64,
    /// Images of the environment that were decoded.
    pub decoded: Vec<&'static str>,
    /// Mistakes that the scene asks for, one sentence each.
    pub wrong_on_purpose: Vec<&'static str>,
    pub left_out: Vec<String>,
}

/// Where the time went.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Seconds {
    pub loading: f64,
    pub rendering: f64,
    pub writing: f64,
    pub total: f64,
}

impl RenderReport {
    /// A report from the times at which loading, rendering and writing were finished, counted from the start.
    pub fn new(scene: &Scene, plan: &Plan, picture: &Path, rendering: &Rendering, finished: [Duration; 3]) -> Self {
        let rays = rendering.counts;
        let [loaded, rendered, written] = finished.map(|time| time.as_secs_f64());
        let seconds =
            Seconds { loading: loaded, rendering: rendered - loaded, writing: written - rendered, total: written };
        let [width, height] = scene.camera.size();
        let (decoded, never_seen) = decoded_images(scene);
        let mut left_out = plan.left_out(scene);
        left_out.extend(rendering.left_out.iter().cloned());
        left_out.extend(never_seen);
        Self {
            picture: picture.display().to_string(),
            width,
            height,
            samples: rendering.samples,
            stopped: rendering.stopped,
            coarse_rows: rendering.coarse_rows,
            integrator: name_of(scene.integrator.kind),
            wing: rendering.wing,
            seconds,
            rays,
            rays_per_second: rays.traced() as f64 / seconds.rendering.max(1e-9),
            decoded,
            wrong_on_purpose: wrong_on_purpose(scene),
            left_out,
        }
    }

    /// The report for machines.
    pub fn to_json(&self) -> String {
        to_json("render", self)
    }

    fn write_rays(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rays = &self.rays;
        writeln!(
            formatter,
            "rays  {} ({:.1} million per second): camera {}, reflected {}, refracted {}, shadow {}",
            grouped(rays.traced()),
            self.rays_per_second / 1e6,
            grouped(rays.camera),
            grouped(rays.reflected),
            grouped(rays.refracted),
            grouped(rays.shadow)
        )?;
        writeln!(formatter, "      {} took the environment", grouped(rays.environment))?;
        if rays.cut_by_depth > 0 {
            let cut = grouped(rays.cut_by_depth);
            writeln!(formatter, "      {cut} ended at the depth limit: their light is missing")?;
        }
        if rays.cut_by_weight > 0 {
            writeln!(formatter, "      {} cut at random, without bias", grouped(rays.cut_by_weight))?;
        }
        Ok(())
    }
}

impl fmt::Display for RenderReport {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { picture, width, height, samples, integrator, wing, seconds, .. } = self;
        let unit = if *samples == 1 { "sample" } else { "samples" };
        writeln!(
            formatter,
            "wrote {picture}: {width} x {height} pixels, {samples} {unit} each, {integrator}, {}",
            wing.name()
        )?;
        let by = if self.stopped { "by Ctrl-C" } else { "by --time" };
        match self.coarse_rows {
            0 if self.stopped => {
                writeln!(formatter, "      stopped by Ctrl-C: the picture is complete, but noisier than requested")?;
            }
            0 => {}
            rows => writeln!(formatter, "      stopped {by} before every pixel had a sample: {rows} rows are coarse")?,
        }
        writeln!(
            formatter,
            "time  {:.2} s: loading {:.2}, rendering {:.2}, writing {:.2}",
            seconds.total, seconds.loading, seconds.rendering, seconds.writing
        )?;
        self.write_rays(formatter)?;
        if !self.decoded.is_empty() {
            writeln!(formatter, "map   decoded {}", self.decoded.join(", "))?;
        }
        for mistake in &self.wrong_on_purpose {
            writeln!(formatter, "wrong on purpose: {mistake}")?;
        }
        writeln!(formatter, "left out")?;
        for item in &self.left_out {
            writeln!(formatter, "  - {item}")?;
        }
        Ok(())
    }
}

/// The mistakes that the scene asks for.
fn wrong_on_purpose(scene: &Scene) -> Vec<&'static str> {
    let acne = scene.integrator.mistake == Some(Mistake::ShadowAcne);
    let linear = scene.output.encoding == Encoding::Linear;
    let mistakes = [
        (acne, "shadow rays of local light forget the surface they leave (mistake = \"shadow-acne\")"),
        (linear, "8- and 16-bit files are written without sRGB encoding (encode = \"linear\")"),
    ];
    mistakes.into_iter().filter(|(made, _)| *made).map(|(_, sentence)| sentence).collect()
}

/// The images that were decoded, and a sentence about those that were not.
fn decoded_images(scene: &Scene) -> (Vec<&'static str>, Option<String>) {
    let Some(map) = scene.environment.cube_map() else { return (Vec::new(), None) };
    let looked_at = map.looked_at();
    let unseen: Vec<&str> = Face::ALL.into_iter().filter(|image| !looked_at.contains(image)).map(Face::name).collect();
    let sentence = (!unseen.is_empty()).then(|| format!("no ray reached {}: not decoded", unseen.join(", ")));
    (looked_at.into_iter().map(Face::name).collect(), sentence)
}
