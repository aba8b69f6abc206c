//! `skycube trace`: one pixel of a scene, ray by ray.

use std::path::PathBuf;

use clap::Args;

use super::options::{PictureSize, SceneOverrides};
use super::terminal::{Outcome, print, tell};
use crate::PixelTrace;
use crate::error::{Error, Result};
use crate::report::TraceReport;
use crate::scene::{Plan, Scene};

#[derive(Debug, Args)]
pub struct TraceArguments {
    /// The scene, a TOML file
    scene: PathBuf,
    /// Column and row of the pixel, counted from the top left corner, (0, 0)
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: [usize; 2],
    /// Which sample of the pixel to follow, counted from 0
    #[arg(long, value_name = "N", default_value_t = 0)]
    sample: u32,
    /// Picture size in pixels, for instance 640x480
    #[arg(long, value_name = "WxH")]
    size: Option<PictureSize>,
    #[command(flatten)]
    overrides: SceneOverrides,
    /// Print the trace as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// Follows the pixel and prints every step.
pub fn run(arguments: &TraceArguments) -> Result<Outcome> {
    let mut scene = arguments.overrides.read_scene(&arguments.scene)?;
    if let Some(PictureSize(size)) = arguments.size {
        scene.camera = scene.camera.resized(size);
    }
    check(arguments, &scene)?;
    let plan = Plan::new(&scene);
    let threads = arguments.overrides.threads();
    let trace = threads.install(|| PixelTrace::of(&scene, &plan, arguments.pixel, arguments.sample))?;
    let file = arguments.scene.display().to_string();
    let report = TraceReport { trace: &trace, scene: &scene, plan: &plan, file: &file };
    if arguments.json {
        print(format_args!("{}\n", report.to_json()));
    } else {
        tell(&report);
    }
    Ok(Outcome::Clean)
}

/// An error if the pixel or the sample does not exist.
fn check(arguments: &TraceArguments, scene: &Scene) -> Result<()> {
    let ([x, y], [width, height]) = (arguments.pixel, scene.camera.size());
    if x >= width || y >= height {
        return Err(Error::new(format!("there is no pixel ({x}, {y})")).at_key("--pixel").expected(format!(
            "at most ({}, {}): the picture is {width} x {height}",
            width - 1,
            height - 1
        )));
    }
    if arguments.sample >= scene.samples {
        return Err(Error::new(format!("there is no sample {}", arguments.sample))
            .at_key("--sample")
            .expected(format!("at most {}: the samples of a pixel count from 0", scene.samples - 1)));
    }
    Ok(())
}

fn parse_pixel(text: &str) -> std::result::Result<[usize; 2], String> {
    let numbers: Option<Vec<usize>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y]) => Ok([x, y]),
        _ => Err("expected column and row, such as 480,300".to_owned()),
    }
}
