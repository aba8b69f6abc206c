//! The tables `[materials.NAME]`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use skycube_files::document::{Table, Value};

use crate::error::{Error, Result};
use crate::materials::{
    Checker, Coat, ColourSource, ImageTexture, METALS, Material, Metal, MetalReflectance, RoughGlass,
};
use crate::math::{DVec2, Vec3};
use crate::parallel;
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

/// Reads one material. One that no shape shows is read as a smooth one: the tables of roughness take time.
pub(super) fn read(mut table: Table, textures: &mut TextureStore, shown: bool) -> Result<Material> {
    #[derive(Clone, Copy, clap::ValueEnum)]
    enum Kind {
        Normals,
        TextureCoordinates,
        Lambert,
        Phong,
        Mirror,
        Metal,
        Coated,
        Glass,
        Light,
    }
    let kind: Kind = table.required("kind")?.choice()?;
    let material = match kind {
        Kind::Normals => Material::Normals,
        Kind::TextureCoordinates => Material::TextureCoordinates,
        Kind::Lambert => Material::Lambert { colour: reflectance(&table.required("colour")?, textures)? },
        Kind::Phong => read_phong(&mut table, textures)?,
        Kind::Mirror => Material::Mirror { colour: white_or(table.optional("colour"), textures)? },
        Kind::Metal => read_metal(&mut table, shown)?,
        Kind::Coated => read_coated(&mut table, textures, shown)?,
        Kind::Glass => read_glass(&mut table)?,
        Kind::Light => Material::Light { radiance: table.required("radiance")?.colour()? },
    };
    table.finish()?;
    Ok(material)
}

fn read_phong(table: &mut Table, textures: &mut TextureStore) -> Result<Material> {
    let diffuse = reflectance(&table.required("diffuse")?, textures)?;
    let highlight = table.optional("specular");
    let specular = highlight.as_ref().map_or(Ok(Vec3::ZERO), uniform_reflectance)?;
    let brightest = match &diffuse {
        ColourSource::Uniform(colour) => *colour,
        ColourSource::Checker(checker) => checker.even.max(checker.odd),
        // Texels and vertices are not known to reach 1.
        ColourSource::Image(_) | ColourSource::Vertex => Vec3::ZERO,
    };
    // A little above 1 is rounding: 0.9 + 0.1.
    if let Some(value) = highlight.filter(|_| (brightest + specular).max_element() > 1.0 + 1e-6) {
        return Err(value
            .error("diffuse and specular together reflect more light than arrives")
            .expected("sums of at most 1 in every channel"));
    }
    let exponent = table.optional("exponent").map_or(Ok(32.0), |value| {
        value.number_where("a number from 0 to 1000000", |number| (0.0..=1e6).contains(&number))
    })? as f32;
    Ok(Material::Phong { diffuse, specular, exponent })
}

fn read_metal(table: &mut Table, shown: bool) -> Result<Material> {
    let roughness = roughness(table)?;
    let roughness = if shown { roughness } else { 0.0 };
    let reflectance = match (table.optional("metal"), table.optional("index"), table.optional("reflectance")) {
        (Some(name), None, None) => name.named(&METALS)?,
        (None, Some(index), None) => {
            MetalReflectance::Measured { index: index.colour()?, extinction: table.required("extinction")?.colour()? }
        }
        (None, None, Some(colour)) => MetalReflectance::Schlick { normal: uniform_reflectance(&colour)? },
        _ => {
            return Err(table
                .error("there must be one description of the metal")
                .expected("either \"metal\", or \"index\" and \"extinction\", or \"reflectance\""));
        }
    };
    Ok(Material::Metal(Arc::new(Metal::new(reflectance, roughness))))
}

