//! What the integration tests and benchmarks share.
#![allow(dead_code)] // Every test uses a part of it.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Mutex;

use serde_json::Value;

/// A lookup of which two faces read one image.
pub const SHARED_IMAGE_LOOKUP: &str = "v_origin = \"bottom\"\nposx = { u = \"-y\", v = \"+z\" }\n\
    negx = { u = \"+y\", v = \"+z\", image = \"posx\" }\nposy = { u = \"+x\", v = \"+z\" }\nnegy = { u = \"-x\", v = \"+z\" }\n\
    posz = { u = \"+x\", v = \"-y\" }\nnegz = { u = \"+x\", v = \"+y\" }\n";

/// A file or folder of the project.
pub fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// What the program does with these arguments in a folder, whatever the language of the system.
pub fn skycube(folder: &Path, arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_skycube"));
    program.env("LC_ALL", "C").args(arguments).current_dir(folder).output().unwrap()
}

/// The same as exit code, standard output and standard error.
pub fn outcome(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = skycube(folder, arguments);
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

/// What the program wrote.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// True to try whole tables, which takes minutes: `SKYCUBE_THOROUGH=1 cargo test --profile thorough`.
pub fn thorough() -> bool {
    std::env::var_os("SKYCUBE_THOROUGH").is_some()
}

/// A file or folder among the real environment maps, which are not part of this repository. They are looked for in the
/// folder that `SKYCUBE_SHARED_MAPS` names, or in `../shared/envmaps` beside the repository. Where it is missing, says
/// that the test skips it and gives `None`: a map of the project then has the same kind of fault.
pub fn shared_map(name: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("SKYCUBE_SHARED_MAPS").map_or_else(|| project("../shared/envmaps"), PathBuf::from);
    present(&folder, name)
}

/// The path in a folder that is not part of this repository; `None`, and a line that says so, where it is missing.
pub fn present(folder: &Path, name: &str) -> Option<PathBuf> {
    let path = folder.join(name);
    if path.exists() {
        return Some(path);
    }
    say_skipped(if folder.exists() { &path } else { folder });
    None
}

/// A report for programs, valid by the schema of its command. Every key must be in the schema, although the schema itself
/// leaves room for new ones.
pub fn json_report(report: &str) -> Value {
    let report: Value = serde_json::from_str(report).unwrap();
    let command = report["command"].as_str().expect("a report names its command");
    let schema = std::fs::read_to_string(project("src/report/schemas").join(command).with_extension("json")).unwrap();
    let schema: Value = serde_json::from_str(&schema).unwrap();
    let faults = faults(&report, &schema, &schema, "");
    assert!(faults.is_empty(), "{command}: {faults:?}");
    report
}

/// Where a value breaks a schema: what the schemas of this project need of JSON Schema, and an unlisted key is a fault, too.
fn faults(value: &Value, schema: &Value, root: &Value, place: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut complain = |what: String| found.push(format!("{place}: {what}"));
    let list = |schema: &Value| schema.as_array().cloned().unwrap_or_default();
    let is_open = schema["additionalProperties"] == true;
    let mut below = Vec::new();
    for (keyword, operand) in schema.as_object().expect("a schema is an object") {
        let limit = operand.as_f64().unwrap_or_default();
        let length = value.as_array().map_or(0, Vec::len) as f64;
        match keyword.as_str() {
            "$ref" => {
                let target = root.pointer(operand.as_str().unwrap().trim_start_matches('#')).expect("the $ref exists");
                below.extend(faults(value, target, root, place));
            }
            "anyOf" => {
                let branches = list(operand).into_iter().map(|branch| faults(value, &branch, root, place));
                let nearest = branches.min_by_key(|faults| (faults.len(), faults.concat().len()));
                below.extend(nearest.unwrap_or_default());
            }
            "type" if !is_of_type(value, operand.as_str().unwrap()) => complain(format!("{value} is no {operand}")),
            "const" if value != operand => complain(format!("{value} is not {operand}")),
            "enum" if !list(operand).contains(value) => complain(format!("{value} is none of {operand}")),
            "minItems" if length < limit => complain(format!("{length} entries")),
            "maxItems" if length > limit => complain(format!("{length} entries")),
            "minimum" if value.as_f64().is_some_and(|number| number < limit) => {
                complain(format!("{value} is too small"))
            }
            "maximum" if value.as_f64().is_some_and(|number| number > limit) => {
                complain(format!("{value} is too large"))
            }
            "items" => {
                for (index, entry) in value.as_array().into_iter().flatten().enumerate() {
                    below.extend(faults(entry, operand, root, &format!("{place}/{index}")));
                }
            }
            "required" => {
                let missing = list(operand).into_iter().filter(|key| value.get(key.as_str().unwrap()).is_none());
                missing.for_each(|key| complain(format!("{key} is missing")));
            }
            "properties" => {
                for (key, entry) in value.as_object().into_iter().flatten() {
                    match operand.get(key) {
                        Some(schema) => below.extend(faults(entry, schema, root, &format!("{place}/{key}"))),
                        None if is_open => {}
                        None => complain(format!("{key} is not in the schema")),
                    }
                }
            }
            "type" | "const" | "enum" | "minItems" | "maxItems" | "minimum" | "maximum" => {}
            "$schema" | "$defs" | "title" | "description" | "additionalProperties" => {}
            unknown => panic!("the tests do not know the keyword {unknown}"),
        }
    }
    found.extend(below);
    found
}

fn is_of_type(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "null" => value.is_null(),
        unknown => panic!("the tests do not know the type {unknown}"),
    }
}

/// Says once for each test what it skips: to the terminal itself, since `cargo test` shows nothing that a passing test prints.
fn say_skipped(missing: &Path) {
    static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let test = std::thread::current().name().unwrap_or("a test").to_owned();
    let line = format!("skipped in {test}: {} is missing\n", missing.display());
    if SAID.lock().unwrap().insert(line.clone()) {
        std::io::stderr().write_all(line.as_bytes()).unwrap();
    }
}
