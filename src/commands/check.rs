//! `skycube check`: whether six pictures fit together, and what to change if not.

use std::path::{Path, PathBuf};

use clap::Args;

use super::config::{Config, Reading};
use super::engine_option::EngineOption;
use super::library::{maps_at, stands_for};
use super::map_options::{DEFAULT_LOOKUP, check_skybox};
use super::options::read_lookup;
use super::report_options::ReportOptions;
use super::terminal::{Outcome, remark, show, tell};
use crate::envmap::SignedAxis;
use crate::envmap::source::Skybox;
use crate::error::{Error, Result};
use crate::report::{
    CheckReport, CheckedMap, ConfigReport, Examined, Totals, check_json, counted_maps, map_line, totals_line,
};
use crate::validate::{Check, CheckOptions, Names};

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
    /// Ignore skycube.toml, which sets lookup or engine, up axis and allowed findings of the maps below its folder
    #[arg(long)]
    pub no_config: bool,
}

impl ValidationOptions {
    /// Checks a map that is open; `path` is where its configuration is looked for. Options of the command line come first.
    pub fn check(&self, path: &Path, skybox: &Skybox) -> Result<(Check, Option<ConfigReport>, Reading)> {
        let config = if self.no_config { None } else { Config::above(path)? };
        let reading = Reading { lookup: self.lookup.clone(), engine: self.engine, world_up: self.world_up };
        let reading = reading.configured(config.as_ref());
        let (lookup, engine) = (reading.lookup.as_deref(), reading.engine);
        let names = match (self.trust_names, self.any_order) {
            (true, _) => Names::Trusted,
            (_, true) => Names::AnyOrder,
            _ => Names::Auto,
        };
        let options = CheckOptions {
            world_up: reading.world_up.or(engine.world_up()),
            names,
            lookup_name: engine.name(lookup, DEFAULT_LOOKUP),
        };
        let lookup = engine.lookup(lookup, DEFAULT_LOOKUP, skybox)?;
        Ok((check_skybox(skybox, lookup, &options)?.1, config, reading))
    }

    /// The same for a map that may not have opened.
    fn checked(&self, name: String, path: &Path, skybox: Result<Skybox>) -> CheckedMap {
        let skybox = match skybox {
            Ok(skybox) => skybox,
            Err(error) => return CheckedMap::new(name, Err(error)),
        };
        let files = skybox.images.iter().map(|image| image.file().to_path_buf()).collect();
        match self.check(path, &skybox) {
            Ok((check, config, reading)) => {
                let remarks = reading.engine.description().into_iter().chain(config.as_ref().map(ConfigReport::line));
                CheckedMap { files, remarks: remarks.collect(), config, ..CheckedMap::new(name, Ok(check)) }
            }
            Err(error) => CheckedMap { files, ..CheckedMap::new(name, Err(error)) },
        }
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
    #[command(flatten)]
    pub(super) report: ReportOptions,
}

/// Checks one map in full, or several with a line each.
pub fn run(arguments: &CheckArguments) -> Result<Outcome> {
    arguments.validation.lookup.as_deref().map(read_lookup).transpose()?;
    let check = |name: String, path: &Path, skybox| arguments.validation.checked(name, path, skybox);
    if let Some(skybox) = Skybox::of_six_squares(&arguments.maps) {
        let name = arguments.maps.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(" ");
        return report_one(check(name, &arguments.maps[0], Ok(skybox)), arguments);
    }
    if let [map] = &arguments.maps[..]
        && let Ok(skybox) = Skybox::open_lenient(map)
        && stands_for(map, &skybox)
    {
        return report_one(check(map.display().to_string(), map, Ok(skybox)), arguments);
    }
    let maps: Vec<PathBuf> = arguments.maps.iter().flat_map(|map| maps_at(map)).collect();
    match &maps[..] {
        [map] if arguments.maps == maps => {
            report_one(check(map.display().to_string(), map, Skybox::open_lenient(map)), arguments)
        }
        _ => check_several(&maps, arguments),
    }
}

/// Reports on one map in full.
fn report_one(one: CheckedMap, arguments: &CheckArguments) -> Result<Outcome> {
    let CheckArguments { report, strict, .. } = arguments;
    if report.is_text()
        && let (name, Ok(check)) = &one.map
    {
        show(&CheckReport::new(name.clone(), check).page(arguments.verbose));
        one.remarks.iter().for_each(|line| tell(format_args!("{line}\n")));
    }
    print_list(std::slice::from_ref(&one), arguments);
    let outcome = if one.has_fault(*strict) { Outcome::Faults } else { Outcome::Clean };
    match one.map.1 {
        // A damaged picture is a fault of the map like any other.
        Err(error) if error.is_damage() => remark(format_args!("error: {error}\n")),
        Err(error) => return Err(error),
        Ok(_) => {}
    }
    Ok(report.outcome(outcome))
}

fn check_several(maps: &[PathBuf], arguments: &CheckArguments) -> Result<Outcome> {
    let mut checks = Vec::new();
    for path in maps {
        let one = arguments.validation.checked(path.display().to_string(), path, Skybox::open_lenient(path));
        if let Err(error) = &one.map.1 {
            remark(format_args!("error: {error}\n"));
        }
        if arguments.report.is_text() {
            show(&map_line(&one.map));
            if one.is_allowed() {
                tell(format_args!("  {}\n", one.config.as_ref().map(ConfigReport::line).unwrap_or_default()));
            }
        }
        checks.push(one);
    }
    print_list(&checks, arguments);
    let totals = Totals::of(checks.iter().map(|one| &one.map));
    if arguments.report.is_text() {
        show(&totals_line(&totals));
        let mut configs: Vec<&str> = checks.iter().filter_map(|one| Some(one.config.as_ref()?.file.as_str())).collect();
        configs.dedup();
        configs.iter().for_each(|file| tell(format_args!("settings from {file}\n")));
    }
    let damaged = checks.iter().filter(|one| one.map.1.as_ref().is_err_and(Error::is_damage)).count();
    if totals.failed > damaged {
        return Err(Error::new(format!("{} of {} could not be checked", totals.failed, counted_maps(maps.len()))));
    }
    let faults = checks.iter().any(|one| one.has_fault(arguments.strict));
    Ok(arguments.report.outcome(if faults { Outcome::Faults } else { Outcome::Clean }))
}

/// Everything in the form that the user chose; for a person who wants the faults only, a line for each map that has some.
fn print_list(checks: &[CheckedMap], arguments: &CheckArguments) {
    let CheckArguments { report, strict, .. } = arguments;
    if report.is_quiet_text() {
        let faulty = checks.iter().filter(|one| one.has_fault(*strict));
        faulty.for_each(|one| show(&map_line(&one.map)));
    }
    let examined: Vec<Examined> = checks.iter().map(|one| one.examined(*strict)).collect();
    report.print("check", &examined, || check_json(checks));
}
