//! The tables `[materials.NAME]`.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use super::document::{Table, Value};
use crate::error::{Error, Result};
use crate::materials::{Checker, ColourSource, ImageTexture, Material};
use crate::math::{DVec2, Vec3};
use crate::picture::{self, Filter, Texture, Wrap};

/// Pictures of materials, each read once.
#[derive(Default)]
pub(super) struct TextureStore {
    textures: BTreeMap<(PathBuf, bool), Arc<Texture>>,
}

impl TextureStore {
    /// The texture of a file.
    pub(super) fn load(&mut self, path: PathBuf, filter: Filter) -> Result<Arc<Texture>> {
        let key = (path, filter == Filter::Nearest);
        if let Some(texture) = self.textures.get(&key) {
            return Ok(Arc::clone(texture));
        }
        let texture = Arc::new(Texture::new(picture::read(&key.0)?, filter, Wrap::Repeat));
        self.textures.insert(key, Arc::clone(&texture));
        Ok(texture)
    }

    /// The files that were read.
    pub(super) fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.textures.keys().map(|(path, _)| path)
    }
}

/// Reads one material.
pub(super) fn read(mut table: Table, textures: &mut TextureStore) -> Result<Material> {
    #[derive(Clone, Copy)]
    enum Kind {
        Normals,
        TextureCoordinates,
        Lambert,
        Phong,
        Mirror,
        Glass,
        Light,
    }
    let kind = table.required("kind")?.choice(&[
        ("normals", Kind::Normals),
        ("texture-coordinates", Kind::TextureCoordinates),
        ("lambert", Kind::Lambert),
        ("phong", Kind::Phong),
        ("mirror", Kind::Mirror),
        ("glass", Kind::Glass),
        ("light", Kind::Light),
    ])?;
    let material = match kind {
        Kind::Normals => Material::Normals,
        Kind::TextureCoordinates => Material::TextureCoordinates,
        Kind::Lambert => Material::Lambert { colour: reflectance(&table.required("colour")?, textures)? },
        Kind::Phong => Material::Phong {
            diffuse: reflectance(&table.required("diffuse")?, textures)?,
            specular: table.optional("specular").map_or(Ok(Vec3::ZERO), |value| uniform_reflectance(&value))?,
            exponent: table.optional("exponent").map_or(Ok(32.0), |value| {
                value.number_where("a number from 0 to 1000000", |number| (0.0..=1e6).contains(&number))
            })? as f32,
        },
        Kind::Mirror => Material::Mirror {
            colour: table
                .optional("colour")
                .map_or(Ok(ColourSource::Uniform(Vec3::ONE)), |value| reflectance(&value, textures))?,
        },
        Kind::Glass => Material::Glass {
            index: table.optional("index").map_or(Ok(1.5), |value| {
                value.number_where("an index of refraction, from 0.1 to 100", |number| (0.1..=100.0).contains(&number))
            })?,
            absorption: table.optional("absorption").map_or(Ok(Vec3::ZERO), |value| value.colour())?,
        },
        Kind::Light => Material::Light { radiance: table.required("radiance")?.colour()? },
    };
    table.finish()?;
    Ok(material)
}

/// A colour, `{ checker = [even, odd], repeat = [..] }` or `{ image = "file", repeat = [..], filter = ".." }`.
fn reflectance(value: &Value, textures: &mut TextureStore) -> Result<ColourSource> {
    if !value.is_table() {
        return uniform_reflectance(value).map(ColourSource::Uniform);
    }
    let mut table = value.table()?;
    let repeat = table.optional("repeat").map_or(Ok(DVec2::ONE), |value| repeat(&value))?;
    let source = match (table.optional("image"), table.optional("checker")) {
        (Some(image), None) => {
            let choices = [("nearest", Filter::Nearest), ("bilinear", Filter::Bilinear)];
            let filter = table.optional("filter").map_or(Ok(Filter::Bilinear), |value| value.choice(&choices))?;
            let texture = textures.load(image.path()?, filter).map_err(|error| at(&image, error))?;
            ColourSource::Image(ImageTexture { texture, repeat })
        }
        (None, Some(checker)) => {
            let colours = checker.list()?;
            let [even, odd] = colours.as_slice() else {
                return Err(checker.error(format!("found a list of {}", colours.len())).expected("two colours"));
            };
            let (even, odd) = (uniform_reflectance(even)?, uniform_reflectance(odd)?);
            ColourSource::Checker(Checker { even, odd, repeat })
        }
        _ => return Err(table.error("no single source of colour").expected("either \"image\" or \"checker\"")),
    };
    table.finish()?;
    Ok(source)
}

/// A colour that reflects no more than arrives.
fn uniform_reflectance(value: &Value) -> Result<Vec3> {
    let colour = value.colour()?;
    if colour.max_element() > 1.0 {
        return Err(value.error("a surface cannot reflect more light than arrives").expected("channels from 0 to 1"));
    }
    Ok(colour)
}

fn repeat(value: &Value) -> Result<DVec2> {
    if value.is_list() {
        return value.numbers::<2>("one number or two").map(DVec2::from_array);
    }
    value.number().map(DVec2::splat)
}

/// A picture's own error, with the place in the scene that names the picture.
fn at(value: &Value, error: Error) -> Error {
    value.error(error.to_string())
}
