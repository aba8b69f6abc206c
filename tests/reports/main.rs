//! Reports for other programs: JSON with its schemas, SARIF, JUnit, annotations; what the configuration file changes; the
//! GitHub action.

#[path = "../common/mod.rs"]
mod common;

mod action;
mod configuration;
mod folders;
mod formats;
mod libraries;
mod schemas;

use std::path::Path;

use skycube::envmap::Face;
use skycube::picture::{Raster, WriteOptions, read, write};

/// The compass in a folder, small, with a face turned clockwise if `turned` names one.
fn compass(folder: &Path, turned: Option<Face>) {
    std::fs::create_dir_all(folder).unwrap();
    for face in Face::ALL {
        let file = Path::new(face.name()).with_extension("png");
        let picture = read(&common::project("envmaps/compass").join(&file)).unwrap().to_raster().reduced(4);
        let last = picture.width() - 1;
        let clockwise = Raster::from_function(picture.width(), picture.height(), |x, y| picture.pixel(y, last - x));
        let shown = if turned == Some(face) { clockwise } else { picture };
        write(&shown, &folder.join(file), &WriteOptions::default()).unwrap();
    }
}
