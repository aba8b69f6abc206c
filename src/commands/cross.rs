//! `skycube cross`: the unfolded cube under the lookup.

use std::path::PathBuf;

use clap::Args;

use super::map_options::{OpenMap, ViewOptions};
use super::options::{check_drawing_name, refuse_source_folder, refuse_to_overwrite_sources};
use super::terminal::{Outcome, leave_stdout_to, tell};
use crate::colour::ToneMap;
use crate::envmap::{CubeMap, Face, SignedAxis};
use crate::error::Result;
use crate::picture::{check_target, folder_of};
use crate::report::{CrossInput, Drawing, draw_cross, nothing_to_fix, picture_repairs};
use crate::validate::Seam;

#[derive(Debug, Args)]
pub struct CrossArguments {
    #[command(flatten)]
    view: ViewOptions,
    /// The picture to write, a .png; - for standard output
    #[arg(short, long, value_name = "PICTURE")]
    output: PathBuf,
    /// Side of a face in pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 256, value_parser = clap::value_parser!(u32).range(64..=4096))]
    cell: u32,
    /// Draw before and after the fix side by side
    #[arg(long)]
    fixed: bool,
    /// How radiance above 1 is mapped into range
    #[arg(long, value_enum, default_value = "clamp")]
    tone_map: ToneMap,
}

/// Draws, writes, and says where.
pub fn run(arguments: &CrossArguments) -> Result<Outcome> {
    let map = arguments.view.map.open()?;
    let (world_up, assumption) = arguments.view.world_up();
    check_drawing_name(&arguments.output)?;
    refuse_to_overwrite_sources(&arguments.output, &map.sources)?;
    refuse_source_folder(&map.skybox, folder_of(&arguments.output))?;
    check_target(&arguments.output)?;
    leave_stdout_to(&arguments.output);
    let (cube_map, check) = map.checked(arguments.view.filter, arguments.view.world_up)?;
    let heading = format!("{} through {}", map.name, map.lookup_name);
    let mut drawing = draw(arguments, &map, &cube_map, &check.seams, &picture_repairs(&check), world_up, &heading);
    if arguments.fixed && check.fix.changes > 0 {
        let fixed = cube_map.with_lookup(check.fix.lookup(&map.lookup));
        let heading = format!("{heading}, fixed");
        let right = draw(arguments, &map, &fixed, &check.fix.seams_after, &Default::default(), world_up, &heading);
        drawing = drawing.beside(&right);
    }
    drawing.write(&arguments.output)?;
    if let Some(assumption) = assumption {
        tell(format_args!("{assumption}\n"));
    }
    if arguments.fixed && check.fix.changes == 0 {
        tell(format_args!("{}; drawn once\n", nothing_to_fix(&check)));
    }
    tell(format_args!("wrote {}: {} x {} pixels\n", arguments.output.display(), drawing.width(), drawing.height()));
    Ok(Outcome::Clean)
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
        cell: arguments.cell as usize,
        tone_map: arguments.tone_map,
    })
}
