//! `skycube check`: whether six pictures fit together, and what to change if not.

use std::path::{Path, PathBuf};

use clap::Args;

use super::engine_option::EngineOption;
use super::map_options::{DEFAULT_LOOKUP, check_skybox};
use super::options::read_lookup;
use super::terminal::{Outcome, print, remark, show, tell};
use crate::envmap::SignedAxis;
use crate::envmap::source::{Skybox, is_meant_as_map, is_passed_over, sets_in};
use crate::error::{Error, Result};
use crate::report::{CheckReport, Totals, check_json, counted_maps, map_line, totals_line};
use crate::validate::{Check, CheckOptions, Names, Verdict};

/// The options of all commands that check a map.
#[derive(Debug, Args)]
pub struct ValidationOptions {
    /// The lookup that reads the map: a preset or a TOML file with a table [default: opengl]
    #[arg(long, value_name = "NAME|FILE.toml")]
    pub lookup: Option<String>,
    #[command(flatten)]
    pub engine: EngineOption,
    /// The axis that points up in your world [default: +y for opengl and humus-y-up, else +z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub world_up: Option<SignedAxis>,
    /// Trust the names: no image may change places
    #[arg(long, conflicts_with = "any_order")]
    pub trust_names: bool,
    /// Ignore the names: every image may go to every face
    #[arg(long)]
    pub any_order: bool,
}

impl ValidationOptions {
    pub fn check_options(&self) -> CheckOptions {
        let names = match (self.trust_names, self.any_order) {
            (true, _) => Names::Trusted,
            (_, true) => Names::AnyOrder,
            _ => Names::Auto,
        };
        CheckOptions {
            world_up: self.world_up.or(self.engine.world_up()),
            names,
            lookup_name: self.engine.name(self.lookup.as_deref(), DEFAULT_LOOKUP),
        }
    }

    /// Opens and checks a map.
    pub fn check(&self, skybox: &Skybox) -> Result<Check> {
        let lookup = self.engine.lookup(self.lookup.as_deref(), DEFAULT_LOOKUP, skybox)?;
        Ok(check_skybox(skybox, lookup, &self.check_options())?.1)
    }
}

#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Folders, zips, crosses, strips or sheets; a folder of maps; one of several sets in a folder, as FOLDER/day_; or six square
    /// pictures +X -X +Y -Y +Z -Z; - for a zip or picture on standard input
    #[arg(required = true, value_name = "MAP")]
    maps: Vec<PathBuf>,
    #[command(flatten)]
    validation: ValidationOptions,
    /// Exit with 1 for undecidable maps too
    #[arg(long)]
    strict: bool,
    /// Show every seam and every note
    #[arg(short, long)]
    verbose: bool,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Checks one map in full, or several with a line each.
pub fn run(arguments: &CheckArguments) -> Result<Outcome> {
    arguments.validation.lookup.as_deref().map(read_lookup).transpose()?;
    if let Some(skybox) = Skybox::of_six_squares(&arguments.maps) {
        let name = arguments.maps.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(" ");
        return check_one(name, Ok(skybox), arguments);
    }
    if let [map] = &arguments.maps[..]
        && let Ok(skybox) = Skybox::open_lenient(map)
    {
        return check_one(map.display().to_string(), Ok(skybox), arguments);
    }
    let maps: Vec<PathBuf> = arguments.maps.iter().flat_map(|map| maps_at(map)).collect();
    match &maps[..] {
        [map] if arguments.maps == maps => check_one(map.display().to_string(), Skybox::open_lenient(map), arguments),
        _ => check_several(&maps, arguments),
    }
}

/// The maps that an argument stands for: those inside a folder of maps, else the argument itself.
fn maps_at(path: &Path) -> Vec<PathBuf> {
    let sets = sets_in(path);
    if !sets.is_empty() {
        return sets;
    }
    let inside = if is_map(path) { Vec::new() } else { maps_inside(path) };
    if inside.is_empty() { vec![path.to_owned()] } else { inside }
}

/// True if the path is a map, or a folder that is meant as one: what lies deeper does not stand for it.
fn is_map(path: &Path) -> bool {
    Skybox::open_lenient(path).is_ok() || is_meant_as_map(path)
}

fn check_one(name: String, skybox: Result<Skybox>, arguments: &CheckArguments) -> Result<Outcome> {
    let checks = [(name, skybox.and_then(|skybox| arguments.validation.check(&skybox)))];
    if arguments.json {
        print(format_args!("{}\n", check_json(&checks)));
    }
    let [(name, checked)] = checks;
    match checked {
        Ok(check) => {
            if !arguments.json {
                show(&CheckReport::new(name, &check).page(arguments.verbose));
                arguments.validation.engine.description().iter().for_each(tell);
            }
            Ok(outcome(check.verdict, arguments.strict))
        }
        // A damaged picture is a fault of the map like any other.
        Err(error) if error.is_damage() => {
            remark(format_args!("error: {error}\n"));
            Ok(Outcome::Faults)
        }
        Err(error) => Err(error),
    }
}

/// The maps in a folder of maps and its subfolders, sorted. A subfolder that is neither a map nor holds one, and an archive
/// that cannot be read, is listed too: its line says what is wrong. A link to a folder is followed only if that is a map.
fn maps_inside(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    let mut maps = Vec::new();
    for path in paths {
        let archive = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("zip"));
        let is_face = |name: &std::ffi::OsStr| !is_passed_over(&name.to_string_lossy());
        if path.is_file() && !archive && !path.file_name().is_some_and(is_face) {
            continue;
        }
        let sets = sets_in(&path);
        if !sets.is_empty() {
            maps.extend(sets);
        } else if archive || is_map(&path) {
            maps.push(path);
        } else if path.is_dir() && !path.is_symlink() {
            maps.extend(maps_at(&path));
        }
    }
    maps
}

fn check_several(maps: &[PathBuf], arguments: &CheckArguments) -> Result<Outcome> {
    let mut checks = Vec::new();
    for map in maps {
        let checked = Skybox::open_lenient(map).and_then(|skybox| arguments.validation.check(&skybox));
        if let Err(error) = &checked {
            remark(format_args!("error: {error}\n"));
        }
        let check = (map.display().to_string(), checked);
        if !arguments.json {
            show(&map_line(&check));
        }
        checks.push(check);
    }
    let totals = Totals::of(&checks);
    if arguments.json {
        print(format_args!("{}\n", check_json(&checks)));
    } else {
        show(&totals_line(&totals));
    }
    let Totals { broken, undecidable, failed, .. } = totals;
    let damaged = checks.iter().filter(|(_, checked)| checked.as_ref().is_err_and(Error::is_damage)).count();
    if failed > damaged {
        return Err(Error::new(format!("{failed} of {} could not be checked", counted_maps(maps.len()))));
    }
    let faults = broken > 0 || damaged > 0 || (arguments.strict && undecidable > 0);
    Ok(if faults { Outcome::Faults } else { Outcome::Clean })
}

fn outcome(verdict: Verdict, strict: bool) -> Outcome {
    match verdict {
        Verdict::Fits => Outcome::Clean,
        Verdict::Undecidable if !strict => Outcome::Clean,
        _ => Outcome::Faults,
    }
}
