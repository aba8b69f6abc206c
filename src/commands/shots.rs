//! `skycube shots`: what a camera sees along the six axes of a map.

use std::path::{Path, PathBuf};

use clap::Args;

use super::Outcome;
use super::interrupt;
use super::map_options::{OpenMap, ViewOptions};
use super::options::refuse_to_overwrite_sources;
use super::progress_bar::RenderBar;
use crate::colour::ToneMap;
use crate::envmap::{Environment, EnvironmentKind, Face, Lookup, SignedAxis};
use crate::error::{Error, Result};
use crate::picture::{self, OutputFormat, Raster, WriteOptions, check_target, make_folder, write_together};
use crate::render::{AxisShot, render};
use crate::report::{CaptionedShot, Drawing, ShotsReport, draw_contact_sheet};
use crate::scene::Plan;

#[derive(Debug, Args)]
pub struct ShotsArguments {
    #[command(flatten)]
    view: ViewOptions,
    /// The folder to write posx.png to negz.png, named after the direction, and contact-sheet.png to; made if missing
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// Side of a shot in pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 512, value_parser = side)]
    size: u32,
    /// Samples a pixel [default: 1 for shots as large as the images, up to 16 for smaller ones]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1 << 16))]
    samples: Option<u32>,
    /// Render the fixed map too, to the folder `fixed` inside, and both side by side on the contact sheet
    #[arg(long)]
    fixed: bool,
    /// How radiance above 1 is brought into range
    #[arg(long, value_enum, default_value = "clamp")]
    tone_map: ToneMap,
}

/// Renders, writes, and says how the camera stood.
pub fn run(arguments: &ShotsArguments) -> Result<Outcome> {
    interrupt::watch();
    let map = arguments.view.map.open()?;
    let (world_up, assumption) = arguments.view.world_up();
    let fixed_lookup = if arguments.fixed {
        let (_, check) = map.checked(arguments.view.filter, arguments.view.world_up)?;
        (check.fix.changes > 0).then(|| check.fix.lookup(&map.lookup))
    } else {
        None
    };
    let folder = &arguments.output;
    let given = take(arguments, &map, map.lookup, &map.lookup_name, world_up, folder)?;
    let sheet_file = folder.join(CONTACT_SHEET);
    refuse_to_overwrite_sources(&sheet_file, &map.sources)?;
    let mut sheet = contact_sheet(&given, &map.name, arguments.tone_map);
    let mut sets = vec![given];
    if let Some(lookup) = fixed_lookup {
        let name = format!("{}, fixed", map.lookup_name);
        let fixed = take(arguments, &map, lookup, &name, world_up, &folder.join("fixed"))?;
        sheet = sheet.beside(&contact_sheet(&fixed, &map.name, arguments.tone_map));
        sets.push(fixed);
    }
    write(arguments, &sets, &sheet, &sheet_file)?;
    if let Some(assumption) = assumption {
        super::print(format_args!("{assumption}\n"));
    }
    if arguments.fixed && fixed_lookup.is_none() {
        super::print(format_args!("nothing to fix: one set of shots\n"));
    }
    for set in &sets {
        super::print(format_args!("{}", set.report));
    }
    super::print(format_args!("\nwrote {}\n", sheet_file.display()));
    Ok(Outcome::Clean)
}

/// The side of a shot: one number, since shots are square.
fn side(text: &str) -> std::result::Result<u32, String> {
    let side = text.parse().ok().filter(|side| (1..=16384).contains(side));
    side.ok_or_else(|| "expected one number from 1 to 16384: shots are square".to_owned())
}

const CONTACT_SHEET: &str = "contact-sheet.png";

/// A folder with pictures named after faces, but no contact sheet of earlier shots, may hold a student's own shots.
fn refuse_pictures_of_others(folder: &Path) -> Result<()> {
    let outer = folder.parent().unwrap_or(folder);
    if [folder, outer].iter().any(|folder| folder.join(CONTACT_SHEET).exists()) {
        return Ok(());
    }
    let Ok(entries) = std::fs::read_dir(folder) else { return Ok(()) };
    let is_shot = |path: &PathBuf| {
        let stem = path.file_stem().unwrap_or_default();
        path.is_file() && Face::ALL.iter().any(|face| stem.eq_ignore_ascii_case(face.name()))
    };
    match entries.flatten().map(|entry| entry.path()).filter(is_shot).min() {
        Some(picture) => {
            Err(Error::new("this picture is already there, and no contact sheet of earlier shots beside it")
                .in_file(picture)
                .help("it may be one of your own: name another folder with -o"))
        }
        None => Ok(()),
    }
}

