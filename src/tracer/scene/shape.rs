//! The tables `[[shapes]]`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use skycube_files::document::{Table, Value};

use super::material::TextureStore;
use super::mesh_materials::{Conversion, MtlColours};
use crate::error::{Error, Result};
use crate::materials::Material;
use crate::math::{DAffine3, DMat3, DVec3, Transform};
use crate::shapes::mesh::ObjFile;
use crate::shapes::{Geometry, MaterialChoice, Outline, Primitive};

/// Reads shapes; remembers materials and meshes, so that each file is read once and instances share a mesh.
pub(super) struct ShapeReader<'a> {
    pub materials: Vec<Material>,
    pub textures: &'a mut TextureStore,
    /// How the colours of MTL files are meant where a shape does not say it.
    pub mtl_colours: MtlColours,
    /// What a user should know of the files.
    pub notes: Vec<String>,
    /// Meshes and their MTL files.
    pub files: Vec<PathBuf>,
    meshes: BTreeMap<PathBuf, ObjFile>,
    /// The scene's numbers of the materials of a mesh file.
    mesh_materials: BTreeMap<(PathBuf, MtlColours), Arc<[u32]>>,
    material_names: BTreeMap<String, u32>,
    /// The meshes of the scene and what they are made of.
    shown: Vec<(PathBuf, MaterialChoice)>,
}

impl<'a> ShapeReader<'a> {
    pub(super) fn new(textures: &'a mut TextureStore, mtl_colours: MtlColours) -> Self {
        Self {
            materials: Vec::new(),
            textures,
            mtl_colours,
            notes: Vec::new(),
            files: Vec::new(),
            meshes: BTreeMap::new(),
            mesh_materials: BTreeMap::new(),
            material_names: BTreeMap::new(),
            shown: Vec::new(),
        }
    }

    /// Makes a material known under its name; what it is follows once all shapes are read.
    pub(super) fn add_material(&mut self, name: String) {
        self.material_names.insert(name, self.materials.len() as u32);
        self.materials.push(Material::Normals);
    }

    /// The name of each material, in the order of their numbers.
    pub(super) fn names_of_materials(&self) -> Vec<String> {
        let mut names = vec!["of the mesh file".to_owned(); self.materials.len()];
        self.material_names.iter().for_each(|(name, &number)| names[number as usize].clone_from(name));
        names
    }

    /// Reads one shape.
    pub(super) fn read(&mut self, mut table: Table) -> Result<Primitive> {
        #[derive(Clone, Copy, clap::ValueEnum)]
        enum Kind {
            Sphere,
            Plane,
            Disc,
            Rectangle,
            #[value(name = "box")]
            Cuboid,
            Mesh,
        }
        let kind: Kind = table.required("kind")?.choice()?;
        let mut mesh_file = None;
        let (geometry, canonical) = match kind {
            Kind::Sphere => (Geometry::Sphere, read_sphere(&mut table)?),
            Kind::Plane => (Geometry::Flat(Outline::Plane), read_plane(&mut table)?),
            Kind::Disc => (Geometry::Flat(Outline::Disc), read_disc(&mut table)?),
            Kind::Rectangle => (Geometry::Flat(Outline::Rectangle), read_rectangle(&mut table)?),
            Kind::Cuboid => (Geometry::Cuboid, read_cuboid(&mut table)?),
            Kind::Mesh => {
                let file = table.required("file")?;
                let object = self.read_mesh(&file)?;
                let placed = (Geometry::Mesh(Arc::clone(&object.mesh)), DAffine3::from_translation(object.centre));
                mesh_file = Some(file);
                placed
            }
        };
        let placed = read_transform(&mut table)?;
        let transform = Transform::from_affine(placed * canonical).ok_or_else(|| {
            table.error("the shape is flat or empty in one direction").expected("sizes and scales that are not zero")
        })?;
        let material = match (table.optional("material"), &mesh_file) {
            (Some(name), _) => self.named_material(&name)?,
            (None, Some(file)) => self.mesh_materials(&mut table, file)?,
            (None, None) => return Err(table.required("material").err().expect("the key was just found missing")),
        };
        let casts_shadow = table.optional("casts_shadow").map_or(Ok(true), |value| value.boolean())?;
        table.finish()?;
        if let Some(file) = mesh_file {
            self.shown.push((file.path()?, material.clone()));
        }
        Ok(Primitive::new(geometry, transform, material, casts_shadow))
    }

