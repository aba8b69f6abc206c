//! `skycube render`: a scene to a picture.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;

use super::Outcome;
use super::interrupt;
use super::options::{PictureOptions, PictureSize, SceneOverrides, check_pixel_count, refuse_to_overwrite_sources};
use super::progress_bar::RenderBar;
use crate::error::Result;
use crate::picture::{self, OutputFormat, check_target};
use crate::render::render;
use crate::report::RenderReport;
use crate::scene::Plan;

#[derive(Debug, Args)]
pub struct RenderArguments {
    /// The scene, a TOML file
    scene: PathBuf,
    /// The picture to write: .png, .jpg, .hdr or .exr [default: the scene's name with .png, in this folder]
    #[arg(short, long, value_name = "PICTURE")]
    output: Option<PathBuf>,
    /// Picture size in pixels, such as 640x480
    #[arg(long, value_name = "WxH")]
    size: Option<PictureSize>,
    #[command(flatten)]
    overrides: SceneOverrides,
    #[command(flatten)]
    picture: PictureOptions,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
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
    // Everything that can be refused is refused before the work.
    OutputFormat::of_path(&output)?;
    refuse_to_overwrite_sources(&output, &scene.sources)?;
    check_target(&output)?;
    let loaded = started.elapsed();

    let [width, height] = scene.camera.size();
    interrupt::watch();
    let bar = RenderBar::new((width * height) as u64, "rendering");
    let rendering = arguments.overrides.thread_pool()?.install(|| render(&scene, &plan, &bar));
    bar.finish();
    let rendering = rendering?;
    let rendered = started.elapsed();

    let options = arguments.picture.write_options(scene.output.tone_map);
    picture::write(&rendering.raster, &output, &options)?;
    let report = RenderReport::new(&scene, &plan, &output, rendering.counts, [loaded, rendered, started.elapsed()]);
    if arguments.json {
        println!("{}", report.to_json());
    } else {
        print!("{report}");
    }
    Ok(Outcome::Clean)
}

fn default_output(scene: &Path) -> PathBuf {
    PathBuf::from(scene.with_extension("png").file_name().unwrap_or("render.png".as_ref()))
}
