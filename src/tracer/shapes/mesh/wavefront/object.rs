//! An OBJ file as one mesh.

use std::collections::{BTreeMap, HashMap};
use std::num::IntErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use skycube_files::guarded;

use super::materials::ObjMaterials;
use super::polygon::Triangulation;
use super::statements::{Mention, number, read_text, shortened, statements, words};
use crate::colour::decode_srgb;
use crate::error::{Error, Result};
use crate::math::{Bounds, DVec3, Vec2, Vec3};
use crate::shapes::mesh::{Mesh, MeshGeometry};

/// What an OBJ file holds: one mesh of all its objects.
///
/// Missing normals stay missing (flat faces). Texture coordinates are the file's: `v = 0` at the bottom of the picture.
/// Points and lines are not drawn. Materials are read on demand.
#[derive(Debug, Clone)]
pub struct ObjFile {
    /// All triangles of the file.
    pub mesh: Arc<Mesh>,
    /// Where the mesh's origin lies in the file's coordinates. Vertices far from the origin, as on a map of a country, are
    /// moved to their own middle before they are rounded to single precision; others stay where they are.
    pub centre: DVec3,
    /// The material of each material group of the mesh, `None` for the faces before any `usemtl`.
    pub groups: Vec<Option<Mention>>,
    /// The MTL files, in the order in which they are named.
    pub libraries: Vec<Mention>,
    /// What of the file was read with goodwill or left out.
    pub remarks: Vec<String>,
    /// How many vertices of a file with colours have none: they are white.
    pub uncoloured: usize,
    path: PathBuf,
}

impl ObjFile {
    /// Reads an OBJ file. An error names the file and the line.
    pub fn read(path: impl AsRef<Path>) -> Result<Self> {
        Self::read_by(path.as_ref(), Self::parse)
    }

    fn read_by(path: &Path, parse: impl FnOnce(&Path) -> Result<Self>) -> Result<Self> {
        guarded(NOT_READ, || parse(path)).map_err(|error| error.in_file(path))
    }

    fn parse(path: &Path) -> Result<Self> {
        let text = read_text(path, "an OBJ file")?;
        let mut reader = Reader::default();
        let mut triangulation = Triangulation::new();
        for (line, keyword, rest) in statements(&text) {
            reader.read(line, keyword, rest, &mut triangulation).map_err(|error| error.at_line(line))?;
        }
        drop(text);
        reader.complete_colours();
        let (geometry, centre) = reader.geometry();
        Ok(Self {
            mesh: Arc::new(Mesh::new(geometry)?),
            centre,
            remarks: reader.remarks(),
            uncoloured: reader.colours.iter().filter(|colour| colour.is_none()).count(),
            groups: reader.groups,
            libraries: reader.libraries,
            path: path.to_owned(),
        })
    }

    /// Reads the MTL files.
    ///
    /// An error names the file and the line: an MTL file that is missing or cannot be read, a material that none of them
    /// describes.
    pub fn materials(&self) -> Result<ObjMaterials> {
        guarded(NOT_READ, || ObjMaterials::read(&self.groups, &self.libraries, &self.path))
            .map_err(|error| error.in_file(&self.path))
    }
}

/// What to do with a file at which a part of the reader fails.
const NOT_READ: &str = "save it again with another program, or download it again";

/// A corner of a face: the numbers of its position, texture coordinates and normal, from 0.
type Corner = [u32; 3];

/// Differences of two coordinates and products of three of those must stay finite in double precision.
const LARGEST_COORDINATE: f64 = 1e30;

/// In a corner: not given. As a vertex: none yet.
const NONE: u32 = u32::MAX;

