//! The table `[environment]`.

use std::path::{Path, PathBuf};

use skycube_files::document::{Document, Table, Value};

use crate::envmap::source::Skybox;
use crate::envmap::{
    CubeFilter, CubeMap, Environment, EnvironmentKind, Equirectangular, Face, FaceLookup, Gradient, LazyImage, Lookup,
    Preset, SignedAxis,
};
use crate::error::Result;
use crate::picture;

/// An environment and the files it may read.
pub(super) struct LoadedEnvironment {
    pub environment: Environment,
    pub files: Vec<PathBuf>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Kind {
    Constant,
    Gradient,
    Equirectangular,
    CubeMap,
}

/// Reads the environment; `map_override` replaces the picture or pictures named in the scene.
pub(super) fn read(table: Option<Table>, map_override: Option<PathBuf>) -> Result<LoadedEnvironment> {
    let Some(mut table) = table else {
        return Ok(LoadedEnvironment { environment: Environment::BLACK, files: Vec::new() });
    };
    let kind: Kind = table.required("kind")?.choice()?;
    if map_override.is_some() && matches!(kind, Kind::Constant | Kind::Gradient) {
        return Err(table
            .error("this environment has no map to replace")
            .expected("kind = \"cube-map\" or kind = \"equirectangular\""));
    }
    let (kind, files) = match kind {
        Kind::Constant => (EnvironmentKind::Constant(table.required("radiance")?.colour()?), Vec::new()),
        Kind::Gradient => (EnvironmentKind::Gradient(read_gradient(&mut table)?), Vec::new()),
        Kind::Equirectangular => {
            let (map, path) = read_equirectangular(&mut table, map_override)?;
            (EnvironmentKind::Equirectangular(map), vec![path])
        }
        Kind::CubeMap => {
            let (map, files) = read_cube_map(&mut table, map_override)?;
            (EnvironmentKind::CubeMap(Box::new(map)), files)
        }
    };
    let scale = match table.optional("scale") {
        Some(value) => value.number_where("a number from 0 to 1e30", |number| (0.0..=1e30).contains(&number))? as f32,
        None => 1.0,
    };
    table.finish()?;
    Ok(LoadedEnvironment { environment: Environment { kind, scale }, files })
}

fn read_cube_map(table: &mut Table, map_override: Option<PathBuf>) -> Result<(CubeMap, Vec<PathBuf>)> {
    let skybox = read_skybox(table, map_override)?;
    let lookup = table.optional("lookup").map_or(Ok(Preset::Opengl.lookup()), |value| read_lookup(&value))?;
    let filter = table.optional("filter").map_or(Ok(CubeFilter::default()), |value| value.choice())?;
    let files = skybox.files();
    Ok((CubeMap::from_skybox(&skybox, lookup, filter), files))
}

fn read_gradient(table: &mut Table) -> Result<Gradient> {
    let zenith = table.required("zenith")?.colour()?;
    let horizon = table.required("horizon")?.colour()?;
    let nadir = table.optional("nadir").map_or(Ok(horizon), |value| value.colour())?;
    Ok(Gradient { up: read_up(table)?, zenith, horizon, nadir })
}

fn read_equirectangular(table: &mut Table, map_override: Option<PathBuf>) -> Result<(Equirectangular, PathBuf)> {
    let image = table.required("image")?;
    let path = map_override.map_or_else(|| image.path(), Ok)?;
    // The header is read now, so that a wrong name is an error even if no ray sees the map.
    picture::read_file_header(&path).map_err(|error| image.error(error.to_string()))?;
    let decoded_later = path.clone();
    let turns = table.optional("rotate").map_or(Ok(0.0), |value| value.number())?.rem_euclid(360.0) / 360.0;
    let image = LazyImage::new(Box::new(move || picture::read(&decoded_later)));
    Ok((Equirectangular { image, up: read_up(table)?, turns: turns as f32 }, path))
}

fn read_up(table: &mut Table) -> Result<SignedAxis> {
    match table.optional("up") {
        Some(value) => read_axis(&value),
        None => Ok(SignedAxis::POS_Z),
    }
}

fn read_axis(value: &Value) -> Result<SignedAxis> {
    let text = value.text()?;
    text.parse().map_err(|_| value.error(format!("found \"{text}\"")).expected("one of +x -x +y -y +z -z"))
}

/// `map = "folder, zip or picture"`, or `faces = { posx = "file", ... }`.
fn read_skybox(table: &mut Table, map_override: Option<PathBuf>) -> Result<Skybox> {
    let (map, faces) = (table.optional("map"), table.optional("faces"));
    if let Some(path) = map_override {
        return Skybox::open(&path);
    }
    match (map, faces) {
        (Some(map), None) => Skybox::open(&map.path()?).map_err(|error| map.error(error.to_string())),
        (None, Some(faces)) => {
            let mut named = faces.table()?;
            let mut files = Vec::new();
            for face in Face::ALL {
                files.push((face, named.required(face.name())?.path()?));
            }
            named.finish()?;
            Skybox::from_files(&files).map_err(|error| faces.error(error.to_string()))
        }
        _ => Err(table.error("there must be one source of pictures").expected("either \"map\" or \"faces\"")),
    }
}

/// Reads a lookup table from a separate file, with the keys of `[environment.lookup]` at its top level.
pub fn read_lookup_file(file: &Path) -> Result<Lookup> {
    let document = Document::read(file)?;
    let parsed = document.parse()?;
    read_lookup_table(document.root(&parsed))
}

/// The name of a preset, or a table of the user's own.
pub(super) fn read_lookup(value: &Value) -> Result<Lookup> {
    if !value.is_table() {
        return value.choice().map(Preset::lookup);
    }
    read_lookup_table(value.table()?)
}

fn read_lookup_table(mut table: Table) -> Result<Lookup> {
    let v_origin = table.required("v_origin")?.choice()?;
    let images = Face::ALL.map(|face| (face.name(), face));
    let mut rows = Vec::new();
    for face in Face::ALL {
        let mut row = table.required(face.name())?.table()?;
        let image = row.optional("image").map_or(Ok(face), |image| image.named(&images))?;
        rows.push(FaceLookup { image, u: read_axis(&row.required("u")?)?, v: read_axis(&row.required("v")?)? });
        row.finish()?;
    }
    let rows: [FaceLookup; 6] = rows.try_into().expect("there are six faces");
    let lookup = Lookup::new(rows, v_origin).map_err(|problem| table.error(problem))?;
    table.finish()?;
    Ok(lookup)
}