fn read_coated(table: &mut Table, textures: &mut TextureStore, shown: bool) -> Result<Material> {
    let colour = reflectance(&table.required("colour")?, textures)?;
    let index = table.optional("index").map_or(Ok(1.5), |value| {
        value.number_where("an index of refraction, from 1 to 100", |number| (1.0..=100.0).contains(&number))
    })?;
    let roughness = roughness(table)?;
    let roughness = if shown { roughness } else { 0.0 };
    Ok(Material::Coated { coat: Arc::new(Coat::new(index, roughness)), colour })
}

fn read_glass(table: &mut Table) -> Result<Material> {
    let index = table.optional("index").map_or(Ok(1.5), |value| {
        value.number_where("an index of refraction, from 0.1 to 100", |number| (0.1..=100.0).contains(&number))
    })?;
    let absorption = table.optional("absorption").map_or(Ok(Vec3::ZERO), |value| value.colour())?;
    let roughness = roughness(table)?;
    let rough = (roughness > 0.0).then(|| Arc::new(RoughGlass::unprepared(roughness)));
    Ok(Material::Glass { index, absorption, rough })
}

/// The alpha of GGX, or 0 for smooth.
fn roughness(table: &mut Table) -> Result<f64> {
    table.optional("roughness").map_or(Ok(0.0), |value| {
        value.number_where("0 for smooth, or a roughness from 0.0001 to 1", |number| {
            number == 0.0 || (1e-4..=1.0).contains(&number)
        })
    })
}

/// Prepares the rough glasses that shapes show for vacuum and for each other: glasses may be nested, or touch.
pub(super) fn prepare_for_each_other(materials: &mut [Material], shown: &BTreeSet<u32>) {
    let shown = |number: usize| shown.contains(&(number as u32));
    let index = |(number, material): (usize, &Material)| match material {
        Material::Glass { index, .. } if shown(number) => Some(*index),
        _ => None,
    };
    let indices: Vec<f64> = std::iter::once(1.0).chain(materials.iter().enumerate().filter_map(index)).collect();
    let shown_ones = materials.iter_mut().enumerate().filter(|(number, _)| shown(*number));
    parallel::for_each(shown_ones, |(_, material)| {
        if let Material::Glass { index, rough: Some(rough), .. } = material {
            let rough = Arc::make_mut(rough);
            indices.iter().for_each(|&other| rough.meet(*index, other));
        }
    });
}

fn white_or(value: Option<Value>, textures: &mut TextureStore) -> Result<ColourSource> {
    value.map_or(Ok(ColourSource::Uniform(Vec3::ONE)), |value| reflectance(&value, textures))
}

/// A colour, `"vertex"`, `{ checker = [even, odd], repeat = [..] }` or `{ image = "file", repeat = [..], filter = ".." }`.
fn reflectance(value: &Value, textures: &mut TextureStore) -> Result<ColourSource> {
    if value.text().is_ok() {
        return value.named(&[("vertex", ColourSource::Vertex)]);
    }
    if !value.is_table() {
        return uniform_reflectance(value).map(ColourSource::Uniform);
    }
    let mut table = value.table()?;
    let repeat = table.optional("repeat").map_or(Ok(DVec2::ONE), |value| repeat(&value))?;
    let source = match (table.optional("image"), table.optional("checker")) {
        (Some(image), None) => {
            let filter = table.optional("filter").map_or(Ok(Filter::Bilinear), |value| value.choice())?;
            let texture = textures.load(image.path()?, filter).map_err(|error| at(&image, error))?;
            ColourSource::Image(ImageTexture { texture, repeat })
        }
        (None, Some(checker)) => {
            let colours = checker.list()?;
            let [even, odd] = colours.as_slice() else {
                return Err(checker.error(format!("found a list of length {}", colours.len())).expected("two colours"));
            };
            let (even, odd) = (uniform_reflectance(even)?, uniform_reflectance(odd)?);
            ColourSource::Checker(Checker { even, odd, repeat })
        }
        _ => return Err(table.error("there must be one source of colour").expected("either \"image\" or \"checker\"")),
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
