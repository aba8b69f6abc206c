//! The tables `[[shapes]]`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use skycube_files::document::{Table, Value};

use super::material::TextureStore;
use crate::error::Result;
use crate::materials::{ColourSource, ImageTexture, Material};
use crate::math::{DAffine3, DMat3, DVec2, DVec3, Transform, Vec3};
use crate::picture::Filter;
use crate::shapes::mesh::{Mesh, ObjFile, ObjMaterial};
use crate::shapes::{Geometry, MaterialChoice, Outline, Primitive};

/// Reads shapes; remembers materials and meshes, so that each file is read once and instances share a mesh.
pub(super) struct ShapeReader<'a> {
    pub materials: Vec<Material>,
    pub meshes: BTreeMap<PathBuf, LoadedMesh>,
    pub textures: &'a mut TextureStore,
    material_names: BTreeMap<String, u32>,
}

/// A mesh and the scene's numbers of its own materials.
#[derive(Clone)]
pub(super) struct LoadedMesh {
    mesh: Arc<Mesh>,
    /// `None` if the file has no materials of its own.
    materials: Option<Arc<[u32]>>,
}

impl<'a> ShapeReader<'a> {
    pub(super) fn new(textures: &'a mut TextureStore) -> Self {
        Self { materials: Vec::new(), meshes: BTreeMap::new(), textures, material_names: BTreeMap::new() }
    }

    /// Makes a material known under its name.
    pub(super) fn add_material(&mut self, name: String, material: Material) {
        self.material_names.insert(name, self.materials.len() as u32);
        self.materials.push(material);
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
        let mut own_materials = None;
        let (geometry, canonical) = match kind {
            Kind::Sphere => (Geometry::Sphere, read_sphere(&mut table)?),
            Kind::Plane => (Geometry::Flat(Outline::Plane), read_plane(&mut table)?),
            Kind::Disc => (Geometry::Flat(Outline::Disc), read_disc(&mut table)?),
            Kind::Rectangle => (Geometry::Flat(Outline::Rectangle), read_rectangle(&mut table)?),
            Kind::Cuboid => (Geometry::Cuboid, read_cuboid(&mut table)?),
            Kind::Mesh => {
                let loaded = self.read_mesh(&mut table)?;
                own_materials = loaded.materials;
                (Geometry::Mesh(loaded.mesh), DAffine3::IDENTITY)
            }
        };
        let placed = read_transform(&mut table)?;
        let transform = Transform::from_affine(placed * canonical).ok_or_else(|| {
            table.error("the shape has no extent in some direction").expected("sizes and scales that are not zero")
        })?;
        let material = self.read_material(&mut table, own_materials)?;
        let casts_shadow = table.optional("casts_shadow").map_or(Ok(true), |value| value.boolean())?;
        table.finish()?;
        Ok(Primitive::new(geometry, transform, material, casts_shadow))
    }

    fn read_material(&self, table: &mut Table, own: Option<Arc<[u32]>>) -> Result<MaterialChoice> {
        match (table.optional("material"), own) {
            (None, Some(own)) => Ok(MaterialChoice::PerGroup(own)),
            (None, None) => Err(table.required("material").err().expect("the key was just found missing")),
            (Some(name), _) => {
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
        }
    }

    fn read_mesh(&mut self, table: &mut Table) -> Result<LoadedMesh> {
        let file = table.required("file")?;
        let path = file.path()?;
        if let Some(loaded) = self.meshes.get(&path) {
            return Ok(loaded.clone());
        }
        let loaded = self.load_mesh(&path).map_err(|error| file.error(error.to_string()))?;
        self.meshes.insert(path, loaded.clone());
        Ok(loaded)
    }

    fn load_mesh(&mut self, path: &Path) -> Result<LoadedMesh> {
        let object = ObjFile::read(path)?;
        // Faces without a material leave the choice to the scene.
        let described: Option<Vec<ObjMaterial>> = object.groups.into_iter().collect();
        let mut numbers = Vec::new();
        for described in described.iter().flatten() {
            numbers.push(self.materials.len() as u32);
            let material = self.convert(described)?;
            self.materials.push(material);
        }
        let materials = described.map(|_| Arc::from(numbers));
        Ok(LoadedMesh { mesh: Arc::new(object.mesh), materials })
    }

    /// A material of an MTL file: glass where `illum` is 4, 6, 7 or 9, a mirror for 3, 5 and 8, otherwise Phong if it
    /// has a highlight, or else Lambert. A missing colour is white, as in the format's description.
    fn convert(&mut self, described: &ObjMaterial) -> Result<Material> {
        let specular = described.specular.unwrap_or(Vec3::ZERO);
        match described.illumination {
            Some(4 | 6 | 7 | 9) => {
                let index = described.index_of_refraction.map_or(1.5, |index| f64::from(index).clamp(0.1, 100.0));
                return Ok(Material::Glass { index, absorption: Vec3::ZERO, rough: None });
            }
            Some(3 | 5 | 8) => {
                let colour = ColourSource::Uniform(described.specular.unwrap_or(Vec3::ONE));
                return Ok(Material::Mirror { colour });
            }
            _ => {}
        }
        let diffuse = match &described.diffuse_map {
            Some(path) => ColourSource::Image(ImageTexture {
                texture: self.textures.load(path.clone(), Filter::Bilinear)?,
                repeat: DVec2::ONE,
            }),
            None => ColourSource::Uniform(described.diffuse.unwrap_or(Vec3::ONE)),
        };
        if specular == Vec3::ZERO || described.illumination == Some(1) {
            return Ok(Material::Lambert { colour: diffuse });
        }
        Ok(Material::Phong { diffuse, specular, exponent: described.shininess.unwrap_or(32.0) })
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
        Some(value) => value.vector()?.try_normalize().ok_or_else(|| value.error("a normal needs a length")),
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
