//! `compare` on two folders.

use std::path::Path;

use skycube::math::Vec3;
use skycube::picture::{Raster, WriteOptions, write};

use crate::common::{json_report, outcome};

/// A picture of one tone with a darker square whose corner is at `x`.
fn picture(file: &Path, x: usize) {
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    let inside = |column: usize, row: usize| (x..x + 16).contains(&column) && (8..24).contains(&row);
    let tone = |column: usize, row: usize| {
        let shade = 0.5 + 0.3 * ((column * row) as f32 / 400.0).sin();
        Vec3::splat(if inside(column, row) { 0.02 } else { shade })
    };
    write(&Raster::from_function(48, 32, tone), file, &WriteOptions::default()).unwrap();
}

/// Mine and expected: one pair alike, one that differs, one without mine, one that is new.
fn folders() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, mine, expected) in
        [("alike", Some(4), Some(4)), ("deep/moved", Some(4), Some(28)), ("gone", None, Some(4))]
    {
        for (side, x) in [("mine", mine), ("expected", expected)] {
            if let Some(x) = x {
                picture(&folder.path().join(side).join(name).with_extension("png"), x);
            }
        }
    }
    picture(&folder.path().join("mine/<added>.png"), 4);
    folder
}

#[test]
fn pictures_are_paired_by_name() {
    let folder = folders();
    let (code, text, error) = outcome(folder.path(), &["compare", "mine", "expected", "-o", "page.html"]);
    assert_eq!((code, error.as_str()), (Some(1), ""));
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with("<added>     new: no picture"), "{text}");
    assert!(lines[1].starts_with("alike       identical: "), "{text}");
    assert!(lines[2].starts_with("deep/moved  differs: FLIP is "), "{text}");
    assert!(lines[3].starts_with("gone        missing: "), "{text}");
    assert_eq!(lines[4..], ["4 pairs: 1 identical, 1 different, 1 missing, 1 new", "wrote page.html"]);
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert_eq!(page.matches("<input type=\"range\"").count(), 1, "one pair is shown");
    assert_eq!(page.matches("data:image/png;base64,").count(), 3);
    assert!(!page.contains("http") && page.contains("&lt;added&gt;") && !page.contains("{pairs}"));
}

#[test]
fn the_report_has_all_pairs_and_a_single_one_its_keys_at_the_top() {
    let folder = folders();
    let (code, text, _) = outcome(folder.path(), &["compare", "mine", "expected", "--json"]);
    let report = json_report(&text);
    let verdicts: Vec<&str> =
        report["pairs"].as_array().unwrap().iter().map(|pair| pair["verdict"].as_str().unwrap()).collect();
    assert_eq!((code, verdicts), (Some(1), vec!["new", "identical", "differs", "missing"]));
    assert!(report.get("verdict").is_none() && report["totals"]["missing"] == 1);
    let (_, text, _) = outcome(folder.path(), &["compare", "mine/alike.png", "expected/deep/moved.png", "--json"]);
    let report = json_report(&text);
    assert_eq!((&report["verdict"], &report["pairs"][0]["verdict"]), (&"differs".into(), &"differs".into()));
    assert_eq!(report["findings"], report["pairs"][0]["findings"]);
}

#[test]
fn update_accepts_what_differs_and_what_is_new() {
    let folder = folders();
    let (code, text, error) = outcome(folder.path(), &["compare", "mine", "expected", "--update"]);
    assert!(code == Some(1) && text.contains("accepted expected/deep/moved.png\n"), "one is missing: {text}{error}");
    std::fs::remove_file(folder.path().join("expected/gone.png")).unwrap();
    let (code, text, _) = outcome(folder.path(), &["compare", "mine", "expected"]);
    assert_eq!((code, text.lines().last()), (Some(0), Some("3 pairs: 3 identical")));
    // A single picture, for which nothing is expected yet.
    let (code, _, _) = outcome(folder.path(), &["compare", "mine/alike.png", "first.png", "--update"]);
    assert_eq!(code, Some(0));
    assert_eq!(outcome(folder.path(), &["compare", "mine/alike.png", "first.png", "-q"]).0, Some(0));
}

#[test]
fn what_cannot_be_paired_is_an_error() {
    let folder = folders();
    std::fs::write(folder.path().join("mine/alike.exr"), "").unwrap();
    let (code, _, error) = outcome(folder.path(), &["compare", "mine", "expected"]);
    assert!(code == Some(2) && error.contains("has the same name"), "{error}");
    let cases: [(&[&str], &str); 3] = [
        (&["mine/alike.png", "expected"], "this is not a folder"),
        (&["expected", "expected", "-o", "page.png"], "a name with .html"),
        (&["expected", "empty"], "holds no picture"),
    ];
    std::fs::create_dir(folder.path().join("empty")).unwrap();
    for (arguments, problem) in cases {
        let (code, _, error) = outcome(folder.path(), &[&["compare"], arguments].concat());
        assert!(code == Some(2) && error.contains(problem), "{arguments:?}: {error}");
    }
}
