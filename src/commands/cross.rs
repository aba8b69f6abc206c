//! `skycube cross`: the unfolded cube under the lookup.

use std::path::{Path, PathBuf};

use clap::Args;

use super::library::{for_each_map, maps_at, place_of};
use super::map_options::{OpenMap, ViewOptions};
use super::options::{check_drawing_name, refuse_source_folder, refuse_to_overwrite_sources};
use super::terminal::{Outcome, leave_stdout_to, remark, tell};
use crate::colour::ToneMap;
use crate::envmap::{CubeMap, Face, SignedAxis};
use crate::error::{Error, Result};
use crate::picture::{check_target, folder_of, is_standard_stream, make_folder};
use crate::report::{
    CrossInput, Drawing, Look, MapThumbnail, draw_cross, draw_map_sheet, map_line, nothing_to_fix, picture_repairs,
};
use crate::validate::Seam;

#[derive(Debug, Args)]
pub struct CrossArguments {
    #[command(flatten)]
    view: ViewOptions,
    /// The picture to write, a .png; - for standard output. Of a folder of maps, the folder for a picture of each
    #[arg(short, long, value_name = "PICTURE")]
    output: PathBuf,
    /// Side of a face in pixels [default: 256, on a sheet 64]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(64..=4096))]
    cell: Option<u32>,
    /// Draw all maps of a folder on one sheet, small, each with its verdict
    #[arg(long, conflicts_with = "fixed")]
    sheet: bool,
    /// Draw before and after the fix side by side
    #[arg(long)]
    fixed: bool,
    /// How radiance above 1 is mapped into range
    #[arg(long, value_enum, default_value = "clamp")]
    tone_map: ToneMap,
}

/// Draws one map, each map of a folder, or all of them on a sheet.
pub fn run(arguments: &CrossArguments) -> Result<Outcome> {
    if arguments.sheet {
        return sheet(arguments);
    }
    for_each_map(&arguments.view.map.map, Some(&arguments.output), |map, output| match output {
        Some(output) if output != arguments.output => {
            make_folder(folder_of(output))?;
            // A name may contain a full stop: the extension is added, not replaced.
            let mut file = output.as_os_str().to_owned();
            file.push(".png");
            cross(arguments, map, Path::new(&file))
        }
        _ => cross(arguments, map, &arguments.output),
    })
}

/// Draws, writes, and says where.
fn cross(arguments: &CrossArguments, path: &Path, output: &Path) -> Result<Outcome> {
    let map = arguments.view.map.open_at(path)?;
    let (world_up, assumption) = arguments.view.world_up(&map);
    check_drawing_name(output)?;
    refuse_to_overwrite_sources(output, &map.sources)?;
    if !is_standard_stream(output) {
        refuse_source_folder(&map.skybox, folder_of(output))?;
    }
    check_target(output)?;
    leave_stdout_to(output);
    let (cube_map, check) = map.checked(arguments.view.filter, arguments.view.world_up)?;
    let heading = format!("{} through {}", map.name, map.lookup_name);
    let mut drawing = draw(arguments, &map, &cube_map, &check.seams, &picture_repairs(&check), world_up, &heading);
    if arguments.fixed && check.fix.changes > 0 {
        let fixed = cube_map.with_lookup(check.fix.lookup(&map.lookup));
        let heading = format!("{heading}, fixed");
        let right = draw(arguments, &map, &fixed, &check.fix.seams_after, &Default::default(), world_up, &heading);
        drawing = drawing.beside(&right);
    }
    drawing.write(output)?;
    if let Some(assumption) = assumption {
        tell(format_args!("{assumption}\n"));
    }
    if arguments.fixed && check.fix.changes == 0 {
        tell(format_args!("{}; drawn once\n", nothing_to_fix(&check)));
    }
    tell(format_args!("wrote {}: {} x {} pixels\n", output.display(), drawing.width(), drawing.height()));
    Ok(Outcome::Clean)
}

/// Draws all maps on one sheet. One that cannot be checked has its place, too.
fn sheet(arguments: &CrossArguments) -> Result<Outcome> {
    let (library, output) = (&arguments.view.map.map, &arguments.output);
    check_drawing_name(output)?;
    check_target(output)?;
    leave_stdout_to(output);
    let mut maps = Vec::new();
    for path in maps_at(library) {
        maps.push(thumbnail(arguments, &path).unwrap_or_else(|error| {
            remark(format_args!("error: {error}\n"));
            let sentence = format!("cannot be checked: {}", error.problem());
            MapThumbnail { name: place_of(library, &path).display().to_string(), verdict: None, sentence, cross: None }
        }));
    }
    let (count, failed) = (maps.len(), maps.iter().filter(|map| map.verdict.is_none()).count());
    if failed == count {
        return Err(Error::new("there is no map to draw").in_file(library));
    }
    draw_map_sheet(&maps).write(output)?;
    tell(format_args!("wrote {}: {} maps\n", output.display(), count - failed));
    if failed > 0 {
        return Err(Error::new(format!("{failed} of {count} maps could not be checked")));
    }
    Ok(Outcome::Clean)
}

/// A map as the sheet shows it.
fn thumbnail(arguments: &CrossArguments, path: &Path) -> Result<MapThumbnail> {
    let map = arguments.view.map.open_at(path)?;
    refuse_to_overwrite_sources(&arguments.output, &map.sources)?;
    if !is_standard_stream(&arguments.output) {
        refuse_source_folder(&map.skybox, folder_of(&arguments.output))?;
    }
    let (world_up, _) = arguments.view.world_up(&map);
    let (cube_map, check) = map.checked(arguments.view.filter, arguments.view.world_up)?;
    let cross = Some(draw(arguments, &map, &cube_map, &check.seams, &Default::default(), world_up, ""));
    let verdict = Some(check.verdict);
    let line = map_line(&(String::new(), Ok(check))).shown(Look::default());
    let name = place_of(&arguments.view.map.map, path).display().to_string();
    Ok(MapThumbnail { name, verdict, sentence: line.trim_start_matches([':', ' ']).trim_end().to_owned(), cross })
}

/// The cross of the map under the lookup of `map`.
fn draw(
    arguments: &CrossArguments,
    open: &OpenMap,
    map: &CubeMap,
    seams: &[Seam],
    repairs: &[Option<String>; 6],
    world_up: SignedAxis,
    heading: &str,
) -> Drawing {
    draw_cross(&CrossInput {
        map,
        world_up,
        files: &Face::ALL.map(|face| open.skybox.image(map.lookup().row(face).image).name().to_owned()),
        seams,
        repairs,
        heading,
        cell: arguments.cell.unwrap_or(if arguments.sheet { 64 } else { 256 }) as usize,
        tone_map: arguments.tone_map,
    })
}
