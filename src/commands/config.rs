//! `skycube.toml`: what holds for all maps below a folder, so that nobody repeats it on the command line.
//!
//! ```toml
//! lookup = "humus-z-up"        # or a table, as a file relative to this one; or `engine = "unity"`
//! world_up = "+z"
//!
//! [[allow]]
//! maps = "night/*"             # relative to this file; `**` stands for folders of any depth
//! findings = ["exposure", "outlier"]
//! ```

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use glob::{MatchOptions, Pattern};
use skycube_files::document::{Document, Table, Value};

use super::engine_option::EngineOption;
use super::library::resolved;
use crate::choice::names_of;
use crate::envmap::{Engine, Preset, SignedAxis};
use crate::error::{Error, Result};
use crate::report::ConfigReport;
use crate::validate::KINDS;

const NAME: &str = "skycube.toml";

/// A configuration file.
#[derive(Debug)]
pub struct Config {
    file: PathBuf,
    folder: PathBuf,
    lookup: Option<String>,
    engine: Option<Engine>,
    world_up: Option<SignedAxis>,
    allowances: Vec<Allowance>,
}

/// How a map is read: as the command line says, else as the configuration does.
#[derive(Debug, Clone)]
pub struct Reading {
    /// The name of the lookup, if somebody gave one.
    pub lookup: Option<String>,
    /// The engine, if somebody named one.
    pub engine: EngineOption,
    /// The axis that points up, if somebody named it.
    pub world_up: Option<SignedAxis>,
}

impl Reading {
    /// Adds what the configuration says to what the command line leaves open. Lookup and engine go together.
    pub fn configured(mut self, config: Option<&ConfigReport>) -> Self {
        let Some(config) = config else { return self };
        if self.lookup.is_none() && !self.engine.is_given() {
            self.lookup.clone_from(&config.lookup);
            self.engine = EngineOption::of(config.engine);
        }
        // An engine that the command line names brings its own axis.
        let up = if self.engine.is_given() && config.engine.is_none() { None } else { config.world_up };
        self.world_up = self.world_up.or(up);
        self
    }
}

/// Findings that are no faults in some maps.
#[derive(Debug)]
struct Allowance {
    maps: Pattern,
    findings: Vec<String>,
}

impl Allowance {
    /// True if the pattern matches a map, or a folder above it: `night/**` and `night` both mean the map `night`.
    fn covers(&self, map: &Path) -> bool {
        let written = self.maps.as_str();
        let above = written.strip_suffix("/**").or_else(|| written.strip_suffix('/'));
        let above = above.and_then(|above| Pattern::new(above).ok());
        [Some(&self.maps), above.as_ref()].into_iter().flatten().any(|maps| maps.matches_path_with(map, BY_FOLDER))
    }
}

/// `*` stays within a folder.
const BY_FOLDER: MatchOptions =
    MatchOptions { case_sensitive: true, require_literal_separator: true, require_literal_leading_dot: false };

impl Config {
    /// The configuration for a map: that in its folder, or in the nearest folder above that has one.
    pub fn above(map: &Path) -> Result<Option<ConfigReport>> {
        let place = resolved(map);
        let folder = place.ancestors().find(|folder| folder.join(NAME).is_file());
        folder.map(|folder| Ok(Self::read(folder)?.for_map(&place))).transpose()
    }

    fn read(folder: &Path) -> Result<Self> {
        let file = shown(&folder.join(NAME));
        let document = Document::read(&file)?;
        let parsed = document.parse()?;
        let mut table = document.root(&parsed);
        let lookup = table.optional("lookup").map(|value| lookup(&value)).transpose()?;
        let engine = table.optional("engine").map(|value| engine(&value)).transpose()?;
        let world_up = table.optional("world_up").map(|value| axis(&value)).transpose()?;
        if let (Some(lookup), Some(engine)) = (&lookup, &engine) {
            return Err(Error::new(format!(
                "lookup = \"{lookup}\" and engine = \"{}\": an engine brings its lookup with it",
                engine.name()
            ))
            .in_file(&file)
            .expected("one of the two"));
        }
        let allowances = match table.optional("allow") {
            Some(value) => value.list()?.iter().map(|value| allowance(value.table()?)).collect::<Result<_>>()?,
            None => Vec::new(),
        };
        table.finish()?;
        Ok(Self { file, folder: folder.to_owned(), lookup, engine, world_up, allowances })
    }

    fn for_map(self, map: &Path) -> ConfigReport {
        let inside = map.strip_prefix(&self.folder).unwrap_or(map);
        let here = self.allowances.iter().filter(|one| one.covers(inside));
        let mut allow: Vec<String> = here.flat_map(|one| one.findings.clone()).collect();
        allow.sort();
        allow.dedup();
        let Self { file, lookup, engine, world_up, .. } = self;
        ConfigReport { file: file.display().to_string(), lookup, engine, world_up, allow }
    }
}

/// The path from where the command runs, if it is below.
fn shown(file: &Path) -> PathBuf {
    let here = std::env::current_dir().and_then(|here| here.canonicalize()).unwrap_or_default();
    file.strip_prefix(here).unwrap_or(file).to_owned()
}

fn lookup(value: &Value) -> Result<String> {
    let name = value.text()?;
    if Preset::named(name).is_some() {
        return Ok(name.to_owned());
    }
    let file = value.path()?;
    if file.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        return Ok(file.display().to_string());
    }
    Err(value
        .error(format!("there is no lookup \"{name}\""))
        .expected(format!("one of {}, or a TOML file with your table", names_of::<Preset>().join(", "))))
}

fn engine(value: &Value) -> Result<Engine> {
    let name = value.text()?;
    let error = |_| value.error(format!("there is no engine \"{name}\"")).expected(names_of::<Engine>().join(", "));
    Engine::from_str(name, false).map_err(error)
}

fn axis(value: &Value) -> Result<SignedAxis> {
    let name = value.text()?;
    name.parse().map_err(|_| value.error(format!("found \"{name}\"")).expected("an axis: +x, -x, +y, -y, +z or -z"))
}

fn allowance(mut table: Table) -> Result<Allowance> {
    let maps = table.required("maps")?;
    let pattern = Pattern::new(maps.text()?)
        .map_err(|error| maps.error(format!("this is no pattern: {}", error.msg)).expected("a path with * and **"))?;
    let mut findings = Vec::new();
    for value in table.required("findings")?.list()? {
        let kind = value.text()?;
        if !KINDS.iter().any(|(known, _)| *known == kind) {
            let kinds = KINDS.map(|(kind, _)| kind).join(", ");
            return Err(value.error(format!("there is no finding \"{kind}\"")).expected(format!("one of {kinds}")));
        }
        findings.push(kind.to_owned());
    }
    table.finish()?;
    Ok(Allowance { maps: pattern, findings })
}
