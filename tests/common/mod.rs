//! What the integration tests and benchmarks share.

use std::path::{Path, PathBuf};

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
