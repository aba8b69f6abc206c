//! `skycube probe`: the lookup of one direction, step by step.

use clap::Args;

use super::map_options::MapOptions;
use super::options::parse_three;
use super::terminal::{Outcome, print, tell};
use crate::envmap::{CubeFilter, CubeMap, Face, Probe};
use crate::error::Result;
use crate::math::Vec3;
use crate::report::{ProbeReport, nothing_to_fix};

#[derive(Debug, Args)]
pub struct ProbeArguments {
    #[command(flatten)]
    map: MapOptions,
    /// The direction, of any length
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_direction)]
    direction: Vec3,
    /// The filter between texels
    #[arg(long, value_enum, default_value = "bilinear")]
    filter: CubeFilter,
    /// Print the steps as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// Follows the direction and prints every step.
pub fn run(arguments: &ProbeArguments) -> Result<Outcome> {
    let map = arguments.map.open()?;
    let (cube_map, check) = map.checked(arguments.filter, None)?;
    let files = Face::ALL.map(|image| map.skybox.image(image).name().to_owned());
    let follow =
        |cube_map: &CubeMap| Probe::new(cube_map, arguments.direction).map_err(|error| error.at_key("--direction"));
    let given = follow(&cube_map)?;
    let fixed_map = cube_map.with_lookup(check.fix.lookup(&map.lookup));
    let fixed = if check.fix.changes > 0 { Some(follow(&fixed_map)?) } else { None };
    let fixed_name = format!("{}, fixed", map.lookup_name);
    let report = |probe, lookup, after_fix| ProbeReport { probe, map: &map.name, lookup, files: &files, after_fix };
    let after = fixed.as_ref().map(|probe| report(probe, &fixed_name, None));
    let before = report(&given, &map.lookup_name, after.as_ref());
    if arguments.json {
        print(format_args!("{}\n", before.to_json()));
        return Ok(Outcome::Clean);
    }
    tell(&before);
    match &after {
        Some(after) => tell(format_args!("\n{after}")),
        None => tell(format_args!("\n{}\n", nothing_to_fix(&check))),
    }
    Ok(Outcome::Clean)
}

/// Three numbers; whether they make a direction is for [`Probe::new`] to say.
fn parse_direction(text: &str) -> std::result::Result<Vec3, String> {
    parse_three(text).map(Vec3::from_array).ok_or_else(|| "expected three numbers, such as 0.3,-1,0.5".to_owned())
}
