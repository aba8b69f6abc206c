//! The program as its user runs it: exit codes, messages, files.

mod common;

use std::path::Path;
use std::process::{Command, Output};

use common::{SHARED_IMAGE_LOOKUP, json_report, skycube, text};

const LESSON: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/06-environment-map/environment-with.toml");

/// The file names in a folder, sorted.
fn files(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn render_writes_a_picture_and_says_what_it_did() {
    let folder = tempfile::tempdir().unwrap();
    let output = skycube(folder.path(), &["render", LESSON, "--size", "48x30", "--samples", "1"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(files(folder.path()), ["environment-with.png"]);
    let report = text(&output.stdout);
    assert!(
        report.starts_with("wrote environment-with.png: 48 x 30 pixels, 1 sample each, whitted, side by side\n"),
        "{report}"
    );
    for part in ["time  ", "rays  ", "camera 1 440", "left out\n"] {
        assert!(report.contains(part), "{report}");
    }
    assert!(output.stderr.is_empty(), "no progress bar without a terminal");
}

#[test]
fn the_report_for_machines_is_json() {
    let folder = tempfile::tempdir().unwrap();
    let output =
        skycube(folder.path(), &["render", LESSON, "--size", "8x5", "--samples", "1", "-o", "a.exr", "--json"]);
    let report = json_report(&text(&output.stdout));
    assert_eq!((report["picture"].as_str(), report["rays"]["camera"].as_u64()), (Some("a.exr"), Some(40)));
}

#[test]
fn the_json_of_a_check_lists_maps_that_cannot_be_checked_too() {
    let folder = tempfile::tempdir().unwrap();
    let compass = concat!(env!("CARGO_MANIFEST_DIR"), "/envmaps/compass");
    for (maps, fits) in [(&["missing"][..], 0), (&[compass, "missing"], 1)] {
        let output = skycube(folder.path(), &[&["check", "--json"], maps].concat());
        assert_eq!(output.status.code(), Some(2));
        let report = json_report(&text(&output.stdout));
        assert_eq!((&report["version"], &report["command"]), (&1.into(), &"check".into()));
        let last = &report["maps"][maps.len() - 1];
        assert_eq!(last["map"], "missing");
        assert!(last["error"].as_str().unwrap().contains("does not exist"), "{last}");
        let totals = serde_json::json!({ "fits": fits, "broken": 0, "undecidable": 0, "failed": 1 });
        assert_eq!(report["totals"], totals);
    }
}

#[test]
fn all_output_formats_are_written() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.png", "a.jpg", "a.hdr", "a.exr"] {
        let output = skycube(folder.path(), &["render", LESSON, "--size", "8x5", "--samples", "1", "-o", name]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert_eq!(skycube::picture::read(&folder.path().join(name)).unwrap().width(), 8);
    }
}

#[test]
fn what_cannot_run_exits_with_2_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("broken.toml"), "[camera]\nposition = 1\n").unwrap();
    for (arguments, message) in [
        (vec!["render", "nowhere.toml"], "error: nowhere.toml: the file does not exist"),
        (vec!["render", "broken.toml"], "error: broken.toml:2: camera.position: found 1"),
        (vec!["render", LESSON, "-o", "picture.gif"], "error: picture.gif"),
        (vec!["render", LESSON, "-o", "no/such/folder.png"], "error: no/such"),
        (vec!["render", LESSON, "--size", "0x5"], "error: invalid value '0x5' for '--size <WxH>'"),
        (vec!["bake", LESSON, "-o", "faces", "--lookup", "opengle"], "error: there is no lookup \"opengle\""),
    ] {
        let output = skycube(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let complaint = text(&output.stderr);
        assert!(complaint.starts_with(message), "{complaint}");
    }
    assert_eq!(files(folder.path()), ["broken.toml"]);
}

#[test]
fn a_map_for_a_scene_that_shows_none_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let without = LESSON.replace("environment-with.toml", "environment-without.toml");
    let output = skycube(folder.path(), &["render", &without, "--environment", "nowhere.zip"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("no map to replace"), "{}", text(&output.stderr));
    assert_eq!(files(folder.path()), [""; 0]);
}

#[test]
fn two_faces_cannot_be_baked_into_one_image() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("double.toml"), SHARED_IMAGE_LOOKUP).unwrap();
    let output =
        skycube(folder.path(), &["bake", LESSON, "-o", "faces", "--lookup", "double.toml", "--face-size", "4"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("two faces of the lookup read posx"), "{}", text(&output.stderr));
    assert_eq!(files(folder.path()), ["double.toml"]);
}

