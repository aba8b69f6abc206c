//! Materials of an MTL file, as plain data.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::path::{Path, PathBuf};

use super::statements::{Mention, listed, number, read_text, shortened, statements, without_comment, words};
use crate::error::{Error, Result};
use crate::math::Vec3;

/// A material of an MTL file; `None` where the file has no value. Colours are as written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ObjMaterial {
    /// The name after `newmtl`.
    pub name: String,
    /// `Kd`.
    pub diffuse: Option<Vec3>,
    /// `Ks`.
    pub specular: Option<Vec3>,
    /// `Ke`.
    pub emission: Option<Vec3>,
    /// `Ns`, the Phong exponent.
    pub shininess: Option<f32>,
    /// `Ni`.
    pub index_of_refraction: Option<f32>,
    /// `d`, or 1 - `Tr`: 1 is opaque.
    pub dissolve: Option<f32>,
    /// `illum`.
    pub illumination: Option<u8>,
    /// `Pr`.
    pub roughness: Option<f32>,
    /// `Pm`.
    pub metalness: Option<f32>,
    /// `map_Kd`.
    pub diffuse_map: Option<ObjMap>,
    /// What else the material says, by its keywords.
    pub unread: BTreeSet<String>,
}

/// A picture that a material names.
#[derive(Debug, Clone, PartialEq)]
pub struct ObjMap {
    /// Joined to the folder of the MTL file.
    pub file: PathBuf,
    /// `-s`: pictures per unit of the texture coordinates.
    pub repeat: [f64; 2],
}

/// The materials of a mesh file.
#[derive(Debug, Clone, Default)]
pub struct ObjMaterials {
    /// One for each group of the mesh; `None` for faces without one.
    pub groups: Vec<Option<ObjMaterial>>,
    /// The MTL files that were read.
    pub files: Vec<PathBuf>,
    /// What was read with goodwill or left out.
    pub remarks: Vec<String>,
}

/// What to do about a material that is missing.
const HELP: &str =
    "put the MTL file where the `mtllib` line of the OBJ file points, or give the shape a `material` of the scene";

impl ObjMaterials {
    /// The materials of the groups of an OBJ file at `path`, from the libraries that it names.
    pub(super) fn read(groups: &[Option<Mention>], mentioned: &[Mention], path: &Path) -> Result<Self> {
        let mut libraries = Libraries::default();
        if groups.iter().any(Option::is_some) {
            let folder = path.parent().unwrap_or(Path::new(""));
            for library in mentioned {
                libraries.add_all(folder, library).map_err(|error| error.help(HELP))?;
            }
        }
        let material = |group: &Option<Mention>| group.as_ref().map_or(Ok(None), |mention| libraries.find(mention));
        let groups = groups.iter().map(material).collect::<Result<_>>()?;
        libraries.remarks.extend(libraries.missing.iter().map(|error| error.to_string().replace('\n', ";")));
        Ok(Self { groups, files: libraries.files, remarks: libraries.remarks })
    }
}

/// The material libraries of an object.
#[derive(Default)]
struct Libraries {
    /// Of two materials of one name the first counts.
    materials: HashMap<String, ObjMaterial>,
    names: Vec<String>,
    files: Vec<PathBuf>,
    seen: HashSet<PathBuf>,
    remarks: Vec<String>,
    missing: Option<Error>,
}

impl Libraries {
    /// Reads the libraries of a `mtllib` line: one whose name may hold blanks, or several.
    fn add_all(&mut self, folder: &Path, line: &Mention) -> Result<()> {
        let whole = without_comment(&line.name);
        let names = if beside(folder, whole).0.is_file() { vec![whole] } else { words(whole).collect() };
        for name in names {
            let (file, moved) = beside(folder, name);
            if !self.seen.insert(file.clone()) {
                continue;
            }
            if moved {
                self.remarks.push(format!("{} is read for \"{}\"", file.display(), shortened(name)));
            }
            match read_text(&file, "an MTL file") {
                Ok(text) => self.add(&file, &text).map_err(|error| error.in_file(&file))?,
                Err(error) => drop(self.missing.get_or_insert(error.help(HELP))),
            }
            self.files.push(file);
        }
        Ok(())
    }

