//! Cached references.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::configuration::Configuration;
use crate::error::Result;
use crate::picture::{self, Extras, Raster, WriteOptions, read_plain_file};
use crate::scene::Scene;

/// The key of a reference: what its pixels depend on, as 16 hexadecimal digits. The scene's files count by their bytes,
/// not by their names.
pub(super) fn key(scene: &Scene, configuration: &Configuration, samples: u32) -> Result<String> {
    let mut recipe = format!("skycube {} reference 1\n", env!("CARGO_PKG_VERSION"));
    let [width, height] = scene.camera.size();
    let seed = scene.sampling.seed;
    let cutoff = scene.integrator.weight_cutoff.to_bits();
    let _ = writeln!(recipe, "size {width} {height} samples {samples} seed {seed} cutoff {cutoff:x}");
    for (name, value) in configuration.named() {
        let _ = writeln!(recipe, "{name} {value}");
    }
    for file in &scene.sources {
        let bytes = read_plain_file(file, "a file of the scene")?;
        let _ = writeln!(recipe, "file {} {:08x} {:016x}", bytes.len(), crc32fast::hash(&bytes), hash(&bytes));
    }
    Ok(format!("{:016x}", hash(recipe.as_bytes())))
}

/// FNV-1a with 64 bits (Fowler, Noll and Vo, 1991).
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// The halves under a key; `None` if they are not there whole.
pub(super) fn read(folder: &Path, key: &str, size: [usize; 2]) -> Option<[Raster; 2]> {
    let half = |name: &str| {
        let raster = picture::read(&file(folder, key, name)).ok()?.to_raster();
        ([raster.width(), raster.height()] == size).then_some(raster)
    };
    Some([half("-first-half")?, half("-second-half")?])
}

/// Writes the halves, and their mean for those who want to look at it, with a remark.
pub(super) fn write(folder: &Path, key: &str, halves: &[Raster; 2], mean: &Raster, remark: &str) -> Result<()> {
    picture::make_folder(folder)?;
    let [first, second] = halves;
    for (raster, name) in [(first, "-first-half"), (second, "-second-half"), (mean, "")] {
        let extras = Extras { remark: name.is_empty().then_some(remark), ..Extras::default() };
        picture::write_with(raster, &file(folder, key, name), &WriteOptions::default(), extras)?;
    }
    Ok(())
}

fn file(folder: &Path, key: &str, name: &str) -> PathBuf {
    folder.join(format!("{key}{name}.exr"))
}
