//! `skycube shots`: what a camera sees along the six axes of a map.

use std::path::{Path, PathBuf};

use clap::Args;

use super::library::for_each_map;
use super::map_options::{OpenMap, ViewOptions};
use super::options::{check_pixel_count, refuse_source_folder, refuse_to_overwrite_sources};
use super::own_output::{refuse_pictures_of_others, refuse_rivals};
use super::progress_bar::RenderBar;
use super::terminal::{Outcome, tell};
use crate::colour::ToneMap;
use crate::envmap::{Environment, EnvironmentKind, Face, Lookup, SignedAxis, World};
use crate::error::Result;
use crate::picture::{self, OutputFormat, Raster, WriteOptions, make_folder, write_together};
use crate::render::{AxisShot, render};
use crate::report::{CaptionedShot, Drawing, ShotsReport, draw_contact_sheet, nothing_to_fix, picture_repairs};
use crate::scene::Plan;

#[derive(Debug, Args)]
pub struct ShotsArguments {
    #[command(flatten)]
    view: ViewOptions,
    /// The folder to write posx.png to negz.png, named after the direction, and contact-sheet.png to; made if missing. Of a
    /// folder of maps, each gets its own inside
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// Side of a shot in pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 512, value_parser = side)]
    size: u32,
    /// Samples per pixel [default: 1 for shots as large as the images, up to 16 for smaller ones]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1 << 16))]
    samples: Option<u32>,
    /// Render the fixed map too, to the subfolder `fixed`, and show both on the contact sheet
    #[arg(long)]
    fixed: bool,
    /// How radiance above 1 is mapped into range
    #[arg(long, value_enum, default_value = "clamp")]
    tone_map: ToneMap,
}

/// Takes the shots of a map, or of each map of a folder.
pub fn run(arguments: &ShotsArguments) -> Result<Outcome> {
    for_each_map(&arguments.view.map.map, Some(&arguments.output), |map, output| {
        shots(arguments, map, output.unwrap_or(&arguments.output))
    })
}

/// Renders, writes, and says how the camera stood.
fn shots(arguments: &ShotsArguments, path: &Path, folder: &Path) -> Result<Outcome> {
    let size = arguments.size as usize;
    let pictures = if arguments.fixed { 12 } else { 6 };
    check_pixel_count([pictures * size, size]).map_err(|error| error.at_key("--size"))?;
    let map = arguments.view.map.open_at(path)?;
    let (world_up, assumption) = arguments.view.world_up(&map);
    let sheet_file = folder.join(CONTACT_SHEET);
    // Nothing is rendered before all targets are found free.
    let mut plans = vec![ShotPlan::new(&map, map.lookup, map.lookup_name.clone(), folder, &sheet_file)?];
    let mut without_fix = None;
    let (_, check) = map.checked(arguments.view.filter, arguments.view.world_up)?;
    plans[0].repairs = picture_repairs(&check);
    if arguments.fixed {
        if check.fix.changes > 0 {
            let name = format!("{}, fixed", map.lookup_name);
            plans.push(ShotPlan::new(&map, check.fix.lookup(&map.lookup), name, &folder.join("fixed"), &sheet_file)?);
        } else {
            without_fix = Some(nothing_to_fix(&check));
        }
    }
    let sets: Vec<ShotSet> =
        plans.into_iter().map(|plan| take(arguments, &map, plan, world_up)).collect::<Result<_>>()?;
    write(arguments, &sets, &contact_sheets(&sets, &map.name, arguments.tone_map), &sheet_file)?;
    if let Some(assumption) = assumption {
        tell(format_args!("{assumption}\n"));
    }
    if let Some(reason) = without_fix {
        tell(format_args!("{reason}; one set of shots\n"));
    }
    sets.iter().for_each(|set| tell(format_args!("{}", set.report)));
    tell(format_args!("\nwrote {}\n", sheet_file.display()));
    Ok(Outcome::Clean)
}

/// The side of a shot: one number, since shots are square.
fn side(text: &str) -> std::result::Result<u32, String> {
    let side = text.parse().ok().filter(|side| (1..=16384).contains(side));
    side.ok_or_else(|| "expected one number from 1 to 16384: shots are square".to_owned())
}

const CONTACT_SHEET: &str = "contact-sheet.png";

