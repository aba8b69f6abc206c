//! The option `--engine`, beside `--lookup` in every command that takes a map.

use clap::Args;

use super::options::read_lookup;
use crate::envmap::source::Skybox;
use crate::envmap::{Engine, Face, Lookup, SignedAxis};
use crate::error::{Error, Result};

/// The engine that shows the map, if the user names one.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct EngineOption {
    /// The engine that shows the map: its table, its up axis, its left- or right-handed world
    #[arg(long, value_enum, hide_possible_values = true, value_name = ENGINES)]
    engine: Option<Engine>,
}

const ENGINES: &str = "opengl|vulkan|directx|threejs|babylon|unity|unreal|godot|blender";

impl EngineOption {
    /// The option with this engine.
    pub fn of(engine: Option<Engine>) -> Self {
        Self { engine }
    }

    /// True if there is an engine.
    pub fn is_given(&self) -> bool {
        self.engine.is_some()
    }

    /// What reports call the lookup: the name of the engine, or that of the lookup.
    pub fn name<'a>(&self, lookup: Option<&'a str>, default: &'a str) -> String {
        self.engine.map_or_else(|| lookup.unwrap_or(default).to_owned(), Engine::name)
    }

    /// The table: the engine's for these files, or that of the name. An error if the user gave both, and they differ.
    pub fn lookup(&self, name: Option<&str>, default: &str, skybox: &Skybox) -> Result<Lookup> {
        let Some(engine) = self.engine else { return read_lookup(name.unwrap_or(default)) };
        let files = Face::ALL.map(|image| skybox.image(image).name());
        let lookup = engine.lookup(files);
        match name {
            Some(name) if read_lookup(name)?.rows_from_top() != lookup.rows_from_top() => {
                Err(Error::new(format!("--engine {} does not read by --lookup {name}", engine.name()))
                    .help("leave one of the two: the engine brings its lookup with it"))
            }
            _ => Ok(lookup),
        }
    }

    /// What the engine calls the file that it shows in the direction of a face.
    pub fn file_name(&self, face: Face) -> Option<&'static str> {
        self.engine.map(|engine| engine.file_name(face))
    }

    /// The axis that points up in the engine's world.
    pub fn world_up(&self) -> Option<SignedAxis> {
        self.engine.map(|engine| engine.world().up)
    }

    /// How the engine shows a map, for reports.
    pub fn description(&self) -> Option<String> {
        self.engine.map(Engine::description)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_help_names_all_engines() {
        assert_eq!(ENGINES, Engine::ALL.map(Engine::name).join("|"));
    }
}
