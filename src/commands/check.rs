//! `skycube check`: whether six pictures fit together, and what to change if not.

use std::path::{Path, PathBuf};

use clap::Args;

use super::map_options::check_skybox;
use super::options::read_lookup;
use super::terminal::{Outcome, print, remark};
use crate::envmap::SignedAxis;
use crate::envmap::source::{Skybox, is_meant_as_map, is_passed_over, sets_in};
use crate::error::{Error, Result};
use crate::report::{CheckReport, failed_check_json};
use crate::validate::{Check, CheckOptions, Names, Verdict};

/// The options of all commands that check a map.
#[derive(Debug, Args)]
pub struct ValidationOptions {
    /// The lookup that reads the map: a preset or a TOML file with a table
    #[arg(long, value_name = "NAME|FILE.toml", default_value = "opengl")]
    pub lookup: String,
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
        CheckOptions { world_up: self.world_up, names, lookup_name: self.lookup.clone() }
    }

    /// Opens and checks a map.
    pub fn check(&self, skybox: &Skybox) -> Result<Check> {
        Ok(check_skybox(skybox, read_lookup(&self.lookup)?, &self.check_options())?.1)
    }
}

#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Folders, zips, crosses, strips or sheets; a folder of maps; one of several sets in a folder, as FOLDER/day_; or six square
    /// pictures +X -X +Y -Y +Z -Z
    #[arg(required = true, value_name = "MAP")]
    maps: Vec<PathBuf>,
    #[command(flatten)]
    validation: ValidationOptions,
    /// Exit with 1 for undecidable maps too
    #[arg(long)]
    strict: bool,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Checks one map in full, or several with a line each.
pub fn run(arguments: &CheckArguments) -> Result<Outcome> {
    read_lookup(&arguments.validation.lookup)?;
    if let Some(skybox) = Skybox::of_six_squares(&arguments.maps) {
        let name = arguments.maps.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(" ");
        return check_one(Path::new(&name), &skybox, arguments);
    }
    if let [map] = &arguments.maps[..]
        && let Ok(skybox) = Skybox::open_lenient(map)
    {
        return check_one(map, &skybox, arguments);
    }
    let maps: Vec<PathBuf> = arguments.maps.iter().flat_map(|map| maps_at(map)).collect();
    match &maps[..] {
        [map] if arguments.maps == maps => check_one(map, &Skybox::open_lenient(map)?, arguments),
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

fn check_one(map: &Path, skybox: &Skybox, arguments: &CheckArguments) -> Result<Outcome> {
    let check = match arguments.validation.check(skybox) {
        Ok(check) => check,
        // A damaged picture is a fault of the map like any other.
        Err(error) if error.is_damage() => {
            remark(format_args!("error: {error}\n"));
            if arguments.json {
                print(format_args!("{}\n", failed_check_json(&map.display().to_string(), &error)));
            }
            return Ok(Outcome::Faults);
        }
        Err(error) => return Err(error),
    };
    let report = CheckReport::new(map.display().to_string(), &check);
    if arguments.json {
        print(format_args!("{}\n", report.to_json()));
    } else {
        print(&report);
    }
    Ok(outcome(check.verdict, arguments.strict))
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

/// The number of maps per verdict.
#[derive(Default)]
struct Counts {
    fits: usize,
    broken: usize,
    undecidable: usize,
    failed: usize,
    /// Of those that failed, how many because a picture is damaged.
    damaged: usize,
}

fn check_several(maps: &[PathBuf], arguments: &CheckArguments) -> Result<Outcome> {
    let mut counts = Counts::default();
    let mut entries = Vec::new();
    for map in maps {
        entries.push(check_one_of_several(map, arguments, &mut counts));
        if !arguments.json {
            print(format_args!("{}\n", entries[entries.len() - 1]));
        }
    }
    let Counts { fits, broken, undecidable, failed, damaged } = counts;
    if arguments.json {
        print(format_args!("[\n{}\n]\n", entries.join(",\n")));
    } else {
        let count = counted(maps.len());
        print(format_args!(
            "{count}: {fits} fit, {broken} broken, {undecidable} undecidable, {failed} could not be checked\n"
        ));
    }
    if failed > damaged {
        return Err(Error::new(format!("{failed} of {} could not be checked", counted(maps.len()))));
    }
    let faults = broken > 0 || damaged > 0 || (arguments.strict && undecidable > 0);
    Ok(if faults { Outcome::Faults } else { Outcome::Clean })
}

/// `1 map`, `2 maps`.
fn counted(maps: usize) -> String {
    format!("{maps} map{}", if maps == 1 { "" } else { "s" })
}

/// The line of a map, or its JSON. What is wrong with a map that cannot be checked goes to stderr in full.
fn check_one_of_several(map: &Path, arguments: &CheckArguments, counts: &mut Counts) -> String {
    let name = map.display().to_string();
    match Skybox::open_lenient(map).and_then(|skybox| arguments.validation.check(&skybox)) {
        Ok(check) => {
            match check.verdict {
                Verdict::Fits => counts.fits += 1,
                Verdict::Broken => counts.broken += 1,
                Verdict::Undecidable => counts.undecidable += 1,
            }
            let report = CheckReport::new(name, &check);
            if arguments.json { report.to_json() } else { report.line() }
        }
        Err(error) => {
            counts.failed += 1;
            counts.damaged += usize::from(error.is_damage());
            remark(format_args!("error: {error}\n"));
            let problem = error.problem().lines().next().unwrap_or_default();
            if arguments.json {
                failed_check_json(&name, &error)
            } else {
                format!("{name}: cannot be checked: {problem}")
            }
        }
    }
}

fn outcome(verdict: Verdict, strict: bool) -> Outcome {
    match verdict {
        Verdict::Fits => Outcome::Clean,
        Verdict::Undecidable if !strict => Outcome::Clean,
        _ => Outcome::Faults,
    }
}
