//! What a shell needs: `-` for standard input and output, completions, manual pages.

mod common;

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use common::{outcome, project, skycube, text};
use skycube::envmap::Face;
use skycube::picture::{Raster, WriteOptions, encode, read};

/// The program with something on its standard input.
fn fed(folder: &Path, arguments: &[&str], input: &[u8]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_skycube"));
    program.env("LC_ALL", "C").args(arguments).current_dir(folder).stdin(Stdio::piped());
    let mut running = program.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut stdin = running.stdin.take().unwrap();
    std::thread::scope(|scope| {
        // A command that fails early does not read.
        scope.spawn(move || drop(stdin.write_all(input)));
        running.wait_with_output().unwrap()
    })
}

const SCENE: &str = "[camera]\nposition = [0, -4, 1]\ntarget = [0, 0, 0]\nfield_of_view = 40\nsize = [24, 16]\nsamples = 2\n\
    [environment]\nkind = \"gradient\"\nzenith = [0.2, 0.4, 1.0]\nhorizon = [0.9, 0.5, 0.2]\n";

#[test]
fn a_scene_comes_in_and_a_picture_goes_out() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    for format in ["png", "jpg", "hdr", "exr"] {
        let named = format!("named.{format}");
        let (code, _, error) = outcome(folder.path(), &["render", "scene.toml", "-o", &named]);
        assert_eq!(code, Some(0), "{error}");
        let output = fed(folder.path(), &["render", "-", "-o", "-", "--format", format], SCENE.as_bytes());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert!(output.stdout == std::fs::read(folder.path().join(named)).unwrap(), "{format}");
        assert!(text(&output.stderr).contains("samples"), "the report goes to standard error");
    }
    let files = std::fs::read_dir(folder.path()).unwrap().count();
    let (code, _, error) = outcome(folder.path(), &["render", "scene.toml", "-o", "new.png", "--format", "exr"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("new.png: --format exr contradicts the name"), "{error}");
    let broken = fed(folder.path(), &["render", "-"], b"[camera]\nsise = 3\n");
    assert_eq!(broken.status.code(), Some(2));
    assert!(text(&broken.stderr).contains("-:1: camera: "), "{}", text(&broken.stderr));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), files);
}

#[test]
fn a_baked_map_goes_through_a_pipe() {
    let folder = tempfile::tempdir().unwrap();
    let scene = project("lessons/06-environment-map/environment-with.toml").display().to_string();
    let bake = ["bake", &scene, "--samples", "1", "--face-size", "64", "--position", "0,0,3", "--lookup", "humus-z-up"];
    let (code, _, error) = outcome(folder.path(), &[&bake[..], &["-o", "baked"]].concat());
    assert_eq!(code, Some(0), "{error}");
    let baked = skycube(folder.path(), &[&bake[..], &["-o", "-"]].concat());
    assert_eq!(baked.status.code(), Some(0), "{}", text(&baked.stderr));
    assert!(text(&baked.stderr).contains("six images of 64 x 64 texels"));
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(&baked.stdout)).unwrap();
    for face in Face::ALL {
        let mut bytes = Vec::new();
        std::io::copy(&mut archive.by_name(&format!("{}.png", face.name())).unwrap(), &mut bytes).unwrap();
        assert!(bytes == std::fs::read(folder.path().join(format!("baked/{}.png", face.name()))).unwrap());
    }
    let [piped, named] = [
        fed(folder.path(), &["check", "-", "--lookup", "humus-z-up", "--json"], &baked.stdout),
        skycube(folder.path(), &["check", "baked", "--lookup", "humus-z-up", "--json"]),
    ];
    assert_eq!(piped.status.code(), named.status.code(), "{}", text(&piped.stderr));
    let verdict =
        |output: &Output| text(&output.stdout).lines().find(|line| line.contains("\"verdict\"")).map(str::to_owned);
    assert!(verdict(&piped).is_some());
    assert_eq!(verdict(&piped), verdict(&named));
}

