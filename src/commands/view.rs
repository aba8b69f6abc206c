//! `skycube view`: a page to look around in the map, before and after the repair.

use std::path::{Path, PathBuf};

use clap::Args;

use super::map_options::MapOptions;
use super::options::{refuse_source_folder, refuse_to_overwrite_sources};
use super::terminal::{Outcome, tell};
use crate::envmap::{CubeFilter, SignedAxis};
use crate::error::{Error, Result};
use crate::picture::{check_target, folder_of, write_atomically};
use crate::report::{ViewInput, view_page};

/// The most bytes of the pictures in a page: with the scripts it stays below 4 MB.
const USUAL_LIMIT: usize = 3_900_000;

#[derive(Debug, Args)]
pub struct ViewArguments {
    #[command(flatten)]
    map: MapOptions,
    /// The axis that points up in the world [default: +y for opengl and humus-y-up, else +z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    world_up: Option<SignedAxis>,
    /// The page to write [default: the map's name with .html, in the current folder]
    #[arg(short, long, value_name = "PAGE.html")]
    output: Option<PathBuf>,
    /// Keep the pictures at their full size, as PNG of 8 bits, however large the page becomes
    #[arg(long)]
    full: bool,
}

/// Checks the map and writes the page.
pub fn run(arguments: &ViewArguments) -> Result<Outcome> {
    let map = arguments.map.open()?;
    let (world_up, assumption) = map.up_axis(arguments.world_up);
    // `sky.2k.zip` becomes `sky.2k.html`.
    let stem = if arguments.map.map.is_file() { Path::new(&map.name).file_stem() } else { Some(map.name.as_ref()) };
    let stem = stem.filter(|stem| *stem != "-").unwrap_or("map".as_ref()).display();
    let output = arguments.output.clone().unwrap_or_else(|| PathBuf::from(format!("{stem}.html")));
    if output.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("html")) {
        return Err(Error::new("not the name of a page").in_file(&output).expected("a name that ends in .html"));
    }
    refuse_to_overwrite_sources(&output, &map.sources)?;
    refuse_source_folder(&map.skybox, folder_of(&output))?;
    check_target(&output)?;
    let (cube_map, check) = map.checked(CubeFilter::Bilinear, arguments.world_up)?;
    let limit = if arguments.full { usize::MAX } else { USUAL_LIMIT };
    let page = view_page(&ViewInput { name: &map.name, map: &cube_map, check: &check, world_up, limit })?;
    write_atomically(&output, page.as_bytes())?;
    if let Some(assumption) = assumption {
        tell(format_args!("{assumption}\n"));
    }
    tell(format_args!("wrote {}: {} under the lookup {}\n", output.display(), check.verdict.name(), map.lookup_name));
    Ok(Outcome::Clean)
}
