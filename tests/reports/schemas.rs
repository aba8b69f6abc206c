//! Every report is valid by the schema that `skycube schema` prints.

use std::path::Path;

use crate::common::{json_report, outcome, project};

const SCENE: &str = "lessons/04-whitted/glass-depth-10.toml";

fn report(arguments: &[&str]) -> serde_json::Value {
    let folder = tempfile::tempdir().unwrap();
    let (_, report, _) = outcome(folder.path(), arguments);
    json_report(&report)
}

#[test]
fn every_command_prints_its_schema_and_follows_it() {
    let (scene, compass) = (project(SCENE).display().to_string(), project("envmaps/compass").display().to_string());
    let environment = project("lessons/06-environment-map/glass-and-mirror.toml").display().to_string();
    let cases: [(&str, &[&str]); 10] = [
        ("check", &["check", &compass, "--lookup", "exercise", "--world-up", "+z", "--json"]),
        ("check", &["check", "missing", &compass, "--format", "json"]),
        ("probe", &["probe", &compass, "--direction", "1,1,1", "--filter", "seamless", "--json"]),
        ("probe", &["probe", &compass, "--lookup", "exercise", "--direction", "1,0,0", "--json"]),
        ("render", &["render", &scene, "--size", "8x5", "--samples", "1", "-o", "a.png", "--json"]),
        ("trace", &["trace", &scene, "--pixel", "100,100", "--json"]),
        ("trace", &["trace", &environment, "--pixel", "220,360", "--json"]),
        ("trace", &["trace", &scene, "--pixel", "100,100", "--integrator", "path", "--json"]),
        ("converge", &["converge", &scene, "--size", "8x5", "--samples", "1,2", "--reference-samples", "4", "--json"]),
        ("stress", &["stress", "--case", "directions", "--rays", "1000", "--json"]),
    ];
    for (command, arguments) in cases {
        assert_eq!(report(arguments)["command"], command, "{arguments:?}");
        let (code, schema, _) = outcome(Path::new("."), &["schema", command]);
        let stored =
            std::fs::read_to_string(project("src/report/schemas").join(command).with_extension("json")).unwrap();
        assert_eq!((code, schema == stored), (Some(0), true), "{command}");
    }
}

#[test]
fn a_command_that_cannot_run_says_so_in_its_report() {
    let cases: [&[&str]; 7] = [
        &["check", "x", "--lookup", "unheard-of", "--json"],
        &["compare", "x.png", "y.png", "--json"],
        &["converge", "x.toml", "--json"],
        &["grade", "x", "--map", "y", "--json"],
        &["probe", "x", "--direction", "1,0,0", "--json"],
        &["render", "x.toml", "--json"],
        &["trace", "x.toml", "--pixel", "1,1", "--json"],
    ];
    for arguments in cases {
        let report = report(arguments);
        let error = report["error"].as_str().unwrap_or_default();
        assert!(error.contains(arguments[1]) || error.contains("unheard-of"), "{arguments:?}: {report}");
    }
}

#[test]
fn every_kind_of_finding_is_documented() {
    let page = std::fs::read_to_string(project("lessons/json.md")).unwrap();
    for (kind, _) in skycube::validate::KINDS {
        assert!(page.contains(&format!("`{kind}`")), "{kind}");
    }
}

/// Without the keys that may be missing, a schema would say nothing about a misspelt one.
#[test]
#[should_panic(expected = "verdikt")]
fn a_key_that_the_schema_does_not_know_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let (_, report, _) = outcome(folder.path(), &["check", "missing", "--json"]);
    json_report(&report.replace("\"error\"", "\"verdikt\": 1, \"error\""));
}