/// A strip of six faces, +X -X +Y -Y +Z -Z.
fn strip() -> Vec<u8> {
    let faces = Face::ALL.map(|face| read(&project("envmaps/hall").join(format!("{}.png", face.name()))).unwrap());
    let side = faces[0].width();
    let strip = Raster::from_function(6 * side, side, |x, y| faces[x / side].texel(x % side, y));
    encode(&strip, skycube::picture::OutputFormat::Png, &WriteOptions::default()).unwrap()
}

#[test]
fn a_map_on_standard_input_is_read_by_every_command_that_takes_one() {
    let folder = tempfile::tempdir().unwrap();
    let strip = strip();
    let check = fed(folder.path(), &["check", "-"], &strip);
    assert_eq!(check.status.code(), Some(0), "{}{}", text(&check.stdout), text(&check.stderr));
    let cross = fed(folder.path(), &["cross", "-", "--cell", "64", "-o", "-"], &strip);
    assert_eq!(cross.status.code(), Some(0), "{}", text(&cross.stderr));
    assert!(cross.stdout.starts_with(b"\x89PNG") && text(&cross.stderr).contains("wrote -: "));
    let hall = skycube(&project("envmaps/hall"), &["cross", ".", "--cell", "64", "-o", "-"]);
    assert!(hall.stdout.starts_with(b"\x89PNG"), "{}", text(&hall.stderr));
    let probe = fed(folder.path(), &["probe", "-", "--direction", "1,2,3"], &strip);
    assert_eq!(probe.status.code(), Some(0), "{}", text(&probe.stderr));
    let fix = fed(folder.path(), &["fix", "-", "-o", "fixed"], &strip);
    assert_eq!(fix.status.code(), Some(0), "{}", text(&fix.stderr));
    assert_eq!(std::fs::read_dir(folder.path().join("fixed")).unwrap().count(), 6);
}

#[test]
fn what_cannot_be_read_from_standard_input_is_named() {
    let folder = tempfile::tempdir().unwrap();
    for (input, problem) in [(&b""[..], "standard input is empty"), (b"hello, world", "-: ")] {
        let output = fed(folder.path(), &["check", "-"], input);
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(problem), "{}", text(&output.stderr));
    }
    let picture = fed(folder.path(), &["render", "-"], b"\xff\xd8\xff");
    assert!(text(&picture.stderr).contains("-: this is not a text file"), "{}", text(&picture.stderr));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn pictures_are_compared_through_pipes() {
    let folder = tempfile::tempdir().unwrap();
    let expected = project("envmaps/hall/posx.png");
    let name = expected.display().to_string();
    let mine = std::fs::read(&expected).unwrap();
    let same = fed(folder.path(), &["compare", "-", &name], &mine);
    assert_eq!(same.status.code(), Some(0), "{}", text(&same.stderr));
    let drawn = fed(folder.path(), &["compare", "-", &name, "-o", "-"], &mine);
    assert!(drawn.stdout.starts_with(b"\x89PNG") && !drawn.stderr.is_empty());
}

#[test]
fn completions_know_commands_and_options() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let (code, script, error) = outcome(folder.path(), &["completions", shell]);
        assert_eq!(code, Some(0), "{error}");
        for word in ["check", "lessons", "engine"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
        assert!(!script.contains('\u{fffd}'), "{shell}");
    }
    // Bash itself completes.
    let script = outcome(folder.path(), &["completions", "bash"]).1;
    let test = format!(
        "{script}\nCOMP_WORDS=(skycube che); COMP_CWORD=1; _skycube skycube che skycube; echo ${{COMPREPLY[@]}}"
    );
    if let Ok(output) = Command::new("bash").args(["-c", &test]).output() {
        assert_eq!(text(&output.stdout), "check\n", "{}", text(&output.stderr));
    }
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = tempfile::tempdir().unwrap();
    let (code, report, error) = outcome(folder.path(), &["man", "man1"]);
    assert_eq!(code, Some(0), "{error}");
    let page = |name: &str| std::fs::read_to_string(folder.path().join("man1").join(name)).unwrap();
    assert!(report.contains("skycube-lessons-start.1"), "{report}");
    assert!(page("skycube.1").starts_with(".ie"), "roff");
    let check = page("skycube-check.1");
    assert!(check.contains("Examples") && check.contains("skycube check Meadow.zip"), "{check}");
    assert!(!check.contains('\u{1b}'), "without colours");
}