/// Starts the program, presses Ctrl-C after a while and waits for the end.
#[cfg(unix)]
fn interrupted(folder: &Path, arguments: &[&str], milliseconds: u64) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_skycube"))
        .args(arguments)
        .current_dir(folder)
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(milliseconds));
    assert!(child.try_wait().unwrap().is_none(), "it should take minutes");
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    output
}

#[cfg(unix)]
#[test]
fn a_rendering_interrupted_before_its_first_sample_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("endless.toml"), ENDLESS).unwrap();
    interrupted(folder.path(), &["render", "endless.toml", "-o", "a.png"], 700);
    assert_eq!(files(folder.path()), ["endless.toml"]);
}

/// A glass ball in a box of mirrors: a ray of the camera sends on 2^1000 others.
const ENDLESS: &str = "camera = { position = [0, -5, 0], target = [0, 0, 0], size = [1, 1] }\n\
     integrator = { kind = \"whitted\", depth = 1000, weight_cutoff = 0 }\n\
     environment = { kind = \"constant\", radiance = 1 }\n\
     materials.glass = { kind = \"glass\" }\n\
     materials.mirror = { kind = \"mirror\" }\n\
     shapes = [{ kind = \"sphere\", material = \"glass\" },\n\
     { kind = \"box\", material = \"mirror\", minimum = [-9, -9, -9], maximum = [9, 9, 9] }]\n";

#[test]
fn the_time_ends_within_a_pixel() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("endless.toml"), ENDLESS).unwrap();
    for more in [&[][..], &["--textbook"], &["--integrator", "path", "--depth", "8"]] {
        let started = std::time::Instant::now();
        let output =
            skycube(folder.path(), &[&["render", "endless.toml", "--time", "500ms", "-o", "a.png"], more].concat());
        // Usually within 0.6 s; others may keep the machine busy.
        assert!(started.elapsed().as_secs_f64() < 2.5, "{more:?}: {:?}", started.elapsed());
        if more.contains(&"path") {
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            continue;
        }
        assert_eq!(output.status.code(), Some(2), "{more:?}");
        assert!(text(&output.stderr).contains("nothing was written"), "{}", text(&output.stderr));
        assert_eq!(files(folder.path()), ["endless.toml"]);
    }
}

#[test]
fn a_large_picture_is_there_coarsely_when_the_time_is_over() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("deep.toml"), ENDLESS).unwrap();
    let size = ["render", "deep.toml", "--depth", "6", "--size", "4000x3000"];
    let output = skycube(folder.path(), &[&size[..], &["--time", "1s", "-o", "a.png", "--json"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&report["stopped"], &report["samples"]), (&false.into(), &0.into()));
    assert!(report["coarse_rows"].as_u64().unwrap() > 0, "{report}");
    // Usually 1.2 s; the whole pass takes minutes. Others may keep the machine busy.
    assert!(report["seconds"]["rendering"].as_f64().unwrap() < 10.0, "{report}");
    let picture = skycube::picture::read(&folder.path().join("a.png")).unwrap();
    assert_eq!((picture.width(), picture.height()), (4000, 3000));
}

#[test]
fn a_trace_of_too_many_steps_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("endless.toml"), ENDLESS).unwrap();
    let output = skycube(folder.path(), &["trace", "endless.toml", "--pixel", "0,0"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("more than 1048576 steps"), "{}", text(&output.stderr));
}