    fn named_material(&self, name: &Value) -> Result<MaterialChoice> {
        let text = name.text()?;
        let number = self.material_names.get(text).ok_or_else(|| {
            let known: Vec<&str> = self.material_names.keys().map(String::as_str).collect();
            name.error(format!("there is no material \"{text}\"")).expected(match known.as_slice() {
                [] => "a [materials.NAME] table in the scene".to_owned(),
                known => format!("one of {}", known.join(", ")),
            })
        })?;
        Ok(MaterialChoice::Whole(*number))
    }

    fn read_mesh(&mut self, file: &Value) -> Result<&ObjFile> {
        let path = file.path()?;
        if !self.meshes.contains_key(&path) {
            let object = ObjFile::read(&path).map_err(|error| file.error(error.to_string()))?;
            self.notes.extend(object.remarks.iter().map(|remark| format!("{}: {remark}", path.display())));
            self.files.push(path.clone());
            self.meshes.insert(path.clone(), object);
        }
        Ok(&self.meshes[&path])
    }

    /// The materials of a mesh file's own. Faces without one are white; if all are, the choice is left to the scene.
    fn mesh_materials(&mut self, table: &mut Table, file: &Value) -> Result<MaterialChoice> {
        let path = file.path()?;
        let colours = table.optional("mtl_colours").map_or(Ok(self.mtl_colours), |value| value.choice())?;
        if let Some(numbers) = self.mesh_materials.get(&(path.clone(), colours)) {
            return Ok(MaterialChoice::PerGroup(Arc::clone(numbers)));
        }
        let within = |error: Error| file.error(error.to_string());
        let described = self.meshes[&path].materials().map_err(within)?;
        if described.groups.iter().all(Option::is_none) {
            return Err(table.required("material").err().expect("the key was just found missing"));
        }
        let mut conversion = Conversion::new(self.textures, colours);
        let mut numbers = Vec::new();
        for group in &described.groups {
            numbers.push(self.materials.len() as u32);
            self.materials.push(conversion.material(&group.clone().unwrap_or_default()).map_err(within)?);
        }
        let notes = described.remarks.into_iter().chain(conversion.note());
        self.notes.extend(notes.map(|note| format!("{}: {note}", path.display())));
        self.files.extend(described.files);
        let numbers: Arc<[u32]> = numbers.into();
        self.mesh_materials.insert((path, colours), Arc::clone(&numbers));
        Ok(MaterialChoice::PerGroup(numbers))
    }

    /// Notes on colours of vertices: that nothing shows them, or that some vertices have none.
    pub(super) fn check_vertex_colours(&mut self) {
        let mut notes = BTreeSet::new();
        for (path, object) in self.meshes.iter().filter(|(_, object)| !object.mesh.geometry().colours.is_empty()) {
            let mut numbers =
                self.shown.iter().filter(|(shown, _)| shown == path).flat_map(|(_, choice)| choice.numbers());
            let used = numbers.any(|&number| self.materials[number as usize].needs_vertex_colours());
            let name = path.display();
            match object.uncoloured {
                _ if !used => notes.insert(format!("{name}: the colours of its vertices are not used")),
                0 => false,
                count => notes.insert(format!("{name}: {count} of its vertices have no colour: white")),
            };
        }
        self.notes.extend(notes);
    }

    /// Notes on glass whose inside cannot be told from its outside.
    pub(super) fn check_glass(&mut self) {
        let mut notes = BTreeSet::new();
        for (path, material) in &self.shown {
            let numbers = material.numbers();
            let is_glass =
                |group: u32| self.materials[numbers[(group as usize).min(numbers.len() - 1)] as usize].transmits();
            if (0..numbers.len() as u32).any(is_glass)
                && let Some(problem) = self.meshes[path].mesh.geometry().outside_of(is_glass).problem()
            {
                notes.insert(format!("{}: glass on a mesh {problem}", path.display()));
            }
        }
        self.notes.extend(notes);
    }
}

