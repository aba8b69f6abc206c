//! What the integration tests and benchmarks share.
#![allow(dead_code)] // Every test uses a part of it.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Mutex;

/// A lookup of which two faces read one image.
pub const SHARED_IMAGE_LOOKUP: &str = "v_origin = \"bottom\"\nposx = { u = \"-y\", v = \"+z\" }\n\
    negx = { u = \"+y\", v = \"+z\", image = \"posx\" }\nposy = { u = \"+x\", v = \"+z\" }\nnegy = { u = \"-x\", v = \"+z\" }\n\
    posz = { u = \"+x\", v = \"-y\" }\nnegz = { u = \"+x\", v = \"+y\" }\n";

/// A file or folder of the project.
pub fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// What the program does with these arguments in a folder, whatever the language of the system.
pub fn skycube(folder: &Path, arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_skycube"));
    program.env("LC_ALL", "C").args(arguments).current_dir(folder).output().unwrap()
}

/// The same as exit code, standard output and standard error.
pub fn outcome(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = skycube(folder, arguments);
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

/// What the program wrote.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// True to try whole tables, which takes minutes: `SKYCUBE_THOROUGH=1 cargo test --profile thorough`.
pub fn thorough() -> bool {
    std::env::var_os("SKYCUBE_THOROUGH").is_some()
}

/// A file or folder among the real environment maps, which are not part of this repository. They are looked for in the
/// folder that `SKYCUBE_SHARED_MAPS` names, or in `../shared/envmaps` beside the repository. Where it is missing, says
/// that the test skips it and gives `None`: a map of the project then has the same kind of fault.
pub fn shared_map(name: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("SKYCUBE_SHARED_MAPS").map_or_else(|| project("../shared/envmaps"), PathBuf::from);
    present(&folder, name)
}

/// The path in a folder that is not part of this repository; `None`, and a line that says so, where it is missing.
pub fn present(folder: &Path, name: &str) -> Option<PathBuf> {
    let path = folder.join(name);
    if path.exists() {
        return Some(path);
    }
    say_skipped(if folder.exists() { &path } else { folder });
    None
}

/// Says once for each test what it skips: to the terminal itself, since `cargo test` shows nothing that a passing test prints.
fn say_skipped(missing: &Path) {
    static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let test = std::thread::current().name().unwrap_or("a test").to_owned();
    let line = format!("skipped in {test}: {} is missing\n", missing.display());
    if SAID.lock().unwrap().insert(line.clone()) {
        std::io::stderr().write_all(line.as_bytes()).unwrap();
    }
}