    fn add(&mut self, file: &Path, text: &str) -> Result<()> {
        let folder = file.parent().unwrap_or(Path::new(""));
        let mut material: Option<ObjMaterial> = None;
        let mut odd = None;
        for (line, keyword, rest) in statements(text) {
            if keyword.eq_ignore_ascii_case("newmtl") {
                self.finish(material.replace(ObjMaterial { name: rest.to_owned(), ..ObjMaterial::default() }));
            } else if let Some(material) = &mut material {
                let goodwill = material.read(keyword, rest, folder).map_err(|error| error.at_line(line))?;
                odd = odd.or(goodwill.then_some((line, keyword, rest)));
            }
        }
        self.finish(material);
        if let Some((line, keyword, rest)) = odd {
            let statement = format!("{keyword} {}", shortened(rest));
            let read = "characters after a number are ignored";
            self.remarks.push(format!("{}:{line}: \"{statement}\": {read}", file.display()));
        }
        Ok(())
    }

    fn finish(&mut self, material: Option<ObjMaterial>) {
        let Some(material) = material else { return };
        let plain = without_comment(&material.name).to_owned();
        if plain != material.name {
            self.materials.entry(plain).or_insert_with(|| material.clone());
        }
        self.names.push(material.name.clone());
        self.materials.entry(material.name.clone()).or_insert(material);
    }

    /// The material of a name; `None` for what exporters write where there is none.
    fn find(&self, mention: &Mention) -> Result<Option<ObjMaterial>> {
        let name = mention.name.as_str();
        let plain = without_comment(name);
        if let Some(material) = self.materials.get(name).or_else(|| self.materials.get(plain)) {
            return Ok(Some(material.clone()));
        }
        if matches!(plain.to_ascii_lowercase().as_str(), "" | "none" | "(null)") {
            return Ok(None);
        }
        if let Some(missing) = &self.missing {
            return Err(missing.clone());
        }
        let known = match &self.names[..] {
            [] => "a `mtllib` line for a file with this material".to_owned(),
            names => format!("one of {}", listed(names)),
        };
        Err(Error::new(format!("no material \"{}\"", shortened(name))).at_line(mention.line).expected(known).help(HELP))
    }
}

/// The path of a file named in an MTL file: relative to its folder, with the separators of any system. Exporters write the
/// paths of their own disk: if that file does not exist, a file of the same name in the folder replaces it (then true).
fn beside(folder: &Path, name: &str) -> (PathBuf, bool) {
    let name = name.trim_matches('"');
    let as_written = folder.join(name);
    if as_written.is_file() {
        return (as_written, false);
    }
    let with_slashes = folder.join(name.replace('\\', "/"));
    let here = with_slashes.file_name().map(|name| folder.join(name));
    match here.filter(|here| !with_slashes.is_file() && here.is_file()) {
        Some(here) => (here, true),
        None => (with_slashes, false),
    }
}

