//! Materials of an MTL file, as plain data.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use super::{read_text, statements};
use crate::error::{Error, Result};
use crate::math::Vec3;

/// A material of an MTL file; what it does not say is `None`. Colours are as written.
#[derive(Debug, Clone, PartialEq)]
pub struct ObjMaterial {
    pub name: String,
    /// `Kd`.
    pub diffuse: Option<Vec3>,
    /// `Ks`.
    pub specular: Option<Vec3>,
    /// `Ns`, the Phong exponent.
    pub shininess: Option<f32>,
    /// `Ni`.
    pub index_of_refraction: Option<f32>,
    /// `d`: 1 is opaque.
    pub dissolve: Option<f32>,
    /// `illum`.
    pub illumination: Option<u8>,
    /// `map_Kd`: the picture, joined to the folder of the MTL file.
    pub diffuse_map: Option<PathBuf>,
}

/// The material libraries of an object, in the order in which it names them.
#[derive(Default)]
pub(super) struct Libraries {
    files: Vec<(PathBuf, String)>,
    names: Vec<String>,
}

impl Libraries {
    /// Reads and checks another library.
    pub(super) fn add(&mut self, path: PathBuf) -> Result<()> {
        let text = read_text(&path)?;
        for (line, keyword, rest) in statements(&text) {
            check(keyword, rest).map_err(|error| error.at_line(line).in_file(&path))?;
            if keyword == "newmtl" {
                self.names.push(rest.to_owned());
            }
        }
        self.files.push((path, text));
        Ok(())
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.names.iter().any(|known| known == name)
    }

    pub(super) fn names(&self) -> &[String] {
        &self.names
    }

    /// What `tobj` makes of the library at `path`.
    pub(super) fn load(&self, path: &Path) -> tobj::MTLLoadResult {
        let file = self.files.iter().find(|(known, _)| known == path).ok_or(tobj::LoadError::OpenFileFailed)?;
        tobj::load_mtl_buf(&mut Cursor::new(file.1.as_bytes()))
    }

    /// The material as data; pictures lie beside the library that names the material.
    pub(super) fn material(&self, material: &tobj::Material) -> ObjMaterial {
        let defines = |text: &str| statements(text).any(|(_, word, name)| word == "newmtl" && name == material.name);
        let home = self.files.iter().rfind(|(_, text)| defines(text)).and_then(|(path, _)| path.parent());
        let picture = |name: &String| home.unwrap_or(Path::new("")).join(name.replace('\\', "/"));
        ObjMaterial {
            name: material.name.clone(),
            diffuse: material.diffuse.map(Vec3::from),
            specular: material.specular.map(Vec3::from),
            shininess: material.shininess,
            index_of_refraction: material.optical_density,
            dissolve: material.dissolve,
            illumination: material.illumination_model,
            diffuse_map: material.diffuse_texture.as_ref().map(picture),
        }
    }
}

/// Refuses a statement whose values `tobj` could not read.
fn check(keyword: &str, rest: &str) -> Result<()> {
    let numbers = match keyword {
        "Ka" | "Kd" | "Ks" | "Ke" => 3,
        "Ns" | "Ni" | "d" | "illum" => 1,
        "newmtl" | "map_Kd" if rest.is_empty() => {
            return Err(Error::new(format!("`{keyword}` without a name")).expected("a name"));
        }
        "map_Kd" if rest.starts_with('-') => {
            return Err(Error::new(format!("found \"map_Kd {rest}\""))
                .expected("a file name without options")
                .help("take the options out of the line"));
        }
        _ => return Ok(()),
    };
    let words: Vec<&str> = rest.split_whitespace().take(numbers).collect();
    let readable = |word: &&str| match keyword {
        "illum" => word.parse::<u8>().is_ok(),
        _ => word.parse::<f32>().is_ok_and(f32::is_finite),
    };
    if words.len() == numbers && words.iter().all(readable) {
        return Ok(());
    }
    let expected = if numbers == 3 { "three numbers" } else { "a number" };
    Err(Error::new(format!("found \"{keyword} {rest}\"")).expected(expected))
}