/// What the statements so far have defined.
#[derive(Default)]
struct Reader {
    positions: Vec<DVec3>,
    /// As the file has them, for each position; empty until the first.
    colours: Vec<Option<Vec3>>,
    texture_coordinates: Vec<Vec2>,
    normals: Vec<Vec3>,
    /// Every corner once.
    vertices: Vec<Corner>,
    /// For each position the vertex that was asked for last; most positions have one only.
    latest: Vec<u32>,
    /// The vertices of positions that have several.
    others: HashMap<Corner, u32>,
    triangles: Vec<[u32; 3]>,
    materials: Vec<u32>,
    groups: Vec<Option<Mention>>,
    numbers_of_groups: HashMap<Option<String>, u32>,
    /// The material that was named last, and the number of its group once it has a face.
    material: Option<Mention>,
    group: Option<u32>,
    libraries: Vec<Mention>,
    /// What was read with goodwill or left out: how often, and the first line.
    oddities: BTreeMap<&'static str, (usize, usize)>,
    /// The corners of the current face.
    corners: Vec<Corner>,
}

impl Reader {
    fn read(&mut self, line: usize, keyword: &str, rest: &str, cut: &mut Triangulation) -> Result<()> {
        match keyword {
            "v" => self.read_position(line, rest),
            "vt" => {
                let [u, v] = self.read_numbers(line, rest, 1)?.0;
                let uv = Vec2::new(u as f32, v as f32);
                let uv = self.finite_or(line, uv, uv.is_finite(), Vec2::ZERO);
                self.texture_coordinates.push(uv);
                Ok(())
            }
            "vn" => {
                let ([x, y, z], _) = self.read_numbers(line, rest, 3)?;
                let normal = DVec3::new(x, y, z).as_vec3();
                let normal = self.finite_or(line, normal, normal.is_finite(), Vec3::ZERO);
                self.normals.push(normal);
                Ok(())
            }
            "f" | "fo" => self.read_face(rest, cut),
            "usemtl" => {
                self.material = Some(Mention { name: rest.to_owned(), line });
                self.group = None;
                Ok(())
            }
            "mtllib" => {
                self.libraries.push(Mention { name: rest.to_owned(), line });
                Ok(())
            }
            "l" | "p" => self.odd(line, "points and lines are not drawn"),
            "curv" | "curv2" | "surf" => self.odd(line, "free-form curves and surfaces are not drawn"),
            _ => Ok(()),
        }
    }

    fn odd(&mut self, line: usize, what: &'static str) -> Result<()> {
        self.oddities.entry(what).or_insert((0, line)).0 += 1;
        Ok(())
    }

    fn remarks(&self) -> Vec<String> {
        let remark = |(what, (count, line)): (&&str, &(usize, usize))| match count {
            1 => format!("{what} (line {line})"),
            _ => format!("{what} ({count} times, first in line {line})"),
        };
        self.oddities.iter().map(remark).collect()
    }

    /// At least `needed` numbers, and how many there are; missing ones are 0.
    fn read_numbers<const MOST: usize>(
        &mut self,
        line: usize,
        rest: &str,
        needed: usize,
    ) -> Result<([f64; MOST], usize)> {
        let mut numbers = [0.0; MOST];
        let mut count = 0;
        let refused = || {
            let wanted = if needed == 1 { "a number".to_owned() } else { format!("{needed} finite numbers") };
            Error::new(format!("found \"{}\"", shortened(rest))).expected(wanted)
        };
        for word in words(rest) {
            let (value, odd) = number(word).ok_or_else(refused)?;
            if odd {
                self.odd(line, "characters after a number are ignored")?;
            }
            if count < MOST {
                numbers[count] = value;
            }
            count += 1;
        }
        if count < needed { Err(refused()) } else { Ok((numbers, count)) }
    }

    /// Exporters write normals of faces without area as NaN.
    fn finite_or<T>(&mut self, line: usize, value: T, finite: bool, otherwise: T) -> T {
        if finite {
            return value;
        }
        let _ = self.odd(line, "a normal, texture coordinate or colour that is not finite counts as missing");
        otherwise
    }

