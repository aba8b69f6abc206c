//! SARIF, JUnit and annotations of whole commands, and the options that go with them.

use std::path::Path;
use std::process::Command;

use skycube::envmap::Face;

use crate::common::{json_report, outcome, project};
use crate::compass;

/// A folder with a map that fits, one with a turned face, and one that is cut off.
fn library() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    compass(&folder.path().join("skies/right"), None);
    compass(&folder.path().join("skies/turned"), Some(Face::PosY));
    compass(&folder.path().join("skies/cut off"), None);
    let cut = folder.path().join("skies/cut off/negx.png");
    let bytes = std::fs::read(&cut).unwrap();
    std::fs::write(cut, &bytes[..bytes.len() / 2]).unwrap();
    folder
}

#[test]
fn annotations_name_the_file_and_what_to_do() {
    let folder = library();
    let (code, text, _) = outcome(folder.path(), &["check", "skies", "--format", "github"]);
    assert_eq!(code, Some(1));
    let [damaged, turned] = text.lines().collect::<Vec<_>>()[..] else { panic!("{text}") };
    assert!(damaged.starts_with("::error file=skies/cut off/negx.png,title=skies/cut off%3A failed::"), "{damaged}");
    let expected =
        "::error file=skies/turned/posy.png,title=skies/turned%3A broken::posy.png: turn 90° counterclockwise";
    assert_eq!(turned, expected);
}

#[test]
fn junit_counts_maps_as_cases() {
    let folder = library();
    let (code, text, _) = outcome(folder.path(), &["check", "skies", "--format", "junit", "--exit-zero"]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("<testsuites name=\"skycube\" tests=\"3\" failures=\"1\" errors=\"1\">"), "{text}");
    assert!(
        text.contains("<failure type=\"edited\" message=\"broken: posy.png: turn 90° counterclockwise\">"),
        "{text}"
    );
    assert!(text.contains("<testcase classname=\"skycube.check\" name=\"skies/right\"/>"), "{text}");
}

#[test]
fn a_broken_option_still_gives_a_report() {
    let here = Path::new(".");
    let (code, text, _) = outcome(here, &["compare", "x.png", "y.png", "--format", "junit"]);
    assert!(code == Some(2) && text.contains("<error type=\"failed\""), "{text}");
    let (code, _, error) = outcome(here, &["check", "x", "--json", "--format", "sarif"]);
    assert!(code == Some(2) && error.contains("cannot be used with"), "{error}");
}

#[test]
fn quiet_prints_faults_only() {
    let folder = library();
    assert_eq!(outcome(folder.path(), &["check", "skies/right", "-q"]), (Some(0), String::new(), String::new()));
    let (code, text, _) = outcome(folder.path(), &["check", "skies", "--quiet"]);
    assert_eq!((code, text.lines().count()), (Some(1), 2), "{text}");
    assert!(text.lines().last().unwrap().starts_with("skies/turned: broken"), "{text}");
    let pictures = ["skies/right/posx.png", "skies/right/posx.png", "skies/right/negx.png"].map(|name| name.to_owned());
    let [one, same, other] = pictures.each_ref().map(String::as_str);
    assert_eq!(outcome(folder.path(), &["compare", one, same, "-q"]), (Some(0), String::new(), String::new()));
    let (code, text, _) = outcome(folder.path(), &["compare", one, other, "-q", "--exit-zero"]);
    assert!(code == Some(0) && text.lines().count() == 1 && text.starts_with(one), "{text}");
}

#[test]
fn compare_and_grade_list_their_findings() {
    let folder = library();
    let arguments = ["compare", "skies/right/posy.png", "skies/turned/posy.png", "--format", "github"];
    let (code, text, _) = outcome(folder.path(), &arguments);
    assert!(code == Some(1) && text.starts_with("::error file=skies/right/posy.png,title="), "{text}");
    assert!(text.lines().count() > 1, "{text}");
    let shots = ["shots", "skies/right", "-o", "shots", "--size", "64"];
    assert_eq!(outcome(folder.path(), &shots).0, Some(0));
    let grade =
        ["grade", "shots", "--map", "skies/right", "--lookup", "exercise", "--world-up", "+y", "--format", "sarif"];
    let (code, text, _) = outcome(folder.path(), &grade);
    let log: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((code, &log["runs"][0]["results"][0]["level"]), (Some(1), &"error".into()), "{text}");
}

/// `SKYCUBE_SARIF_SCHEMA` names the official schema, sarif-schema-2.1.0.json of docs.oasis-open.org; the validator is Python's
/// package `jsonschema`.
#[test]
fn sarif_is_valid_by_the_official_schema() {
    let Some(schema) = std::env::var_os("SKYCUBE_SARIF_SCHEMA") else {
        return println!("skipped: SKYCUBE_SARIF_SCHEMA names no file");
    };
    let folder = library();
    std::fs::write(folder.path().join("skycube.toml"), "[[allow]]\nmaps = \"**\"\nfindings = [\"edited\"]\n").unwrap();
    let one = project("envmaps/compass/posx.png").display().to_string();
    let cases: [&[&str]; 3] = [&["check", "skies"], &["compare", &one, "skies/right/negx.png"], &["check", "missing"]];
    for arguments in cases {
        let (_, text, _) = outcome(folder.path(), &[arguments, &["--format", "sarif"]].concat());
        let log = folder.path().join("log.sarif");
        std::fs::write(&log, &text).unwrap();
        let mut validator = Command::new("python3");
        let validated = validator.args(["-m", "jsonschema", "-i"]).arg(log).arg(&schema).output().unwrap();
        assert!(validated.status.success(), "{}\n{text}", crate::common::text(&validated.stderr));
    }
}

#[test]
fn json_lists_findings_with_images_and_files() {
    let folder = library();
    let (_, text, _) = outcome(folder.path(), &["check", "skies/turned", "--json"]);
    let finding = &json_report(&text)["maps"][0]["findings"][0];
    assert_eq!((&finding["kind"], &finding["level"]), (&"edited".into(), &"error".into()));
    assert_eq!((&finding["images"][0], &finding["files"][0]), (&"posy".into(), &"posy.png".into()));
}
