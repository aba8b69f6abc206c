//! The options of commands that look at a map under a lookup.

use std::path::{Path, PathBuf};

use clap::Args;

use super::config::{Config, Reading};
use super::engine_option::EngineOption;
use crate::envmap::source::{Naming, Skybox};
use crate::envmap::{CubeFilter, CubeMap, Face, Lookup, Preset, SignedAxis};
use crate::error::Result;
use crate::validate::{Check, CheckOptions, ImageFacts, Names, Note, check, load};

/// A map and the lookup it is seen through.
#[derive(Debug, Args)]
pub struct MapOptions {
    /// The map: a folder, a zip, a cross or strip picture, an OpenEXR cube; - for a zip or picture on standard input
    pub map: PathBuf,
    /// The lookup: a preset or a TOML file [default: opengl]
    #[arg(long)]
    lookup: Option<String>,
    #[command(flatten)]
    engine: EngineOption,
    /// Ignore skycube.toml, which sets lookup or engine and up axis of the maps below its folder
    #[arg(long)]
    no_config: bool,
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
    /// The axis that points up in the world, by the configuration or the engine.
    pub usual_up: Option<SignedAxis>,
    /// How the engine shows the map, if there is one, and what the configuration says.
    pub remarks: Vec<String>,
    /// Files that must not be overwritten.
    pub sources: Vec<PathBuf>,
}

/// What reports call a map: the name of its file or folder.
pub fn name_of_map(map: &Path) -> String {
    map.file_name().map_or_else(|| map.display().to_string(), |name| name.display().to_string())
}

impl MapOptions {
    /// Opens the map, with faces of any size as in `check`, and reads the lookup.
    pub fn open(&self) -> Result<OpenMap> {
        self.open_at(&self.map)
    }

    /// The same for one of the maps in a folder.
    pub fn open_at(&self, map: &Path) -> Result<OpenMap> {
        let skybox = Skybox::open_lenient(map)?;
        let config = if self.no_config { None } else { Config::above(map)? };
        let reading = Reading { lookup: self.lookup.clone(), engine: self.engine, world_up: None };
        let Reading { lookup: given, engine, world_up } = reading.configured(config.as_ref());
        let lookup = engine.lookup(given.as_deref(), DEFAULT_LOOKUP, &skybox)?;
        let mut sources = skybox.files();
        sources.extend(given.iter().map(PathBuf::from));
        Ok(OpenMap {
            skybox,
            lookup,
            name: name_of_map(map),
            lookup_name: engine.name(given.as_deref(), DEFAULT_LOOKUP),
            usual_up: world_up.or(engine.world_up()),
            remarks: engine.description().into_iter().chain(config.map(|config| config.line())).collect(),
            sources,
        })
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
        let world_up = world_up.or(self.usual_up);
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

impl OpenMap {
    /// The world's up axis if the user named `world_up`, and what is said of it: by the engine, by the configuration, or that it
    /// was assumed.
    pub fn up_axis(&self, world_up: Option<SignedAxis>) -> (SignedAxis, Option<String>) {
        let mut remarks = self.remarks.clone();
        let world_up = world_up.or(self.usual_up).unwrap_or_else(|| {
            let (name, world_up) = (&self.lookup_name, Preset::usual_up_of(&self.lookup_name));
            remarks.push(format!("assumed a world with {world_up} up, for the lookup {name}; --world-up changes this"));
            world_up
        });
        (world_up, (!remarks.is_empty()).then(|| remarks.join("\n")))
    }
}

impl ViewOptions {
    /// The same for the axis of these options.
    pub fn world_up(&self, map: &OpenMap) -> (SignedAxis, Option<String>) {
        map.up_axis(self.world_up)
    }
}
