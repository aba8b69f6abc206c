//! The checks of one map or several, for programs.
//!
//! The JSON has an entry for each map, and `totals`. An entry has these keys, in this order, or `{ map, error }`; numbers are
//! rounded to the digits that are stable:
//!
//! ```text
//! map, lookup
//! images:     [ { face, file, width, height, format } ]                       six, by name
//! verdict:    fits | broken | undecidable
//! seams:      [ { edge, step, detail, score, verdict } ]                      twelve, as they are now
//! fix:        { faces: [ { face, image, u, v, image_operation, decided } ],   six; u, v of those the lookup computes
//!               story, also: [ text ], changes, convention, margin, seams_after, equivalents }
//! handedness: { mirrored: [ face ] }
//! notes:      [ text ]
//! findings:   [ { kind, level, sentence, images: [ face ], files: [ text ], the figures of that kind, allowed } ]
//! config:     { file, lookup, engine, world_up, allow: [ kind ] } or null
//! ```

use std::path::PathBuf;

use serde::Serialize;

use super::check::{CheckReport, MapCheck, Totals};
use super::formats::{Examined, ReportedFinding};
use super::json::to_json;
use crate::envmap::{Engine, SignedAxis};
use crate::error::Result;
use crate::validate::{Check, Finding, KINDS, Level, Verdict};

/// A map that was checked, with what a list of findings needs.
pub struct CheckedMap {
    /// As the user calls it, and what was found.
    pub map: MapCheck,
    /// The files of its images, in the order of [`crate::envmap::Face::ALL`]; none if it could not be opened.
    pub files: Vec<PathBuf>,
    /// What a configuration file says about this map.
    pub config: Option<ConfigReport>,
    /// Lines below the report: how the engine shows the map, what was configured.
    pub remarks: Vec<String>,
}

/// What a configuration file says about a map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConfigReport {
    /// Its path.
    pub file: String,
    /// The lookup that it sets.
    pub lookup: Option<String>,
    /// The engine that it sets.
    pub engine: Option<Engine>,
    /// The up axis that it sets.
    pub world_up: Option<SignedAxis>,
    /// The kinds of findings that it allows in this map.
    pub allow: Vec<String>,
}

impl ConfigReport {
    /// `skies/skycube.toml: lookup course, world up +z, allows exposure`.
    pub fn line(&self) -> String {
        let lookup = self.lookup.iter().map(|lookup| format!("lookup {lookup}"));
        let engine = self.engine.iter().map(|engine| format!("engine {}", engine.name()));
        let up = self.world_up.iter().map(|up| format!("world up {up}"));
        let allowed = (!self.allow.is_empty()).then(|| format!("allows {}", self.allow.join(", ")));
        let parts: Vec<String> = lookup.chain(engine).chain(up).chain(allowed).collect();
        let what = if parts.is_empty() { "sets nothing for this map".to_owned() } else { parts.join(", ") };
        format!("{}: {what}", self.file)
    }
}

/// A finding, and whether the configuration allows it.
#[derive(Serialize)]
struct JudgedFinding {
    #[serde(flatten)]
    finding: Finding,
    allowed: bool,
}

impl CheckedMap {
    /// A check without a configuration file.
    pub fn new(name: impl Into<String>, checked: Result<Check>) -> Self {
        Self { map: (name.into(), checked), files: Vec::new(), config: None, remarks: Vec::new() }
    }

    /// True if the map has a fault that is not allowed; with `strict`, undecidable maps have one too.
    pub fn has_fault(&self, strict: bool) -> bool {
        match &self.map.1 {
            Ok(check) => self.judged(check).iter().any(|JudgedFinding { finding, allowed }| {
                !allowed && (finding.level == Level::Error || (strict && finding.level == Level::Warning))
            }),
            Err(error) => error.is_damage(),
        }
    }

    /// True if the map is broken, and all its faults are allowed.
    pub fn is_allowed(&self) -> bool {
        self.map.1.as_ref().is_ok_and(|check| check.verdict == Verdict::Broken) && !self.has_fault(false)
    }

    /// What was found, for formats that list findings.
    pub(crate) fn examined(&self, strict: bool) -> Examined {
        let (name, checked) = &self.map;
        let check = match checked {
            Ok(check) => check,
            Err(error) => return Examined::failed(name.clone(), error),
        };
        let reported = |JudgedFinding { finding, allowed }: JudgedFinding| {
            let file = finding.images.first().and_then(|image| self.files.get(image.index()));
            ReportedFinding {
                kind: finding.kind,
                meaning: KINDS.iter().find(|(kind, _)| *kind == finding.kind).map(|(_, meaning)| *meaning),
                level: if strict && finding.level == Level::Warning { Level::Error } else { finding.level },
                sentence: finding.sentence,
                file: file.cloned().unwrap_or_else(|| PathBuf::from(name)),
                allowed,
            }
        };
        let findings = self.judged(check).into_iter().map(reported).collect();
        Examined { name: name.clone(), verdict: check.verdict.name(), findings }
    }

    fn judged(&self, check: &Check) -> Vec<JudgedFinding> {
        let allows = |kind: &str| self.config.as_ref().is_some_and(|config| config.allow.iter().any(|one| one == kind));
        let judged = |finding: Finding| JudgedFinding { allowed: allows(finding.kind), finding };
        check.findings().into_iter().map(judged).collect()
    }
}

/// The report for machines, on one map or several.
pub fn check_json(checks: &[CheckedMap]) -> String {
    #[derive(Serialize)]
    struct Json<'a> {
        maps: Vec<Entry<'a>>,
        totals: TotalsAndAllowed,
    }
    #[derive(Serialize)]
    struct TotalsAndAllowed {
        #[serde(flatten)]
        totals: Totals,
        /// How many of the broken ones have no fault but those that are allowed.
        #[serde(skip_serializing_if = "Option::is_none")]
        allowed: Option<usize>,
    }
    #[derive(Serialize)]
    #[serde(untagged)]
    enum Entry<'a> {
        Checked {
            #[serde(flatten)]
            report: CheckReport<'a>,
            findings: Vec<JudgedFinding>,
            config: &'a Option<ConfigReport>,
        },
        Failed {
            map: &'a str,
            error: String,
        },
    }
    let maps = checks.iter().map(|one| match &one.map {
        (map, Ok(check)) => Entry::Checked {
            report: CheckReport::new(map.clone(), check),
            findings: one.judged(check),
            config: &one.config,
        },
        (map, Err(error)) => Entry::Failed { map, error: error.to_string() },
    });
    let allowed = Some(checks.iter().filter(|one| one.is_allowed()).count()).filter(|&allowed| allowed > 0);
    let totals = TotalsAndAllowed { totals: Totals::of(checks.iter().map(|one| &one.map)), allowed };
    to_json("check", &Json { maps: maps.collect(), totals })
}
