//! skycube: a small, complete ray tracer for teaching, and a validator for skyboxes.
//!
//! Render a scene:
//!
//! ```
//! use std::path::Path;
//!
//! use skycube::picture::{self, WriteOptions};
//! use skycube::render::{Silent, render};
//! use skycube::scene::{Plan, Scene};
//!
//! let mut scene = Scene::read(Path::new("lessons/04-whitted/glass-depth-10.toml"))?;
//! scene.camera = scene.camera.resized([48, 30]);
//! scene.samples = 1;
//! let plan = Plan::new(&scene);
//! let rendering = render(&scene, &plan, &Silent)?;
//! let target = std::env::temp_dir().join("skycube-example.exr");
//! picture::write(&rendering.raster, &target, &WriteOptions::default())?;
//! # std::fs::remove_file(target).unwrap();
//! # Ok::<(), skycube::error::Error>(())
//! ```
//!
//! Check a map, and say what its files need:
//!
//! ```
//! use std::path::Path;
//!
//! use skycube::envmap::{Preset, source::Skybox};
//! use skycube::validate::{CheckOptions, ImageFacts, Verdict, check, load};
//!
//! let skybox = Skybox::open(Path::new("envmaps/hall"))?;
//! let map = load(&skybox, Preset::Exercise.lookup())?;
//! let options = CheckOptions { world_up: "+z".parse().ok(), ..CheckOptions::default() };
//! let check = check(&map, ImageFacts::of_skybox(&skybox), &options)?;
//! assert_eq!(check.verdict, Verdict::Broken);
//! for fix in check.fix.faces.iter().filter(|fix| !fix.is_unchanged(map.lookup())) {
//!     let (u, v) = fix.orientation.formulas();
//!     println!("{} reads {} at u = {u}, v = {v}", fix.face.name(), fix.image.name());
//! }
//! # Ok::<(), skycube::error::Error>(())
//! ```
//!
//! Read the modules in this order; none uses those below it. They form four packages, so that only code that must be
//! fast is compiled with full optimisation:
//!
//! - `src/files`: file formats, and errors about files;
//! - `src/tracer`: from numbers to rendered pictures;
//! - `src/analysis`: analyses of skyboxes, pictures and the tracer itself;
//! - `src`: commands and reports.

pub use skycube_tracer::{
    bvh, camera, choice, colour, envmap, error, integrators, lights, materials, math, memory, parallel, picture,
    render, sampling, scene, shapes,
};

pub use skycube_analysis::{PixelTrace, Random, compare, converge, digits, grade, limits, metrics, validate};
#[cfg(feature = "stress")]
pub use skycube_analysis::{stress, validator_limits};

pub mod lessons;

pub mod report;

pub mod commands;