impl ObjMaterial {
    /// Reads a statement; true if that took goodwill.
    fn read(&mut self, keyword: &str, rest: &str, folder: &Path) -> Result<bool> {
        let refused = |expected: &str| {
            Error::new(format!("found \"{keyword} {}\"", shortened(rest))).expected(expected.to_owned())
        };
        let mut goodwill = false;
        let mut read = |word: &str| {
            let (value, odd) = number(word).filter(|(value, _)| (*value as f32).is_finite())?;
            goodwill |= odd;
            Some(value as f32)
        };
        let mut colour = |material: &mut Self| -> Result<Option<Vec3>> {
            let values: Vec<&str> = words(rest).collect();
            // Given as a curve, or in another colour space.
            if matches!(values.first(), Some(&("spectral" | "xyz"))) {
                material.unread.insert(format!("{keyword} {}", values[0]));
                return Ok(None);
            }
            let values: Option<Vec<f32>> = values.into_iter().take(3).map(&mut read).collect();
            match values.as_deref() {
                Some(&[grey]) => Ok(Some(Vec3::splat(grey))),
                Some(&[red, green, blue]) => Ok(Some(Vec3::new(red, green, blue))),
                _ => Err(refused("three numbers")),
            }
        };
        match keyword.to_ascii_lowercase().as_str() {
            "kd" => self.diffuse = colour(self)?.or(self.diffuse),
            "ks" => self.specular = colour(self)?.or(self.specular),
            "ke" => self.emission = colour(self)?.or(self.emission),
            "map_kd" => self.diffuse_map = Some(self.read_map(rest, folder)?),
            "d" if words(rest).next() == Some("-halo") => drop(self.unread.insert("d -halo".to_owned())),
            key @ ("ns" | "ni" | "d" | "tr" | "pr" | "pm" | "illum") => {
                let value = words(rest).next().and_then(&mut read).ok_or_else(|| refused("a number"))?;
                match key {
                    "ns" => self.shininess = Some(value),
                    "ni" => self.index_of_refraction = Some(value),
                    "d" => self.dissolve = Some(value),
                    // `d` says the same the other way round, and is what more programs agree on.
                    "tr" => self.dissolve = self.dissolve.or(Some(1.0 - value)),
                    "pr" => self.roughness = Some(value),
                    "pm" => self.metalness = Some(value),
                    _ => self.illumination = Some(value as u8),
                }
            }
            key => {
                let values: Vec<_> = words(rest).map(number).collect();
                let all = |neutral: f64| values.iter().all(|value| value.is_some_and(|(value, _)| value == neutral));
                if !all(if key == "tf" { 1.0 } else { 0.0 }) {
                    self.unread.insert(keyword.to_owned());
                }
            }
        }
        Ok(goodwill)
    }

    /// A picture's name behind its options; those that are ignored are noted.
    fn read_map(&mut self, rest: &str, folder: &Path) -> Result<ObjMap> {
        let mut repeat = [1.0, 1.0];
        let mut left = rest.trim_ascii();
        while let Some(option) = words(left).next().filter(|word| word.starts_with('-')) {
            left = left[option.len()..].trim_ascii_start();
            let most = match option {
                "-s" | "-o" | "-t" => 3,
                "-mm" => 2,
                "-blendu" | "-blendv" | "-boost" | "-texres" | "-clamp" | "-bm" | "-imfchan" | "-type" | "-cc" => 1,
                _ => {
                    return Err(Error::new(format!("found \"map_Kd {}\"", shortened(rest)))
                        .expected("a file name after options of the format")
                        .help("remove the options from the line"));
                }
            };
            let is_number = |word: &str| number(word).is_some();
            let values: Vec<&str> = words(left).take(most).take_while(|word| most == 1 || is_number(word)).collect();
            for value in &values {
                left = left[value.len()..].trim_ascii_start();
            }
            let numbers: Vec<f64> = values.iter().filter_map(|word| Some(number(word)?.0)).collect();
            match (option, numbers.as_slice()) {
                ("-s", &[u]) => repeat = [u, 1.0],
                ("-s", &[u, v, ..]) => repeat = [u, v],
                _ => drop(self.unread.insert(format!("map_Kd {option}"))),
            }
        }
        if left.is_empty() {
            return Err(Error::new("`map_Kd` without a name").expected("the name of a picture"));
        }
        let whole = beside(folder, left);
        let (file, moved) = if whole.0.is_file() { whole } else { beside(folder, without_comment(left)) };
        if moved {
            self.unread.insert("the folder of map_Kd".to_owned());
        }
        Ok(ObjMap { file, repeat })
    }
}
