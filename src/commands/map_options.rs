//! The options of commands that look at a map under a lookup.

use std::path::PathBuf;

use clap::Args;

use super::engine_option::EngineOption;
use crate::envmap::source::{Naming, Skybox};
use crate::envmap::{CubeFilter, CubeMap, Face, Lookup, Preset, SignedAxis};
use crate::error::Result;
use crate::validate::{Check, CheckOptions, ImageFacts, Names, Note, check, load};

/// A map and the lookup it is seen through.
#[derive(Debug, Args)]
pub struct MapOptions {
    /// The map: a folder, a zip, a cross or strip picture, an OpenEXR cube; - for a zip or picture on standard input
    map: PathBuf,
    /// The lookup: a preset or a TOML file [default: opengl]
    #[arg(long)]
    lookup: Option<String>,
    #[command(flatten)]
    pub engine: EngineOption,
}

/// The lookup where none is given.
pub const DEFAULT_LOOKUP: &str = "opengl";

/// How a map is seen.
#[derive(Debug, Args)]
pub struct ViewOptions {
    #[command(flatten)]
    pub map: MapOptions,
    /// The filter between texels
    #[arg(long, value_enum, default_value = "bilinear")]
    pub filter: CubeFilter,
    /// The axis that points up in the world [default: +y for opengl and humus-y-up, else +z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub world_up: Option<SignedAxis>,
}

/// A map that is open: names and headers are read, pixels are not.
#[derive(Debug)]
pub struct OpenMap {
    pub skybox: Skybox,
    pub lookup: Lookup,
    /// The map's file or folder name, for headings.
    pub name: String,
    /// The name of the lookup, as given by the user.
    pub lookup_name: String,
    /// The axis that points up in the world of the engine, if the user named one.
    pub engine_up: Option<SignedAxis>,
    /// Files that must not be overwritten.
    pub sources: Vec<PathBuf>,
}

impl MapOptions {
    /// Opens the map, with faces of any size as in `check`, and reads the lookup.
    pub fn open(&self) -> Result<OpenMap> {
        let given = self.lookup.as_deref();
        let skybox = Skybox::open_lenient(&self.map)?;
        let lookup = self.engine.lookup(given, DEFAULT_LOOKUP, &skybox)?;
        let mut sources = skybox.files();
        sources.extend(given.map(PathBuf::from));
        let name =
            self.map.file_name().map_or_else(|| self.map.display().to_string(), |name| name.display().to_string());
        let engine_up = self.engine.world_up();
        Ok(OpenMap { skybox, lookup, name, engine_up, lookup_name: self.engine.name(given, DEFAULT_LOOKUP), sources })
    }
}

impl OpenMap {
    /// The map under a lookup, with nothing decoded yet.
    pub fn cube_map(&self, lookup: Lookup, filter: CubeFilter) -> CubeMap {
        CubeMap::from_skybox(&self.skybox, lookup, filter)
    }

    /// The map under its lookup, all images decoded on all cores, and what the validator says of it. `world_up` is the
    /// axis that the user named.
    pub fn checked(&self, filter: CubeFilter, world_up: Option<SignedAxis>) -> Result<(CubeMap, Check)> {
        let world_up = world_up.or(self.engine_up);
        let options = CheckOptions { world_up, lookup_name: self.lookup_name.clone(), ..CheckOptions::default() };
        let (mut map, check) = check_skybox(&self.skybox, self.lookup, &options)?;
        map.set_filter(filter);
        Ok((map, check))
    }

    /// The image that a face reads, and its file: `posz (Meadow.zip/posz.jpg)`.
    pub fn image_of(&self, lookup: &Lookup, face: Face) -> String {
        let image = lookup.row(face).image;
        format!("{} ({})", image.name(), self.skybox.image(image).name())
    }
}

/// A skybox under a lookup, all images decoded on all cores, and what the validator says of it.
pub fn check_skybox(skybox: &Skybox, lookup: Lookup, options: &CheckOptions) -> Result<(CubeMap, Check)> {
    let map = load(skybox, lookup)?;
    // Where names or cells do not say which face an image is, the pixels must.
    let names = match options.names {
        Names::Auto if skybox.naming.is_free() => Names::AnyOrder,
        names => names,
    };
    let options = CheckOptions { names, ..options.clone() };
    let mut check = check(&map, ImageFacts::of_skybox(skybox), &options)?;
    if matches!(skybox.naming, Naming::Numbers | Naming::Nothing) {
        check.notes.push(Note::Unnamed { numbered: skybox.naming == Naming::Numbers });
    }
    Ok((map, check))
}

impl MapOptions {
    /// The world's up axis if the user named `world_up`, and a sentence if it follows from the engine or from the lookup's name.
    pub fn up_axis(&self, world_up: Option<SignedAxis>) -> (SignedAxis, Option<String>) {
        if let Some(world_up) = world_up.or(self.engine.world_up()) {
            return (world_up, self.engine.description());
        }
        let name = self.lookup.as_deref().unwrap_or(DEFAULT_LOOKUP);
        let world_up = Preset::usual_up_of(name);
        (world_up, Some(format!("assumed a world with {world_up} up, for the lookup {name}; --world-up changes this")))
    }
}

impl ViewOptions {
    /// The world's up axis, and a sentence if it follows from the engine or from the lookup's name.
    pub fn world_up(&self) -> (SignedAxis, Option<String>) {
        self.map.up_axis(self.world_up)
    }
}