/// The shots that are to be taken through one lookup, and the files they go to.
struct ShotPlan {
    lookup: Lookup,
    lookup_name: String,
    targets: Vec<PathBuf>,
    /// What to do about the picture that each shot shows.
    repairs: [Option<String>; 6],
}

impl ShotPlan {
    /// A plan for a folder, with the contact sheet that goes with it. No target may be a picture of the map or of others.
    fn new(map: &OpenMap, lookup: Lookup, lookup_name: String, folder: &Path, sheet: &Path) -> Result<Self> {
        picture::check_folder_target(folder)?;
        refuse_source_folder(&map.skybox, folder)?;
        let targets: Vec<PathBuf> = Face::ALL.map(|face| folder.join(face.name()).with_extension("png")).into();
        for target in targets.iter().map(PathBuf::as_path).chain([sheet]) {
            refuse_to_overwrite_sources(target, &map.sources)?;
        }
        refuse_rivals(&targets)?;
        refuse_pictures_of_others(&targets, sheet)?;
        Ok(Self { lookup, lookup_name, targets, repairs: Default::default() })
    }
}

/// The shots through one lookup.
struct ShotSet {
    report: ShotsReport,
    rasters: Vec<Raster>,
    targets: Vec<PathBuf>,
    repairs: [Option<String>; 6],
}

/// Renders the shots that are planned.
fn take(arguments: &ShotsArguments, map: &OpenMap, plan: ShotPlan, world_up: SignedAxis) -> Result<ShotSet> {
    let ShotPlan { lookup, lookup_name, targets, repairs } = plan;
    let shots = AxisShot::all(World { up: world_up, handedness: lookup.handedness() });
    let samples = arguments.samples.unwrap_or_else(|| samples(map, arguments.size as usize));
    let rasters = render_shots(arguments, map, lookup, shots, samples)?;
    let report = ShotsReport {
        shots,
        images: Face::ALL.map(|face| map.image_of(&lookup, face)),
        world_up,
        lookup: lookup_name,
        size: arguments.size as usize,
        samples,
        written: targets.iter().map(|target| target.display().to_string()).collect(),
    };
    Ok(ShotSet { report, rasters, targets, repairs })
}

/// As many samples as texels fall into a pixel, at most 16.
fn samples(map: &OpenMap, size: usize) -> u32 {
    let widest = map.skybox.images.iter().map(|image| image.header().width).max().unwrap_or(1);
    let texels = widest.div_ceil(size) as u32;
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
        rasters.push(shot.as_seen(render(&scene, &plan, &bar).inspect_err(|_| bar.finish())?.raster));
    }
    bar.finish();
    Ok(rasters)
}

/// The contact sheets of all sets side by side.
fn contact_sheets(sets: &[ShotSet], map: &str, tone_map: ToneMap) -> Drawing {
    let sheets = sets.iter().map(|set| contact_sheet(set, map, tone_map));
    sheets.reduce(|left, right| left.beside(&right)).expect("there is at least one set")
}

fn contact_sheet(set: &ShotSet, map: &str, tone_map: ToneMap) -> Drawing {
    let shots = Face::ALL.map(|face| CaptionedShot {
        shot: set.report.shots[face.index()],
        raster: &set.rasters[face.index()],
        image: &set.report.images[face.index()],
        repair: set.repairs[face.index()].as_deref(),
    });
    let heading = format!("{map} through the lookup {}", set.report.lookup);
    draw_contact_sheet(&shots, &heading, &set.report.camera(), tone_map)
}

/// Writes all files or none.
fn write(arguments: &ShotsArguments, sets: &[ShotSet], sheet: &Drawing, sheet_file: &Path) -> Result<()> {
    let options = WriteOptions { tone_map: arguments.tone_map, ..WriteOptions::default() };
    let mut files = vec![(sheet_file, sheet.encode()?)];
    for (target, raster) in sets.iter().flat_map(|set| set.targets.iter().zip(&set.rasters)) {
        files.push((target, picture::encode(raster, OutputFormat::of_path(target)?, &options)?));
    }
    for folder in files.iter().filter_map(|(target, _)| target.parent()) {
        make_folder(folder)?;
    }
    write_together(files.iter().map(|(target, bytes)| (*target, bytes.as_slice())))
}
