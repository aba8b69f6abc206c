//! One variant at all its steps.

use std::time::{Duration, Instant};

use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::bias::Bias;
use super::configuration::Configuration;
use super::errors::{Errors, mean_radiance};
use super::fit::slope;
use super::protocol::Protocol;
use super::reference::Reference;
use super::schedule::Schedule;
use super::variation::Variant;
use super::watch::{Watch, Work};
use crate::error::Result;
use crate::integrators::RayCounts;
use crate::picture::Raster;
use crate::render::{Progress, Renderer};
use crate::scene::{Plan, Scene};

/// A rendering after this number of samples per pixel, in the mean over the seeds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Samples per pixel.
    pub samples: u32,
    /// From the scene in memory to the picture: tables that a plan asks for included, decoding of pictures not.
    pub seconds: f64,
    /// Rays traced.
    pub rays: u64,
    /// Errors against the reference.
    pub errors: Errors,
    /// The part of the error that more samples do not remove.
    pub bias: Bias,
    /// Mean over all pixels and channels of the pictures of all seeds.
    pub mean_radiance: f64,
}

impl Step {
    /// What a second buys: `1 / (mean square error * seconds)`. The same at all steps for an error that falls with the
    /// root of the time; infinite for a perfect picture.
    pub fn efficiency(&self) -> f64 {
        1.0 / (self.errors.rmse * self.errors.rmse * self.seconds)
    }
}

/// What was measured, and what follows from it.
impl Serialize for Step {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let Self { samples, seconds, rays, errors, bias, mean_radiance } = self;
        let mut keys = serializer.serialize_struct("Step", 14)?;
        keys.serialize_field("samples", samples)?;
        keys.serialize_field("seconds", seconds)?;
        keys.serialize_field("rays", rays)?;
        keys.serialize_field("rmse", &errors.rmse)?;
        keys.serialize_field("relative_mse", &errors.relative_mse)?;
        keys.serialize_field("trimmed_relative_mse", &errors.trimmed_relative_mse)?;
        keys.serialize_field("flip", &errors.flip)?;
        keys.serialize_field("bias", &bias.root())?;
        keys.serialize_field("bias_limit", &bias.limit())?;
        keys.serialize_field("bias_is_significant", &bias.is_significant())?;
        keys.serialize_field("bias_squared", &bias.squared)?;
        keys.serialize_field("bias_squared_error", &bias.squared_error)?;
        keys.serialize_field("mean_radiance", mean_radiance)?;
        // Null where it is infinite.
        keys.serialize_field("efficiency", &self.efficiency())?;
        keys.end()
    }
}

/// Slopes of the root mean square error in a log-log plot: -0.5 for independent samples, steeper for better ones, 0 for
/// what does not converge.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Fit {
    /// Against samples per pixel; `None` with fewer than two usable steps.
    #[serde(rename = "slope_against_samples")]
    pub against_samples: Option<f64>,
    /// Against seconds; `None` with fewer than two usable steps.
    #[serde(rename = "slope_against_seconds")]
    pub against_seconds: Option<f64>,
    /// Steps it was fitted to: those whose error is at least twice that of the reference, which hides smaller ones.
    #[serde(rename = "steps_fitted")]
    pub steps: usize,
}

/// One variant at all its steps.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Curve {
    /// The variant, as tables and plots name it.
    pub label: String,
    /// All settings of the variant.
    pub configuration: Configuration,
    /// Number of the reference that the errors are against.
    pub reference: usize,
    /// By growing number of samples.
    pub steps: Vec<Step>,
    /// Slopes of the error over the steps.
    #[serde(flatten)]
    pub fit: Fit,
}

/// How far above the error of the reference an error must be to tell something of the rendering.
const ABOVE_REFERENCE: f64 = 2.0;

impl Curve {
    /// Measures a variant, whose settings the scene has, until the schedule is finished or it is asked to stop; a step
    /// that was begun and not finished is left out.
    pub(super) fn measure(
        scene: &Scene,
        variant: &Variant,
        number: usize,
        reference: &Reference,
        protocol: &Protocol,
        watch: &impl Watch,
    ) -> Result<Self> {
        let phase =
            watch.begin(if variant.label.is_empty() { "rendering" } else { &variant.label }, work(scene, protocol));
        let mut steps = Vec::new();
        match take_steps(scene, reference, protocol, &phase, &mut steps) {
            Err(error) if !phase.cancelled() => Err(error),
            _ => Ok(Self::of_steps(variant, number, steps, reference)),
        }
    }

