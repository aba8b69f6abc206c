//! `skycube cross`: the cube unfolded, as the lookup shows it.

use std::path::PathBuf;

use clap::Args;

use super::Outcome;
use super::map_options::{OpenMap, ViewOptions};
use super::options::refuse_to_overwrite_sources;
use super::seam_steps;
use crate::colour::ToneMap;
use crate::envmap::{Face, Lookup, SignedAxis};
use crate::error::{Error, Result};
use crate::picture::{OutputFormat, check_target};
use crate::report::{CrossInput, Drawing, draw_cross};

#[derive(Debug, Args)]
pub struct CrossArguments {
    #[command(flatten)]
    view: ViewOptions,
    /// The picture to write, a .png
    #[arg(short, long, value_name = "PICTURE")]
    output: PathBuf,
    /// Side of a face in pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 256, value_parser = clap::value_parser!(u32).range(64..=4096))]
    cell: u32,
    /// How radiance above 1 is brought into range
    #[arg(long, value_enum, default_value = "clamp")]
    tone_map: ToneMap,
}

/// Draws, writes, and says where.
pub fn run(arguments: &CrossArguments) -> Result<Outcome> {
    let map = arguments.view.map.open()?;
    let (world_up, assumption) = arguments.view.world_up();
    if OutputFormat::of_path(&arguments.output)? != OutputFormat::Png {
        return Err(Error::new("a drawing is written as PNG").in_file(&arguments.output).expected("a name with .png"));
    }
    refuse_to_overwrite_sources(&arguments.output, &map.sources)?;
    check_target(&arguments.output)?;
    let drawing = draw(arguments, &map, map.lookup, world_up)?;
    drawing.write(&arguments.output)?;
    if let Some(assumption) = assumption {
        println!("{assumption}");
    }
    println!("wrote {}: {} x {} pixels", arguments.output.display(), drawing.width(), drawing.height());
    Ok(Outcome::Clean)
}

/// The cross of the map under a lookup.
fn draw(arguments: &CrossArguments, open: &OpenMap, lookup: Lookup, world_up: SignedAxis) -> Result<Drawing> {
    let map = open.decoded(lookup, arguments.view.filter)?;
    let input = CrossInput {
        map: &map,
        world_up,
        files: &Face::ALL.map(|face| open.skybox.image(lookup.row(face).image).name().to_owned()),
        marks: &seam_steps::measure(&map),
        heading: &format!("{} through {}", open.name, open.lookup_name),
        cell: arguments.cell as usize,
        tone_map: arguments.tone_map,
    };
    Ok(draw_cross(&input))
}
