//! Lessons as a student meets them: listed, shown, copied, never overwritten.

mod common;

use std::process::Command;

use common::outcome as skycube;
use skycube::lessons::read_all;

const LESSON: &str = r#"
number = 3
title = { en = "Shadows", cs = "Stíny" }
goal = { en = "See shadows.", cs = "Vidět stíny." }
needs = { en = "Lesson 02.", cs = "Lekce 02." }
files = ["README.md", "maps/posx.txt"]
commands = ["skycube render a.toml"]
"#;

/// A folder with one lesson in `lessons`.
fn folder(lesson: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let own = folder.path().join("lessons/03-shadows");
    std::fs::create_dir_all(own.join("maps")).unwrap();
    std::fs::write(own.join("lesson.toml"), lesson).unwrap();
    std::fs::write(own.join("README.md"), "read me").unwrap();
    std::fs::write(own.join("maps/posx.txt"), "x").unwrap();
    folder
}

#[test]
fn lessons_are_listed_and_shown_in_both_languages() {
    let folder = folder(LESSON);
    let run = |more: &[&str]| skycube(folder.path(), &[&["lessons"], more, &["--folder", "lessons"]].concat());
    let (code, list, _) = run(&[]);
    assert_eq!(code, Some(0));
    assert!(list.starts_with("03  Shadows  needs: Lesson 02.\n"), "{list}");
    let (_, list, _) = run(&["--language", "cs"]);
    assert!(list.starts_with("03  Stíny  potřebuje: Lekce 02.\n"), "{list}");
    let (code, text, error) = run(&["--language", "cs", "start", "3", "-o", "first"]);
    assert_eq!(code, Some(0), "{error}");
    assert!(text.contains("přečtěte si") && !text.contains("už tam je"), "{text}");
    std::fs::remove_file(folder.path().join("first/README.md")).unwrap();
    let (_, text, _) = run(&["start", "3", "-o", "first"]);
    assert!(text.contains("wrote first/README.md\nalready there: first/maps/posx.txt\n"), "{text}");
    let (_, page, _) = run(&["03"]);
    assert!(page.contains("goal: See shadows.") && page.contains("    skycube render a.toml\n"), "{page}");
    let (code, _, error) = run(&["4"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("there is no lesson 4") && error.contains("one of 3"), "{error}");
}

#[test]
fn a_lesson_is_copied_once_and_nothing_is_overwritten() {
    let folder = folder(LESSON);
    let run =
        |more: &[&str]| skycube(folder.path(), &[&["lessons", "start", "3", "--folder", "lessons"], more].concat());
    let (code, text, error) = run(&["-o", "mine"]);
    assert_eq!(code, Some(0), "{error}");
    assert!(text.contains("skycube render a.toml"), "{text}");
    let copied = |name: &str| std::fs::read_to_string(folder.path().join("mine").join(name)).unwrap();
    assert_eq!((copied("README.md").as_str(), copied("maps/posx.txt").as_str()), ("read me", "x"));
    assert!(!folder.path().join("mine/lesson.toml").exists());
    // The student's own work stays, and nothing else is written beside it.
    std::fs::write(folder.path().join("mine/maps/posx.txt"), "my own").unwrap();
    std::fs::remove_file(folder.path().join("mine/README.md")).unwrap();
    let (code, _, error) = run(&["-o", "mine"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("posx.txt: this file exists already"), "{error}");
    assert_eq!(copied("maps/posx.txt"), "my own");
    assert!(!folder.path().join("mine/README.md").exists());
    let (code, ..) = run(&[]);
    assert_eq!(code, Some(0));
    assert!(folder.path().join("03-shadows/README.md").exists());
}

#[test]
fn what_is_wrong_with_a_lesson_is_named() {
    let cases = [
        (LESSON.replace("needs =", "need ="), "lesson.toml:5: unknown field `need`"),
        (LESSON.replace("cs = \"Stíny\"", "de = \"Schatten\""), "lesson.toml:3: unknown field `de`"),
        (LESSON.replace("README.md", "../secret"), "../secret lies outside the lesson"),
        (LESSON.replace("skycube render", "cargo run"), "command lines that begin with \"skycube \""),
        (LESSON.replace("number = 3", "number = -3"), "lesson.toml:2:"),
        (format!("{LESSON}[expected_samples]\nb = 256\n"), "there is no scene b.toml among the files"),
        (format!("{LESSON}[expected_samples]\na = 0\n"), "lesson.toml:9:"),
    ];
    for (text, expected) in cases {
        let folder = folder(&text);
        let (code, _, error) = skycube(folder.path(), &["lessons", "--folder", "lessons"]);
        assert_eq!(code, Some(2));
        assert!(error.contains(expected), "{expected}: {error}");
    }
    let empty = tempfile::tempdir().unwrap();
    let (code, _, error) = skycube(empty.path(), &["lessons", "--folder", "."]);
    assert_eq!(code, Some(2));
    assert!(error.contains("there are no lessons in this folder"), "{error}");
}

/// A copy of the program in an empty folder, where no repository can be found.
#[test]
fn the_lessons_of_the_course_travel_with_the_program() {
    let lessons = read_all(None).unwrap();
    assert_eq!(lessons.len(), 11);
    let folder = tempfile::tempdir().unwrap();
    for lesson in lessons {
        let (code, text, error) = skycube(folder.path(), &["lessons", "start", &lesson.number.to_string()]);
        assert_eq!(code, Some(0), "{error}");
        assert_eq!(text.matches("wrote ").count(), lesson.files.len());
        for file in &lesson.files {
            let copy = folder.path().join(lesson.name()).join(file);
            let original = common::project("lessons").join(lesson.name()).join(file);
            assert!(std::fs::read(copy).unwrap() == std::fs::read(&original).unwrap(), "{}", original.display());
        }
    }
    // Nothing in the program names the folder of the sources, so it is not read from there.
    let program = std::fs::read(env!("CARGO_BIN_EXE_skycube")).unwrap();
    let sources = common::project("lessons/01-camera-rays/README.md").display().to_string();
    assert!(!program.windows(sources.len()).any(|bytes| bytes == sources.as_bytes()), "{sources}");
}

#[test]
fn lessons_speak_the_language_of_the_system() {
    let list = |variables: &[(&str, &str)], more: &[&str]| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_skycube"));
        for variable in ["LC_ALL", "LC_MESSAGES", "LANG"] {
            program.env_remove(variable);
        }
        let output = program.args(["lessons"]).args(more).envs(variables.iter().copied()).output().unwrap();
        common::text(&output.stdout)
    };
    let is_czech = |text: String| text.contains("Mapa prostředí");
    assert!(is_czech(list(&[("LANG", "cs_CZ.UTF-8")], &[])));
    assert!(is_czech(list(&[("LC_ALL", "cs"), ("LANG", "en_GB.UTF-8")], &[])));
    assert!(is_czech(list(&[("LC_ALL", ""), ("LANG", "cs_CZ")], &[])));
    assert!(!is_czech(list(&[("LC_MESSAGES", "C"), ("LANG", "cs_CZ.UTF-8")], &[])));
    assert!(!is_czech(list(&[("LANG", "csb_PL.UTF-8")], &[])), "Kashubian");
    assert!(!is_czech(list(&[("LANG", "cs_CZ.UTF-8")], &["--language", "en"])));
    assert!(!is_czech(list(&[], &[])));
}