    fn of_steps(variant: &Variant, number: usize, steps: Vec<Step>, reference: &Reference) -> Self {
        let floor = ABOVE_REFERENCE * reference.facts.errors.rmse;
        let told: Vec<&Step> = steps.iter().filter(|step| step.errors.rmse >= floor).collect();
        let against =
            |cost: fn(&Step) -> f64| slope(&told.iter().map(|step| (cost(step), step.errors.rmse)).collect::<Vec<_>>());
        let fit = Fit {
            against_samples: against(|step| f64::from(step.samples)),
            against_seconds: against(|step| step.seconds),
            steps: told.len(),
        };
        Self { label: variant.label.clone(), configuration: variant.configuration, reference: number, steps, fit }
    }
}

/// Takes the steps of a schedule. An error if that is cancelled.
fn take_steps(
    scene: &Scene,
    reference: &Reference,
    protocol: &Protocol,
    phase: &dyn Progress,
    steps: &mut Vec<Step>,
) -> Result<()> {
    let plan = Plan::new(scene);
    decode_pictures(scene, &plan, phase)?;
    let mut runs = (0..protocol.seeds)
        .map(|index| Run::new(scene, &plan, scene.sampling.seed.wrapping_add(index)))
        .collect::<Result<Vec<_>>>()?;
    while let Some(samples) = protocol.schedule.next(runs[0].renderer.samples(), mean_time(&runs)) {
        runs.iter_mut().try_for_each(|run| run.grow(samples, phase))?;
        steps.push(step(samples, &runs, reference));
    }
    Ok(())
}

/// A rendering that grows, and the time it took so far.
struct Run<'a> {
    renderer: Renderer<'a>,
    time: Duration,
}

impl<'a> Run<'a> {
    fn new(scene: &'a Scene, plan: &'a Plan, seed: u32) -> Result<Self> {
        let started = Instant::now();
        let renderer = Renderer::new(scene, plan)?.scattered().seeded(seed);
        Ok(Self { renderer, time: started.elapsed() })
    }

    fn grow(&mut self, samples: u32, progress: &dyn Progress) -> Result<()> {
        let started = Instant::now();
        self.renderer.add_samples(samples - self.renderer.samples(), progress)?;
        self.time += started.elapsed();
        Ok(())
    }
}

fn mean_time(runs: &[Run]) -> Duration {
    runs.iter().map(|run| run.time).sum::<Duration>() / runs.len() as u32
}

/// One sample that is not measured: pictures of the environment are decoded when a ray first reaches them.
fn decode_pictures(scene: &Scene, plan: &Plan, phase: &dyn Progress) -> Result<()> {
    Renderer::new(scene, plan)?.scattered().add_samples(1, phase)
}

fn work(scene: &Scene, protocol: &Protocol) -> Work {
    let [width, height] = scene.camera.size();
    match &protocol.schedule {
        Schedule::Samples(steps) => {
            let samples = steps.last().map_or(0, |&samples| u64::from(samples) * u64::from(protocol.seeds));
            Work::Samples((samples + 1) * (width * height) as u64)
        }
        Schedule::Time(limit) => Work::Time(*limit * protocol.seeds),
    }
}

fn step(samples: u32, runs: &[Run], reference: &Reference) -> Step {
    let mut counts = RayCounts::default();
    let mut pictures: Vec<Raster> = Vec::new();
    for run in runs {
        let rendering = run.renderer.rendering(false);
        counts += rendering.counts;
        pictures.push(rendering.raster);
    }
    Step {
        samples,
        seconds: mean_time(runs).as_secs_f64(),
        rays: counts.traced() / runs.len() as u64,
        errors: Errors::mean_between(&pictures, &reference.mean),
        bias: Bias::estimate(&pictures, &reference.halves),
        mean_radiance: pictures.iter().map(mean_radiance).sum::<f64>() / pictures.len() as f64,
    }
}
