//! `skycube bake`: the surroundings of a point as the six images of a cube map.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;

use super::options::{
    PictureOptions, SceneOverrides, check_pixel_count, parse_three, read_lookup, refuse_folder_of,
    refuse_shared_images, refuse_to_overwrite_sources,
};
use super::own_output::refuse_rivals;
use super::progress_bar::RenderBar;
use super::terminal::{Outcome, leave_stdout_to, tell};
use super::threads::Threads;
use crate::envmap::{Face, Lookup};
use crate::error::Result;
use crate::math::DVec3;
use crate::picture::{self, OutputFormat, Raster, is_standard_stream, make_folder};
use crate::render::bake_face;
use crate::scene::{Plan, Scene};

#[derive(Debug, Args)]
pub struct BakeArguments {
    /// The scene, a TOML file; - for standard input
    scene: PathBuf,
    /// The folder to write posx, negx, posy, negy, posz, negz to; made if it is missing; - for a zip on standard output
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// The lookup that will read the images: a preset or a TOML file
    #[arg(long, default_value = "opengl")]
    lookup: String,
    /// Side of an image in pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 512, value_parser = clap::value_parser!(u32).range(1..=16384))]
    face_size: u32,
    /// The point to look from [default: the camera's position]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_point)]
    position: Option<DVec3>,
    /// File format of the images
    #[arg(long, value_name = "FORMAT", default_value = "png", value_parser = ["png", "jpg", "hdr", "exr"])]
    format: String,
    #[command(flatten)]
    overrides: SceneOverrides,
    #[command(flatten)]
    picture: PictureOptions,
}

/// Bakes, writes, and says where.
pub fn run(arguments: &BakeArguments) -> Result<Outcome> {
    let mut scene = arguments.overrides.read_scene(&arguments.scene)?;
    // A preset is not a file; its name has no extension, so no file of that name is refused by mistake.
    scene.sources.push(PathBuf::from(&arguments.lookup));
    let plan = Plan::new(&scene);
    let lookup = read_lookup(&arguments.lookup)?;
    let position = arguments.position.unwrap_or(scene.camera.position());
    let options = arguments.picture.write_options(scene.output);
    let targets = Face::ALL.map(|image| arguments.output.join(format!("{}.{}", image.name(), arguments.format)));
    refuse_shared_images(&lookup)?;
    let format = OutputFormat::of_path(&targets[0])?;
    refuse(&arguments.output, &targets, &scene)?;
    leave_stdout_to(&arguments.output);
    let threads = arguments.overrides.threads();
    let size = arguments.face_size as usize;
    check_pixel_count([6 * size, size])?;
    let started = Instant::now();
    let (rasters, rays) = bake(&scene, &plan, &lookup, size, position, &threads)?;
    let seconds = started.elapsed().as_secs_f64();
    let encode = |image: Face| picture::encode(&rasters[image.index()], format, &options);
    let encoded = threads.install(|| Face::ALL.map(encode));
    let mut files = Vec::new();
    for (target, bytes) in targets.iter().zip(encoded) {
        files.push((target.as_path(), bytes?));
    }
    write(&arguments.output, &files)?;
    if is_standard_stream(&arguments.output) {
        tell("wrote the six images as a zip\n");
    } else {
        targets.iter().for_each(|target| tell(format_args!("wrote {}\n", target.display())));
    }
    tell(format_args!(
        "six images of {size} x {size} texels for the lookup {}, seen from ({}, {}, {}): {seconds:.2} s, {rays} rays\n",
        arguments.lookup, position.x, position.y, position.z
    ));
    Ok(Outcome::Clean)
}

/// Everything that can be refused is refused before the work.
fn refuse(output: &Path, targets: &[PathBuf], scene: &Scene) -> Result<()> {
    if is_standard_stream(output) {
        return picture::check_target(output);
    }
    picture::check_folder_target(output)?;
    refuse_folder_of(output, &scene.sources)?;
    for target in targets {
        refuse_to_overwrite_sources(target, &scene.sources)?;
    }
    refuse_rivals(targets)
}

/// Writes all files or none; to standard output as a zip.
fn write(output: &Path, files: &[(&Path, Vec<u8>)]) -> Result<()> {
    if is_standard_stream(output) {
        let name = |target: &Path| target.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let named: Vec<_> = files.iter().map(|(target, bytes)| (name(target), bytes)).collect();
        let archive = picture::archive_of(named.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())))?;
        return picture::write_atomically(output, &archive);
    }
    make_folder(output)?;
    picture::write_together(files.iter().map(|(target, bytes)| (*target, bytes.as_slice())))
}

/// The six images, in the order of their names' faces, and the rays they took.
fn bake(
    scene: &Scene,
    plan: &Plan,
    lookup: &Lookup,
    size: usize,
    position: DVec3,
    threads: &Threads,
) -> Result<(Vec<Raster>, u64)> {
    let bar = RenderBar::new(6 * (size * size) as u64 * u64::from(scene.samples), "baking");
    let (mut rasters, mut rays) = (Vec::new(), 0);
    for face in Face::ALL {
        let rendering = threads.install(|| bake_face(scene, plan, lookup, face, size, position, &bar));
        let rendering = rendering.inspect_err(|_| bar.finish())?;
        rays += rendering.counts.traced();
        rasters.push((lookup.row(face).image, rendering.raster));
    }
    bar.finish();
    rasters.sort_by_key(|(image, _)| *image);
    Ok((rasters.into_iter().map(|(_, raster)| raster).collect(), rays))
}

fn parse_point(text: &str) -> std::result::Result<DVec3, String> {
    let point = parse_three(text).map(DVec3::from_array).filter(|point| point.is_finite());
    point.ok_or_else(|| "expected three numbers, such as 0,1.7,0".to_owned())
}
