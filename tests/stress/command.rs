//! The command, and the warnings of `skycube render`.

use crate::common::{json_report, skycube, text};

#[test]
fn one_case_is_told_step_by_step() {
    let folder = tempfile::tempdir().unwrap();
    let output = skycube(folder.path(), &["stress", "--case", "nested", "--rays", "1000"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let report = text(&output.stdout);
    assert!(report.contains("nested: error of rays through a wrong glass"), "{report}");
    assert!(report.contains("beyond the bound, and not promised") && output.stderr.is_empty(), "{report}");
}

#[test]
fn the_report_for_machines_is_json() {
    let folder = tempfile::tempdir().unwrap();
    let output = skycube(folder.path(), &["stress", "--case", "mirrors", "--rays", "1000", "--json"]);
    let report = json_report(&text(&output.stdout));
    let case = &report["cases"][0];
    assert_eq!((case["name"].as_str(), case["group"].as_str()), (Some("mirrors"), Some("optics")));
    assert_eq!(case["sweep"].as_array().map(Vec::len), Some(13));
}

#[test]
fn the_validator_is_swept_until_it_is_undecided() {
    let folder = tempfile::tempdir().unwrap();
    let output = skycube(folder.path(), &["stress", "--case", "check-frame", "--rays", "1000", "--json"]);
    let report = json_report(&text(&output.stdout));
    let case = &report["cases"][0];
    assert_eq!((output.status.code(), case["group"].as_str()), (Some(0), Some("validator")));
    let sweep = case["sweep"].as_array().unwrap();
    assert_eq!((sweep[0]["error"].as_f64(), sweep[0]["input"].as_str()), (Some(0.0), Some("none")));
    let last = sweep.last().unwrap();
    assert_eq!(last["error"].as_f64(), Some(100.0));
    assert!(last["input"].as_str().unwrap().contains(": undecidable"), "{last}");
}

#[test]
fn an_unknown_case_cannot_run() {
    let folder = tempfile::tempdir().unwrap();
    let output = skycube(folder.path(), &["stress", "--case", "weather"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).starts_with("error: there is no case \"weather\""));
}

#[test]
fn rendering_warns_of_what_lies_outside_and_of_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let scene = |radius: &str, place: &str| {
        format!(
            "[camera]\nposition = [0, -5, 1]\ntarget = [0, 0, 0]\nsize = [4, 4]\n[materials.grey]\nkind = \"lambert\"\ncolour = 0.5\n\
             [[shapes]]\nkind = \"sphere\"\ncentre = {place}\nradius = {radius}\nmaterial = \"grey\"\n"
        )
    };
    let warnings = |radius: &str, place: &str| {
        std::fs::write(folder.path().join("scene.toml"), scene(radius, place)).unwrap();
        let output = skycube(folder.path(), &["render", "scene.toml"]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stderr)
    };
    assert_eq!(warnings("1e6", "[0, 0, -1e6]"), "");
    let warning = warnings("1e8", "[0, 0, -1e8]");
    assert!(warning.starts_with("warning: shape 1 (sphere): the radius is 1.000e8, above 1e6"), "{warning}");
    assert_eq!(warning.lines().count(), 1, "{warning}");
    assert!(warnings("1e-7", "[0, 0, 0]").contains("the radius is 1.000e-7, below 1e-6"));
    assert!(warnings("100", "[0, 0, 3e7]").contains("the coordinate is 3.000e7, above 1e7"));
    assert!(warnings("1e-3", "[0, 0, 1e5]").contains("the coordinate over the size is"));
}