    /// `v x y z`, `v x y z w` (homogeneous) or `v x y z r g b`.
    fn read_position(&mut self, line: usize, rest: &str) -> Result<()> {
        let (numbers, count) = self.read_numbers::<6>(line, rest, 3)?;
        let [x, y, z, w, ..] = numbers;
        let mut position = DVec3::new(x, y, z);
        if count == 4 && w != 1.0 {
            position /= w;
            self.odd(line, "homogeneous coordinates x y z w are divided by w")?;
        }
        if count >= 6 {
            let colour = DVec3::from_slice(&numbers[3..]).as_vec3();
            let colour = self.finite_or(line, Some(colour), colour.is_finite(), None);
            self.colours.resize(self.positions.len(), None);
            self.colours.push(colour);
        }
        if position.is_nan() || position.abs().max_element() > LARGEST_COORDINATE {
            return Err(Error::new(format!("found \"{}\"", shortened(rest)))
                .expected(format!("3 finite numbers of at most {LARGEST_COORDINATE:e}")));
        }
        self.positions.push(position);
        self.latest.push(NONE);
        Ok(())
    }

    fn read_face(&mut self, rest: &str, cut: &mut Triangulation) -> Result<()> {
        self.corners.clear();
        for word in words(rest) {
            let corner = self.corner(word)?;
            self.corners.push(corner);
        }
        let [first, _, _, ..] = self.corners[..] else {
            return Err(Error::new(format!("a face of {} corners", self.corners.len())).expected("at least three"));
        };
        let parts = |corner: Corner| corner.map(|part| part == NONE);
        if self.corners.iter().any(|&corner| parts(corner) != parts(first)) {
            return Err(Error::new(format!("found \"f {}\"", shortened(rest)))
                .expected("the same parts at all corners of the face"));
        }
        let vertices: Vec<u32> = (0..self.corners.len()).map(|corner| self.vertex(self.corners[corner])).collect();
        match vertices[..] {
            [a, b, c] => self.triangles.push([a, b, c]),
            _ => {
                let position = |corner: &Corner| self.positions[corner[0] as usize];
                let positions: Vec<DVec3> = self.corners.iter().map(position).collect();
                let triangles = cut.triangles(&positions);
                self.triangles.extend(triangles.map(|triangle| triangle.map(|corner| vertices[corner as usize])));
            }
        }
        let group = self.group();
        self.materials.resize(self.triangles.len(), group);
        Ok(())
    }

    /// The number of the group that faces belong to now.
    fn group(&mut self) -> u32 {
        *self.group.get_or_insert_with(|| {
            let name = self.material.as_ref().map(|material| material.name.clone());
            *self.numbers_of_groups.entry(name).or_insert_with(|| {
                self.groups.push(self.material.clone());
                self.groups.len() as u32 - 1
            })
        })
    }

    /// The vertex of a corner: the one that has it already, or a new one.
    fn vertex(&mut self, corner: Corner) -> u32 {
        let latest = &mut self.latest[corner[0] as usize];
        let number = self.vertices.len() as u32;
        let vertex = match *latest {
            NONE => number,
            known if self.vertices[known as usize] == corner => known,
            other => {
                self.others.insert(self.vertices[other as usize], other);
                *self.others.entry(corner).or_insert(number)
            }
        };
        if vertex == number {
            self.vertices.push(corner);
        }
        *latest = vertex;
        vertex
    }

    /// A corner as `v`, `v/vt`, `v//vn` or `v/vt/vn`, each counted from 1, or from the end if negative.
    fn corner(&self, word: &str) -> Result<Corner> {
        const NAMES: [&str; 3] = ["vertex", "texture coordinate", "normal"];
        let malformed =
            || Error::new(format!("found the corner \"{}\"", shortened(word))).expected("v, v/vt, v//vn or v/vt/vn");
        let counts = [self.positions.len(), self.texture_coordinates.len(), self.normals.len()];
        let mut corner = [NONE; 3];
        for (kind, part) in word.split('/').enumerate() {
            if kind > 2 || (kind == 0 && part.is_empty()) {
                return Err(malformed());
            }
            if part.is_empty() {
                continue;
            }
            let index = whole_number(part).ok_or_else(malformed)?;
            corner[kind] = resolved(index, counts[kind]).ok_or_else(|| {
                let problem = format!("the corner \"{}\" has {} {index}", shortened(word), NAMES[kind]);
                Error::new(problem).expected(range(counts[kind]))
            })?;
        }
        Ok(corner)
    }

