//! The form of all reports for programs; `lessons/json.md` describes their keys.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::error::Error;

/// The version of the keys. It goes up when one is renamed, removed or changes its meaning.
const VERSION: u32 = 1;

/// A report as JSON: version and command first, then its own keys.
pub(super) fn to_json(command: &str, report: &impl Serialize) -> String {
    #[derive(Serialize)]
    struct Envelope<'a, T> {
        version: u32,
        command: &'a str,
        #[serde(flatten)]
        report: &'a T,
    }
    serde_json::to_string_pretty(&Envelope { version: VERSION, command, report }).expect("a report is plain data")
}

/// What is reported if the command could not run.
pub(crate) fn failure_json(command: &str, error: &Error) -> String {
    to_json(command, &BTreeMap::from([("error", error.to_string())]))
}