/// The shots through one lookup, and the files they go to.
struct ShotSet {
    report: ShotsReport,
    rasters: Vec<Raster>,
    folder: PathBuf,
    targets: Vec<PathBuf>,
}

/// Renders the shots through a lookup for a folder.
fn take(
    arguments: &ShotsArguments,
    map: &OpenMap,
    lookup: Lookup,
    lookup_name: &str,
    world_up: SignedAxis,
    folder: &Path,
) -> Result<ShotSet> {
    picture::check_folder_target(folder)?;
    let targets = targets(folder, map)?;
    refuse_pictures_of_others(folder)?;
    let shots = AxisShot::all(world_up);
    let samples = arguments.samples.unwrap_or_else(|| samples(map, arguments.size as usize));
    let rasters = render_shots(arguments, map, lookup, shots, samples)?;
    let report = ShotsReport {
        shots,
        images: Face::ALL.map(|face| map.image_of(&lookup, face)),
        world_up,
        lookup: lookup_name.to_owned(),
        size: arguments.size as usize,
        samples,
        written: targets.iter().map(|target| target.display().to_string()).collect(),
    };
    Ok(ShotSet { report, rasters, folder: folder.to_owned(), targets })
}

/// The files of six shots, none of which may be a picture of the map.
fn targets(folder: &Path, map: &OpenMap) -> Result<Vec<PathBuf>> {
    let targets: Vec<PathBuf> = Face::ALL.map(|face| folder.join(face.name()).with_extension("png")).into();
    for target in &targets {
        refuse_to_overwrite_sources(target, &map.sources)?;
    }
    if is_same_folder(folder, &map.path) {
        return Err(Error::new("this folder holds the map: shots beside its images would make their names ambiguous")
            .in_file(folder)
            .help("choose another folder with -o"));
    }
    Ok(targets)
}

fn is_same_folder(one: &Path, other: &Path) -> bool {
    one.canonicalize().is_ok_and(|one| other.canonicalize().is_ok_and(|other| one == other))
}

/// As many samples as texels fall into a pixel, at most 16.
fn samples(map: &OpenMap, size: usize) -> u32 {
    let texels = map.skybox.images[0].header().width.div_ceil(size) as u32;
    (texels * texels).min(16)
}

/// Renders the six shots through a lookup.
fn render_shots(
    arguments: &ShotsArguments,
    map: &OpenMap,
    lookup: Lookup,
    shots: [AxisShot; 6],
    samples: u32,
) -> Result<Vec<Raster>> {
    let size = arguments.size as usize;
    let cube_map = map.cube_map(lookup, arguments.view.filter);
    let environment = Environment { kind: EnvironmentKind::CubeMap(Box::new(cube_map)), scale: 1.0 };
    let mut scene = shots[0].scene(environment, size);
    scene.samples = samples;
    let plan = Plan::new(&scene);
    let bar = RenderBar::new(6 * (size * size) as u64, "shots");
    let mut rasters = Vec::new();
    for shot in shots {
        scene.camera = shot.camera(size);
        rasters.push(render(&scene, &plan, &bar)?.raster);
    }
    bar.finish();
    Ok(rasters)
}

fn contact_sheet(set: &ShotSet, map: &str, tone_map: ToneMap) -> Drawing {
    let shots = Face::ALL.map(|face| CaptionedShot {
        shot: set.report.shots[face.index()],
        raster: &set.rasters[face.index()],
        image: &set.report.images[face.index()],
    });
    let heading = format!("{map} through the lookup {}", set.report.lookup);
    draw_contact_sheet(&shots, &heading, &set.report.camera(), tone_map)
}

/// Writes all files or none.
fn write(arguments: &ShotsArguments, sets: &[ShotSet], sheet: &Drawing, sheet_file: &Path) -> Result<()> {
    for ShotSet { folder, targets, .. } in sets {
        make_folder(folder)?;
        targets.iter().try_for_each(|target| check_target(target))?;
    }
    let options = WriteOptions { tone_map: arguments.tone_map, ..WriteOptions::default() };
    let mut files = vec![(sheet_file, sheet.encode()?)];
    for (target, raster) in sets.iter().flat_map(|set| set.targets.iter().zip(&set.rasters)) {
        files.push((target, picture::encode(raster, OutputFormat::of_path(target)?, &options)?));
    }
    write_together(files.iter().map(|(target, bytes)| (*target, bytes.as_slice())))
}
