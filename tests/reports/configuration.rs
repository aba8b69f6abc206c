//! `skycube.toml`: found above the map, weaker than the command line, strict about its keys.

use std::path::Path;

use skycube::envmap::Face;

use crate::common::{json_report, outcome};
use crate::compass;

/// A folder with a right map and a turned one under `skies`, and a configuration above them.
fn configured(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    compass(&folder.path().join("skies/right"), None);
    compass(&folder.path().join("skies/turned"), Some(Face::PosY));
    std::fs::write(folder.path().join("skycube.toml"), text).unwrap();
    folder
}

fn check(folder: &Path, more: &[&str]) -> (Option<i32>, serde_json::Value) {
    let (code, text, _) = outcome(folder, &[&["check"], more, &["--json"]].concat());
    (code, json_report(&text))
}

#[test]
fn it_sets_the_lookup_unless_the_command_line_does() {
    let folder = configured("lookup = \"humus-y-up\"\nworld_up = \"+y\"\n");
    let (code, report) = check(folder.path(), &["skies/right"]);
    let map = &report["maps"][0];
    assert_eq!((code, &map["lookup"], &map["config"]["lookup"]), (Some(0), &"humus-y-up".into(), &"humus-y-up".into()));
    let (_, report) = check(folder.path(), &["skies/right", "--lookup", "opengl"]);
    assert_eq!(report["maps"][0]["lookup"], "opengl");
    let (_, report) = check(folder.path(), &["skies/right", "--no-config"]);
    let map = &report["maps"][0];
    assert_eq!((&map["lookup"], &map["config"]), (&"opengl".into(), &serde_json::Value::Null));
    // The nearest file counts, from wherever the command runs.
    std::fs::write(folder.path().join("skies/skycube.toml"), "lookup = \"opengl\"\n").unwrap();
    let (_, report) = check(&folder.path().join("skies/right"), &["."]);
    assert_eq!(report["maps"][0]["lookup"], "opengl");
    let (_, text, _) = outcome(folder.path(), &["check", "skies/right"]);
    assert!(text.ends_with("skies/skycube.toml: lookup opengl\n"), "{text}");
}

#[test]
fn it_allows_findings_by_path() {
    let folder = configured("[[allow]]\nmaps = \"skies/tur*\"\nfindings = [\"edited\"]\n");
    let (code, report) = check(folder.path(), &["skies"]);
    let findings = &report["maps"][1]["findings"];
    assert_eq!(
        (code, &report["maps"][1]["verdict"], &findings[0]["allowed"]),
        (Some(0), &"broken".into(), &true.into())
    );
    assert_eq!((&report["totals"]["broken"], &report["totals"]["allowed"]), (&1.into(), &1.into()));
    let (code, text, _) = outcome(folder.path(), &["check", "skies", "--format", "github"]);
    assert_eq!((code, text.as_str()), (Some(0), ""));
    let (code, text, _) = outcome(folder.path(), &["check", "skies"]);
    assert!(code == Some(0) && text.contains("  skycube.toml: allows edited\n"), "{text}");
    for (maps, findings) in [("skies/rig*", "edited"), ("*", "edited"), ("**", "outlier")] {
        let folder = configured(&format!("[[allow]]\nmaps = \"{maps}\"\nfindings = [\"{findings}\"]\n"));
        assert_eq!(check(folder.path(), &["skies"]).0, Some(1), "{maps} {findings}");
    }
}

#[test]
fn what_it_does_not_know_is_an_error_with_its_line() {
    let cases = [
        ("\nlokup = \"opengl\"\n", 2, "unknown key"),
        ("lookup = \"open-gl\"\n", 1, "there is no lookup"),
        ("world_up = \"up\"\n", 1, "expected: an axis"),
        ("[[allow]]\nmaps = \"**\"\nfindings = [\"edits\"]\n", 3, "there is no finding"),
        ("[[allow]]\nmaps = \"[\"\nfindings = []\n", 2, "no pattern"),
        ("[[allow]]\nfindings = []\n", 1, "\"maps\" is missing"),
        ("lookup = \n", 1, "not valid TOML"),
    ];
    for (text, line, problem) in cases {
        let folder = configured(text);
        let (code, _, error) = outcome(folder.path(), &["check", "skies/right"]);
        assert_eq!(code, Some(2), "{text}");
        assert!(
            error.starts_with(&format!("error: skycube.toml:{line}: ")) && error.contains(problem),
            "{text}: {error}"
        );
    }
}

#[test]
fn a_table_is_found_beside_the_file_that_names_it() {
    let folder = configured("lookup = \"table.toml\"\n");
    let (code, table, _) = outcome(folder.path(), &["fix", "skies/right", "--code", "toml", "--no-config"]);
    assert_eq!(code, Some(0));
    std::fs::write(folder.path().join("table.toml"), table).unwrap();
    let (code, report) = check(&folder.path().join("skies"), &["right"]);
    assert_eq!(code, Some(0), "{report}");
    assert!(report["maps"][0]["lookup"].as_str().unwrap().ends_with("table.toml"));
}