fn read_sphere(table: &mut Table) -> Result<DAffine3> {
    let centre = table.optional("centre").map_or(Ok(DVec3::ZERO), |value| value.vector())?;
    let radius = length(table.optional("radius"), 1.0)?;
    Ok(DAffine3::from_mat3_translation(DMat3::from_diagonal(DVec3::splat(radius)), centre))
}

fn read_plane(table: &mut Table) -> Result<DAffine3> {
    let point = table.optional("point").map_or(Ok(DVec3::ZERO), |value| value.vector())?;
    Ok(DAffine3::from_mat3_translation(frame(normal(table)?), point))
}

fn read_disc(table: &mut Table) -> Result<DAffine3> {
    let centre = table.optional("centre").map_or(Ok(DVec3::ZERO), |value| value.vector())?;
    let radius = length(table.optional("radius"), 1.0)?;
    let scale = DMat3::from_diagonal(DVec3::new(radius, radius, 1.0));
    Ok(DAffine3::from_mat3_translation(frame(normal(table)?) * scale, centre))
}

fn read_rectangle(table: &mut Table) -> Result<DAffine3> {
    let centre = table.optional("centre").map_or(Ok(DVec3::ZERO), |value| value.vector())?;
    let [width, height] = match table.optional("size") {
        Some(size) => {
            let sides = size.numbers::<2>("[width, height]")?;
            if sides.iter().any(|&side| side <= 0.0) {
                return Err(size.error("a side is not positive").expected("[width, height], both more than 0"));
            }
            sides
        }
        None => [1.0, 1.0],
    };
    let scale = DMat3::from_diagonal(DVec3::new(width / 2.0, height / 2.0, 1.0));
    Ok(DAffine3::from_mat3_translation(frame(normal(table)?) * scale, centre))
}

fn read_cuboid(table: &mut Table) -> Result<DAffine3> {
    let minimum = table.optional("minimum").map_or(Ok(DVec3::splat(-0.5)), |value| value.vector())?;
    let maximum = table.optional("maximum").map_or(Ok(DVec3::splat(0.5)), |value| value.vector())?;
    if (maximum - minimum).min_element() <= 0.0 {
        return Err(table.error("the box is empty").expected("every component of maximum above that of minimum"));
    }
    let half = (maximum - minimum) / 2.0;
    Ok(DAffine3::from_mat3_translation(DMat3::from_diagonal(half), (minimum + maximum) / 2.0))
}

/// `scale`, `rotate` (degrees about x, then y, then z) and `translate`, applied in this order.
fn read_transform(table: &mut Table) -> Result<DAffine3> {
    let translate = table.optional("translate").map_or(Ok(DVec3::ZERO), |value| value.vector())?;
    let rotate = table.optional("rotate").map_or(Ok(DVec3::ZERO), |value| value.vector())?;
    let scale = match table.optional("scale") {
        Some(value) if value.is_list() => value.vector()?,
        Some(value) => DVec3::splat(value.number()?),
        None => DVec3::ONE,
    };
    Transform::from_parts(translate, rotate, scale)
        .map(|transform| transform.to_world)
        .ok_or_else(|| table.error("a scale is zero").expected("scales that are not zero"))
}

fn normal(table: &mut Table) -> Result<DVec3> {
    match table.optional("normal") {
        Some(value) => value.vector()?.try_normalize().ok_or_else(|| value.error("a normal must not be zero")),
        None => Ok(DVec3::Z),
    }
}

fn length(value: Option<Value>, otherwise: f64) -> Result<f64> {
    value.map_or(Ok(otherwise), |value| value.number_where("a number more than 0", |number| number > 0.0))
}

/// A right-handed frame whose z axis is the normal. For +z it is the world's own, for other normals the x axis is
/// horizontal in a z-up world.
fn frame(normal: DVec3) -> DMat3 {
    let x_axis = DVec3::Z.cross(normal).try_normalize().unwrap_or(DVec3::X);
    DMat3::from_cols(x_axis, normal.cross(x_axis), normal)
}
