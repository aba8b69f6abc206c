//! One pixel, watched.

use crate::error::{Error, Result};
use crate::integrators::{Blind, Event, Recorder};
use crate::math::Vec3;
use crate::render::{PixelSample, Renderer};
use crate::scene::{Plan, Scene, Wing, finished};

/// How a pixel gets its colour.
#[derive(Debug, Clone)]
pub struct PixelTrace {
    /// Column and row from the top left.
    pub pixel: [usize; 2],
    /// All samples of the pixel, in the order in which they are added.
    pub samples: Vec<PixelSample>,
    /// The number of the sample that was watched.
    pub shown: u32,
    /// The code that renders the picture; the pixel was followed by the textbook's.
    pub wing: Wing,
    /// The events of that sample.
    pub events: Vec<Event>,
    /// Linear radiance: the same bits that the renderer writes, or where it guides paths, one of the same mean.
    pub colour: Vec3,
}

impl PixelTrace {
    /// Takes all samples of a pixel, and watches one of them. An error tells that a picture of the environment cannot be
    /// decoded.
    pub fn of(scene: &Scene, plan: &Plan, pixel: [usize; 2], shown: u32) -> Result<Self> {
        let renderer = Renderer::new(scene, plan)?;
        let mut recorder = Recorder::default();
        let watched = finished(|| renderer.watch(pixel, shown, &mut recorder)).ok_or_else(|| {
            Error::new(format!("the sample takes more than {} steps", Recorder::MOST)).help("choose a smaller --depth")
        })?;
        let samples: Vec<PixelSample> = (0..scene.samples)
            .map(|index| if index == shown { watched } else { renderer.watch(pixel, index, &mut Blind) })
            .collect();
        if let Some(error) = scene.environment.error() {
            return Err(error.clone());
        }
        let colour = renderer.develop_pixel(&samples);
        Ok(Self { pixel, samples, shown, wing: renderer.wing(), events: recorder.events, colour })
    }
}
