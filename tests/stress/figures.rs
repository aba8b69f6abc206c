//! The figures of a fast run.

use std::sync::OnceLock;

use skycube::limits::LIMITS;
use skycube::report::{Look, StressReport};
use skycube::stress::{Case, Effort, Verdict, subjects};
use skycube::validator_limits;

const FAST: Effort = Effort { rays: 20_000 };

/// All cases, measured once for all tests.
fn cases() -> &'static [Case] {
    static CASES: OnceLock<Vec<Case>> = OnceLock::new();
    CASES.get_or_init(|| subjects().into_iter().map(|subject| subject.measured(FAST)).collect())
}

#[test]
fn every_promise_is_kept() {
    for case in cases() {
        assert!(case.verdict() != Verdict::Fails, "{}: {:?}", case.subject.name, case.worst());
    }
}

#[test]
fn the_validator_is_never_wrong() {
    for subject in validator_limits::SUBJECTS {
        let case = subject.measured(Effort { rays: 20_000 });
        let wrong: Vec<_> = case.measurements.iter().filter(|step| step.error.is_infinite()).collect();
        assert!(wrong.is_empty() && case.verdict() != Verdict::Fails, "{}: {wrong:#?}", case.subject.name);
    }
}

#[test]
fn the_figures_are_the_same_everywhere() {
    insta::assert_snapshot!(StressReport { cases: cases(), effort: FAST, steps: false });
}

#[test]
fn a_line_fits_a_terminal() {
    let report = StressReport { cases: cases(), effort: FAST, steps: false };
    for columns in [60, 80, 120] {
        let shown = report.page().shown(Look { width: Some(columns), colour: false });
        let longest = shown.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(longest <= columns, "{longest} columns of {columns}:\n{shown}");
        // What matters most is left: the name of a case and its verdict.
        let line = shown.lines().find(|line| line.starts_with("  directions ")).unwrap();
        assert!(line.ends_with(" holds"), "{shown}");
        assert_eq!(shown.contains("… a wider terminal shows more columns"), columns < 120);
    }
}

#[test]
fn a_case_is_measured_again_as_it_was() {
    let again = |name: &str| subjects().into_iter().find(|subject| subject.name == name).unwrap().measured(FAST);
    for name in ["sphere-f64", "self-sphere", "film"] {
        let first = cases().iter().find(|case| case.subject.name == name).unwrap();
        assert_eq!(first.measurements, again(name).measurements);
    }
}

#[test]
fn every_limit_is_measured_from_end_to_end() {
    for limit in LIMITS {
        let case = cases().iter().find(|case| case.subject.name == limit.case);
        let case = case.unwrap_or_else(|| panic!("no case {}", limit.case));
        let promised = case.subject.promised;
        // A limit from zero has no end below.
        let least = if limit.range.least == 0.0 { promised.least } else { limit.range.least };
        // Nor has one without end above.
        let most = if limit.range.most.is_finite() { limit.range.most } else { promised.most };
        assert!(promised.least <= least && promised.most >= most, "{}", limit.figure);
        let measured =
            |magnitude: f64| case.measurements.iter().any(|step| (step.magnitude / magnitude - 1.0).abs() < 1e-9);
        assert!(measured(least) && measured(most), "{}: an end is not measured", limit.figure);
    }
}

#[test]
fn names_are_words_of_their_own() {
    let names: Vec<&str> = subjects().iter().map(|subject| subject.name).collect();
    for (place, name) in names.iter().enumerate() {
        assert!(!names[..place].contains(name), "{name} twice");
        assert!(name.chars().all(|letter| letter.is_ascii_lowercase() || letter == '-' || letter.is_ascii_digit()));
    }
}

#[test]
fn the_page_shows_these_figures() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/stress.md")).unwrap();
    let report = StressReport { cases: cases(), effort: FAST, steps: false }.to_string();
    for line in report.lines() {
        assert!(page.contains(line), "lessons/stress.md lacks: {line}");
    }
}