    /// All vertices of a file have a colour, or none has.
    fn complete_colours(&mut self) {
        if !self.colours.is_empty() {
            self.colours.resize(self.positions.len(), None);
        }
    }

    /// The colours of the vertices in linear light. Files hold codes of sRGB, over 255 or, from some exporters, not.
    fn linear_colours(&self) -> Vec<Vec3> {
        if self.colours.is_empty() {
            return Vec::new();
        }
        let brightest = self.colours.iter().flatten().map(|colour| colour.max_element()).fold(0.0, f32::max);
        let white = if brightest > 1.0 { 255.0 } else { 1.0 };
        let linear = |code: f32| decode_srgb(f64::from((code / white).clamp(0.0, 1.0))) as f32;
        let colour = |vertex: &Corner| self.colours[vertex[0] as usize].unwrap_or(Vec3::splat(white)).to_array();
        self.vertices.iter().map(|vertex| Vec3::from(colour(vertex).map(linear))).collect()
    }

    /// The mesh, and where its origin lies in the file's coordinates.
    fn geometry(&mut self) -> (MeshGeometry, DVec3) {
        let position = |vertex: &Corner| self.positions[vertex[0] as usize];
        let centre = centre(Bounds::around(self.vertices.iter().map(position)));
        let geometry = MeshGeometry {
            positions: self.vertices.iter().map(|vertex| (position(vertex) - centre).as_vec3()).collect(),
            texture_coordinates: attribute(&self.vertices, 1, &self.texture_coordinates),
            normals: attribute(&self.vertices, 2, &self.normals),
            colours: self.linear_colours(),
            triangles: std::mem::take(&mut self.triangles),
            materials: std::mem::take(&mut self.materials),
        };
        (geometry, centre)
    }
}

/// A whole number; beyond 64 bits the largest or smallest.
fn whole_number(text: &str) -> Option<i64> {
    text.parse().map_or_else(
        |error: std::num::ParseIntError| match error.kind() {
            IntErrorKind::PosOverflow => Some(i64::MAX),
            IntErrorKind::NegOverflow => Some(i64::MIN),
            _ => None,
        },
        Some,
    )
}

/// The number from 0 that an index stands for.
fn resolved(index: i64, count: usize) -> Option<u32> {
    let place = if index > 0 { index - 1 } else { (count as i64).checked_add(index)? };
    (index != 0 && (0..count as i64).contains(&place)).then_some(place as u32)
}

fn range(count: usize) -> String {
    match count {
        0 => "none: no line of this kind comes before it".to_owned(),
        _ => format!("1 to {count}, or -1 to -{count}: {count} are defined before this line"),
    }
}

/// An attribute of all vertices, zero where it is not given; empty if no vertex has it.
fn attribute<T: Copy + Default>(vertices: &[Corner], kind: usize, values: &[T]) -> Vec<T> {
    if vertices.iter().all(|vertex| vertex[kind] == NONE) {
        return Vec::new();
    }
    vertices.iter().map(|vertex| values.get(vertex[kind] as usize).copied().unwrap_or_default()).collect()
}

/// The middle of a mesh that lies far from the origin for its size; the origin for others.
fn centre(bounds: Bounds) -> DVec3 {
    const FAR: f64 = 8.0;
    let middle = (bounds.minimum + bounds.maximum) / 2.0;
    let far = middle.is_finite() && middle.abs().max_element() > FAR * bounds.extent().max_element();
    if far { middle } else { DVec3::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_at_which_the_reader_fails_is_named() {
        let error = ObjFile::read_by(Path::new("a.obj"), |_| panic!("a polygon that nobody thought of")).unwrap_err();
        assert!(error.to_string().starts_with("a.obj: this file cannot be decoded"), "{error}");
    }
}
