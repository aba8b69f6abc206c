//! What the integration tests and benchmarks share.
#![allow(dead_code)] // Every test uses a part of it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

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
/// that the test is skipped and gives `None`.
pub fn shared_map(name: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("SKYCUBE_SHARED_MAPS")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/envmaps"), PathBuf::from);
    let path = folder.join(name);
    if path.exists() {
        return Some(path);
    }
    println!("skipped: {} is missing", path.display());
    None
}
