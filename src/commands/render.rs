//! `skycube render`: a scene to a picture.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args;

use super::options::{
    PictureOptions, PictureSize, SceneOverrides, check_pixel_count, parse_duration, refuse_to_overwrite_sources,
};
use super::progress_bar::RenderBar;
use super::terminal::{Outcome, leave_stdout_to, print, remark, tell};
use crate::error::{Error, Result};
use crate::limits::outside_limits;
use crate::picture::{self, Extras, OutputFormat, check_target, is_standard_stream, write_atomically};
use crate::render::{Budget, Layers, Renderer, Rendering, render_progressively};
use crate::report::RenderReport;
use crate::scene::{Plan, Scene};

#[derive(Debug, Args)]
pub struct RenderArguments {
    /// The scene, a TOML file; - for standard input
    scene: PathBuf,
    /// The picture to write: .png, .jpg, .hdr or .exr; - for standard output [default: the scene's name with .png, in this folder]
    #[arg(short, long, value_name = "PICTURE")]
    output: Option<PathBuf>,
    /// The file format for standard output [default: png]
    #[arg(long, value_name = "FORMAT", value_parser = ["png", "jpg", "hdr", "exr"])]
    format: Option<String>,
    /// Picture size in pixels, for instance 640x480
    #[arg(long, value_name = "WxH")]
    size: Option<PictureSize>,
    /// Render for this time, for instance 10s, 500ms or 2m, in place of a number of samples
    #[arg(long, value_name = "TIME", conflicts_with = "samples", value_parser = parse_duration)]
    time: Option<Duration>,
    /// Add layers of normal, albedo, depth and variance to an .exr
    #[arg(long)]
    layers: bool,
    #[command(flatten)]
    overrides: SceneOverrides,
    #[command(flatten)]
    picture: PictureOptions,
    /// Print the report as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// Renders, writes, and says what was done.
pub fn run(arguments: &RenderArguments) -> Result<Outcome> {
    let started = Instant::now();
    let mut scene = arguments.overrides.read_scene(&arguments.scene)?;
    if let Some(PictureSize(size)) = arguments.size {
        scene.camera = scene.camera.resized(size);
    }
    check_pixel_count(scene.camera.size())?;
    let plan = Plan::new(&scene);
    let output = arguments.output.clone().unwrap_or_else(|| default_output(&arguments.scene));
    let format = format(arguments, &output)?;
    refuse(arguments, format, &scene, &output)?;
    leave_stdout_to(&output);
    outside_limits(&scene).iter().for_each(|figure| remark(format_args!("warning: {figure}\n")));
    scene.notes.iter().for_each(|note| remark(format_args!("note: {note}\n")));
    let loaded = started.elapsed();
    let threads = arguments.overrides.threads();
    let rendering = threads.install(|| rendering(arguments, &scene, &plan))?;
    let rendered = started.elapsed();
    threads.install(|| write(arguments, format, &scene, &rendering, &output))?;
    let report = RenderReport::new(&scene, &plan, &output, &rendering, [loaded, rendered, started.elapsed()]);
    if arguments.json {
        print(format_args!("{}\n", report.to_json()));
    } else {
        tell(&report);
    }
    Ok(if rendering.stopped { Outcome::Interrupted } else { Outcome::Clean })
}

/// The format that the output's name tells, or the user for standard output.
fn format(arguments: &RenderArguments, output: &Path) -> Result<OutputFormat> {
    if is_standard_stream(output) {
        let named = Path::new("-").with_extension(arguments.format.as_deref().unwrap_or("png"));
        return OutputFormat::of_path(&named);
    }
    let format = OutputFormat::of_path(output)?;
    match &arguments.format {
        Some(name) if OutputFormat::of_path(&Path::new("-").with_extension(name))? != format => {
            Err(Error::new(format!("--format {name} contradicts the name of the picture"))
                .in_file(output)
                .help("leave --format: it is for standard output, which has no name"))
        }
        _ => Ok(format),
    }
}

/// Everything that can be refused is refused before the work.
fn refuse(arguments: &RenderArguments, format: OutputFormat, scene: &Scene, output: &Path) -> Result<()> {
    if arguments.layers && format != OutputFormat::Exr {
        return Err(Error::new("--layers needs a format with layers").in_file(output).expected("the extension .exr"));
    }
    refuse_to_overwrite_sources(output, &scene.sources)?;
    check_target(output)
}

/// The time that rays have in any case.
const SHORTEST: Duration = Duration::from_millis(100);

fn rendering(arguments: &RenderArguments, scene: &Scene, plan: &Plan) -> Result<Rendering> {
    let [width, height] = scene.camera.size();
    let pixels = (width * height) as u64;
    let started = Instant::now();
    let renderer = if arguments.layers { Renderer::with_layers(scene, plan)? } else { Renderer::new(scene, plan)? };
    let renderer = if arguments.time.is_some() { renderer.scattered() } else { renderer };
    // Tables that were built first took their part of the time. They are none of the rays that the bar goes by.
    let left = |limit: Duration| limit.saturating_sub(started.elapsed()).max(SHORTEST.min(limit));
    let (budget, bar) = match arguments.time.map(left) {
        Some(left) => (Budget::Time(left), RenderBar::until(left, "rendering")),
        None => (Budget::Samples(scene.samples), RenderBar::new(pixels * u64::from(scene.samples), "rendering")),
    };
    let rendering = render_progressively(renderer, budget, &bar);
    bar.finish();
    rendering
}

fn write(
    arguments: &RenderArguments,
    format: OutputFormat,
    scene: &Scene,
    rendering: &Rendering,
    output: &Path,
) -> Result<()> {
    let options = arguments.picture.write_options(scene.output);
    let Rendering { samples, coarse_rows, stopped, .. } = *rendering;
    let remark = match coarse_rows {
        0 => format!("stopped after {samples} samples per pixel of {}", scene.samples),
        _ => format!("stopped before every pixel had a sample: {coarse_rows} rows are coarse"),
    };
    let layers = rendering.layers.as_ref().map(Layers::named);
    let extras = Extras {
        layers: layers.as_ref().map_or(&[], |layers| layers.as_slice()),
        remark: (stopped || coarse_rows > 0).then_some(remark.as_str()),
    };
    let encoded = picture::encode_with(&rendering.raster, format, &options, extras);
    write_atomically(output, &encoded.map_err(|error| error.in_file(output))?)
}

fn default_output(scene: &Path) -> PathBuf {
    if is_standard_stream(scene) {
        return PathBuf::from("render.png");
    }
    PathBuf::from(scene.with_extension("png").file_name().unwrap_or("render.png".as_ref()))
}
