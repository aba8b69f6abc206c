//! The three forms of a list that has one of everything.

use std::path::PathBuf;

use super::{Examined, ReportFormat, ReportedFinding, listed};
use crate::error::Error;
use crate::validate::Level;

fn finding(kind: &'static str, level: Level, sentence: &str, file: &str, allowed: bool) -> ReportedFinding {
    ReportedFinding {
        kind,
        meaning: Some("a meaning"),
        level,
        sentence: sentence.to_owned(),
        file: PathBuf::from(file),
        allowed,
    }
}

fn examined() -> Vec<Examined> {
    let broken = vec![
        finding("edited", Level::Error, "posy.jpg: turn 90° clockwise", "./skies/a b/posy.jpg", false),
        finding("exposure", Level::Note, "posx.jpg is brighter than all its neighbours", "skies/a b/posx.jpg", false),
        finding("outlier", Level::Error, "negx.jpg does not belong here", "skies/a b/negx.jpg", true),
    ];
    let doubtful = vec![finding("undecidable", Level::Warning, "the pixels cannot decide\n100 %", "night.zip", false)];
    let error = Error::new("the file is cut off after <3 bytes & \"more\"").in_file("c/posx.jpg").of_damage();
    vec![
        Examined { name: "skies/a b".to_owned(), verdict: "broken", findings: broken },
        Examined { name: "night.zip".to_owned(), verdict: "undecidable", findings: doubtful },
        Examined { name: "right".to_owned(), verdict: "fits", findings: Vec::new() },
        Examined::failed("c".to_owned(), &error),
    ]
}

#[test]
fn annotations_have_one_line_each() {
    insta::assert_snapshot!(listed(ReportFormat::Github, "check", &examined()), @r#"
    ::error file=skies/a b/posy.jpg,title=skies/a b%3A broken::posy.jpg: turn 90° clockwise
    ::warning file=night.zip,title=night.zip%3A undecidable::the pixels cannot decide%0A100 %25
    ::error file=c/posx.jpg,title=c%3A failed::c/posx.jpg: the file is cut off after <3 bytes & "more"
    "#);
}

#[test]
fn junit_has_a_case_for_everything_that_was_examined() {
    insta::assert_snapshot!(listed(ReportFormat::Junit, "check", &examined()), @r#"
    <?xml version="1.0" encoding="UTF-8"?>
    <testsuites name="skycube" tests="4" failures="1" errors="1">
      <testsuite name="skycube check" tests="4" failures="1" errors="1">
        <testcase classname="skycube.check" name="skies/a b">
          <failure type="edited" message="broken: posy.jpg: turn 90° clockwise">posy.jpg: turn 90° clockwise</failure>
        </testcase>
        <testcase classname="skycube.check" name="night.zip"/>
        <testcase classname="skycube.check" name="right"/>
        <testcase classname="skycube.check" name="c">
          <error type="damaged" message="failed: c/posx.jpg: the file is cut off after &lt;3 bytes &amp; &quot;more&quot;">c/posx.jpg: the file is cut off after &lt;3 bytes &amp; &quot;more&quot;</error>
        </testcase>
      </testsuite>
    </testsuites>
    "#);
}

#[test]
fn sarif_has_a_rule_for_each_kind_and_suppresses_what_is_allowed() {
    let log: serde_json::Value = serde_json::from_str(&listed(ReportFormat::Sarif, "check", &examined())).unwrap();
    let run = &log["runs"][0];
    let texts = |key: &str, name: &str| -> Vec<String> {
        let values = if key == "rules" { &run["tool"]["driver"]["rules"] } else { &run["results"] };
        values.as_array().unwrap().iter().map(|value| value[name].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(texts("rules", "id"), ["check/damaged", "check/edited", "check/outlier", "check/undecidable"]);
    assert_eq!(texts("results", "ruleId"), ["check/edited", "check/outlier", "check/undecidable", "check/damaged"]);
    assert_eq!(texts("results", "level"), ["error", "error", "warning", "error"]);
    let uri = &run["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
    assert_eq!(uri, "skies/a%20b/posy.jpg");
    assert!(run["results"][0].get("suppressions").is_none() && run["results"][1]["suppressions"].is_array());
    assert_eq!(run["invocations"][0]["executionSuccessful"], false);
}
