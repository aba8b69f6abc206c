//! SARIF 2.1.0, which code scanning reads.
//! <https://docs.oasis-open.org/sarif/sarif/v2.1.0/sarif-v2.1.0.html>

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Value, json};

use super::{Examined, ReportedFinding};
use crate::validate::Level;

const SCHEMA: &str = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// One run of a command: its rules are the kinds of findings, its results all faults. Those that the user allows are suppressed.
pub(super) fn log(command: &str, examined: &[Examined]) -> String {
    let reported = examined.iter().flat_map(|one| one.findings.iter().map(move |finding| (one, finding)));
    let reported: Vec<_> = reported.filter(|(_, finding)| finding.level != Level::Note).collect();
    let rules: BTreeMap<&str, Value> =
        reported.iter().map(|(_, finding)| (finding.kind, rule(command, finding))).collect();
    let results: Vec<Value> = reported.iter().map(|(one, finding)| result(command, one, finding)).collect();
    let failed = examined.iter().any(|one| one.verdict == "failed");
    let log = json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "skycube",
                "version": env!("CARGO_PKG_VERSION"),
                "rules": rules.into_values().collect::<Vec<_>>(),
            } },
            "invocations": [{ "executionSuccessful": !failed }],
            "results": results,
        }],
    });
    format!("{}\n", serde_json::to_string_pretty(&log).expect("a log is plain data"))
}

fn rule(command: &str, finding: &ReportedFinding) -> Value {
    let mut rule = json!({ "id": format!("{command}/{}", finding.kind) });
    if let Some(meaning) = finding.meaning {
        rule["shortDescription"] = json!({ "text": meaning });
    }
    rule
}

fn result(command: &str, one: &Examined, finding: &ReportedFinding) -> Value {
    let mut result = json!({
        "ruleId": format!("{command}/{}", finding.kind),
        "level": if finding.level == Level::Error { "error" } else { "warning" },
        "message": { "text": format!("{}: {}", one.name, one.said(&finding.sentence)) },
        "locations": [{ "physicalLocation": { "artifactLocation": { "uri": uri(&finding.path()) } } }],
    });
    if finding.allowed {
        result["suppressions"] = json!([{ "kind": "external", "justification": "allowed by skycube.toml" }]);
    }
    result
}

/// A path as a URI: relative to where the command ran, or with the scheme `file`.
fn uri(path: &str) -> String {
    let absolute = Path::new(path).is_absolute();
    let mut uri = String::new();
    for &byte in path.as_bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => uri.push(char::from(byte)),
            // That of a drive.
            b':' if absolute => uri.push(':'),
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    if absolute { format!("file:///{}", uri.trim_start_matches('/')) } else { uri }
}