#[cfg(unix)]
#[test]
fn an_interrupted_progressive_rendering_writes_what_is_there_and_marks_it() {
    for name in ["a.png", "a.jpg", "a.hdr", "a.exr"] {
        let folder = tempfile::tempdir().unwrap();
        let output =
            interrupted(folder.path(), &["render", LESSON, "--size", "64x40", "--samples", "65536", "-o", name], 1500);
        let report = text(&output.stdout);
        assert!(report.contains("stopped by Ctrl-C"), "{report}");
        assert_eq!(files(folder.path()), [name]);
        let bytes = std::fs::read(folder.path().join(name)).unwrap();
        let mark = b"stopped after ";
        assert!(bytes.windows(mark.len()).any(|window| window == mark), "{name}");
        assert_eq!(skycube::picture::read(&folder.path().join(name)).unwrap().width(), 64, "{name}");
    }
}

#[cfg(unix)]
#[test]
fn a_file_over_the_limit_of_the_shell_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let limited = "ulimit -f 1; exec \"$0\" \"$@\"";
    let output = Command::new("bash")
        .args(["-c", limited, env!("CARGO_BIN_EXE_skycube"), "render", LESSON, "--size", "200x100", "-o", "a.png"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let error = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(error.contains("a.png: cannot write: File too large"), "{error}");
    assert!(!error.contains(".partial"), "{error}");
    assert_eq!(files(folder.path()), [""; 0]);
}

/// Runs the program under a limit of the shell, as a user who is not exempt from it; `None` where the system cannot do that.
#[cfg(unix)]
fn limited(folder: &Path, limit: &str, arguments: &[&str]) -> Option<Output> {
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(folder, std::fs::Permissions::from_mode(0o777)).unwrap();
    let shell = ["bash", "-c", &format!("{limit}; exec \"$0\" \"$@\""), env!("CARGO_BIN_EXE_skycube")];
    let is_root = Command::new("id").arg("-u").output().is_ok_and(|output| output.stdout == b"0\n");
    let nobody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"];
    let words = if is_root { [&nobody[..], &shell].concat() } else { shell.to_vec() };
    let output = Command::new(words[0]).args(&words[1..]).args(arguments).current_dir(folder).output().ok()?;
    // 126: this user may not run the program.
    Some(output).filter(|output| output.status.code() != Some(126))
}

#[cfg(unix)]
#[test]
fn without_threads_the_calling_one_does_the_work() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("scene.toml"), ENDLESS).unwrap();
    for arguments in [
        &["render", "scene.toml", "--size", "16x10", "--depth", "3", "-o", "a.png"][..],
        &["render", "scene.toml", "--size", "16x10", "--depth", "3", "--threads", "3", "-o", "b.png"],
        &["bake", "scene.toml", "--depth", "3", "--face-size", "8", "-o", "faces"],
        &["compare", "a.png", "b.png"],
        &["check", "faces"],
        &["shots", "faces", "-o", "shots", "--size", "8"],
        &["trace", "scene.toml", "--depth", "3", "--pixel", "0,0"],
    ] {
        let Some(output) = limited(folder.path(), "ulimit -u 1", arguments) else {
            return eprintln!("skipped: no other user may run the program");
        };
        let error = text(&output.stderr);
        assert!(matches!(output.status.code(), Some(0 | 1)), "{arguments:?}: {error}");
        assert!(!error.contains("panicked"), "{arguments:?}: {error}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn memory_that_the_system_refuses_is_no_abort() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("endless.toml"), ENDLESS).unwrap();
    // A million steps take more than this, and nothing says so beforehand.
    let arguments = ["trace", "endless.toml", "--pixel", "0,0", "--depth", "1000"];
    let Some(output) = limited(folder.path(), "ulimit -v 150000", &arguments) else { return };
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
}

#[test]
fn layers_lie_beside_the_picture_in_exr_files_only() {
    let folder = tempfile::tempdir().unwrap();
    let size = ["render", LESSON, "--size", "8x5", "--samples", "2", "--layers"];
    let refused = skycube(folder.path(), &[&size[..], &["-o", "a.png"]].concat());
    assert_eq!(refused.status.code(), Some(2), "{}", text(&refused.stderr));
    let written = skycube(folder.path(), &[&size[..], &["-o", "a.exr"]].concat());
    assert_eq!(written.status.code(), Some(0), "{}", text(&written.stderr));
    let bytes = std::fs::read(folder.path().join("a.exr")).unwrap();
    for channel in ["normal.X", "albedo.R", "depth.Z", "variance.B"] {
        assert!(bytes.windows(channel.len()).any(|window| window == channel.as_bytes()), "{channel}");
    }
    assert_eq!(skycube::picture::read(&folder.path().join("a.exr")).unwrap().width(), 8);
}

#[test]
fn a_rendering_takes_the_time_it_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let started = std::time::Instant::now();
    let output = skycube(folder.path(), &["render", LESSON, "--size", "32x20", "--time", "2s", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let report = json_report(&text(&output.stdout));
    assert!(report["samples"].as_u64().unwrap() > 1, "{report}");
    assert!(started.elapsed().as_secs_f64() < 30.0, "the limit does not hold");
    let both = skycube(folder.path(), &["render", LESSON, "--time", "1s", "--spp", "4"]);
    assert_eq!(both.status.code(), Some(2));
}

#[test]
fn no_source_is_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let lesson = Path::new(LESSON).parent().unwrap();
    for name in ["environment-with.toml", "knot.obj"] {
        std::fs::copy(lesson.join(name), folder.path().join(name)).unwrap();
    }
    let map = folder.path().join("map");
    std::fs::create_dir(&map).unwrap();
    for name in ["posx", "negx", "posy", "negy", "posz", "negz"] {
        let face = format!("{name}.png");
        std::fs::copy(lesson.join("../../envmaps/compass").join(&face), map.join(&face)).unwrap();
    }
    let before = std::fs::read(map.join("posx.png")).unwrap();
    let scene = ["environment-with.toml", "--environment", "map", "--size", "8x5"];
    let rendered = skycube(folder.path(), &[&["render"], &scene[..], &["-o", "map/posx.png"]].concat());
    assert_eq!(rendered.status.code(), Some(2));
    assert!(text(&rendered.stderr).contains("it is not overwritten"), "{}", text(&rendered.stderr));
    let baked = skycube(folder.path(), &[&["bake"], &scene[..], &["-o", "map", "--face-size", "8"]].concat());
    assert_eq!(baked.status.code(), Some(2));
    assert_eq!(std::fs::read(map.join("posx.png")).unwrap(), before);
}

#[test]
fn bake_writes_the_six_images() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["bake", LESSON, "-o", "faces", "--face-size", "16", "--samples", "1", "--format", "jpg"];
    let output = skycube(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let expected = ["negx.jpg", "negy.jpg", "negz.jpg", "posx.jpg", "posy.jpg", "posz.jpg"];
    assert_eq!(files(&folder.path().join("faces")), expected);
}

/// What a check of a broken map prints with these settings of the environment.
fn broken_map(arguments: &[&str], environment: &[(&str, &str)]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_skycube"));
    for variable in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "COLUMNS"] {
        command.env_remove(variable);
    }
    let map = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/06-environment-map/broken");
    let output = command.args(["check", map]).args(arguments).envs(environment.iter().copied()).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    text(&output.stdout)
}

#[test]
fn colours_are_for_terminals_and_for_whom_they_are_forced_on() {
    let plain = broken_map(&[], &[]);
    assert!(!plain.contains('\u{1b}') && plain.lines().any(|line| line.len() > 80), "as wide as it is: {plain}");
    let coloured = broken_map(&["--color", "always"], &[]);
    assert!(coloured.contains("\u{1b}[1m\u{1b}[31mbroken\u{1b}[0m"), "{coloured}");
    let stripped = anstream::adapter::strip_str(&coloured).to_string();
    assert_eq!(stripped, plain);
    assert_eq!(broken_map(&[], &[("CLICOLOR_FORCE", "1")]), coloured);
    assert_eq!(broken_map(&[], &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]), plain);
    assert_eq!(broken_map(&["--color", "always"], &[("NO_COLOR", "1")]), coloured, "who asks is obeyed");
    assert_eq!(broken_map(&["--color", "never"], &[("CLICOLOR_FORCE", "1")]), plain);
    assert_eq!(broken_map(&[], &[("COLUMNS", "60")]), plain, "a pipe has no width");
}
