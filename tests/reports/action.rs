//! The GitHub action: its commands, run as GitHub runs them.

use std::process::Command;

use skycube::envmap::Face;

use crate::common::{project, text};
use crate::compass;

const ACTION: &str = ".github/actions/check";

/// The command of the step with this name in `action.yml`, a line.
fn command_of(step: &str) -> String {
    let action = std::fs::read_to_string(project(ACTION).join("action.yml")).unwrap();
    let (_, after) = action.split_once(&format!("- name: {step}\n")).unwrap();
    let line = after.lines().find_map(|line| line.trim().strip_prefix("run: ")).unwrap();
    line.to_owned()
}

#[test]
#[cfg(unix)]
fn the_action_annotates_and_writes_sarif() {
    let folder = tempfile::tempdir().unwrap();
    compass(&folder.path().join("my skies/right"), None);
    compass(&folder.path().join("my skies/turned"), Some(Face::PosY));
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_skycube")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
    let run = |step: &str, maps: &str, options: &str| {
        Command::new("bash")
            .args(["--noprofile", "--norc", "-e", "-o", "pipefail", "-c", &command_of(step)])
            .current_dir(folder.path())
            .env("PATH", &path)
            .env("GITHUB_ACTION_PATH", project(ACTION))
            .env("MAPS", maps)
            .env("OPTIONS", options)
            .env("SARIF", "skies.sarif")
            .output()
            .unwrap()
    };
    let installed = run("Install skycube", "", "");
    assert!(installed.status.success() && text(&installed.stdout).contains("skycube"), "{}", text(&installed.stderr));
    let checked = run("Check", "my skies/right\nmy skies/turned\n", "--strict --lookup opengl");
    let annotations = text(&checked.stdout);
    assert_eq!(checked.status.code(), Some(1), "{annotations}{}", text(&checked.stderr));
    assert!(annotations.starts_with("::error file=my skies/turned/posy.png,title=my skies/turned%3A broken::posy.png"));
    let log = std::fs::read_to_string(folder.path().join("skies.sarif")).unwrap();
    let log: serde_json::Value = serde_json::from_str(&log).unwrap();
    assert_eq!(log["runs"][0]["results"].as_array().unwrap().len(), 1);
    let right = run("Check", "my skies/right", "");
    assert_eq!((right.status.code(), text(&right.stdout)), (Some(0), String::new()));
}
