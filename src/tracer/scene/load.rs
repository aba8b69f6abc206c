//! From the TOML text to the scene.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use skycube_files::document::{Document, Table, Value};

use super::aggregate::Aggregate;
use super::material::TextureStore;
use super::settings::{HierarchyChoice, IntegratorSettings, OutputSettings};
use super::shape::ShapeReader;
use super::{camera, environment, light, material};
use crate::camera::Camera;
use crate::envmap::Environment;
use crate::error::Result;
use crate::lights::Light;
use crate::materials::Material;
use crate::sampling::Sampling;
use crate::shapes::{Geometry, Primitive};

/// Everything a picture is computed from.
#[derive(Debug)]
pub struct Scene {
    /// Where the picture is taken from, and its size in pixels.
    pub camera: Camera,
    /// Samples per pixel.
    pub samples: u32,
    /// How the samples are chosen.
    pub sampling: Sampling,
    /// How light is followed.
    pub integrator: IntegratorSettings,
    /// How the picture is written.
    pub output: OutputSettings,
    /// The surroundings, infinitely far away.
    pub environment: Environment,
    /// By the numbers that shapes hold.
    pub materials: Vec<Material>,
    /// What the scene calls them; those of a mesh file's own are called after the file.
    pub material_names: Vec<String>,
    /// Light sources without an extent, in the order of the file.
    pub lights: Vec<Light>,
    /// Everything a ray can hit.
    pub shapes: Aggregate,
    /// Every file the scene was read from: none of them may be written to.
    pub sources: Vec<PathBuf>,
    /// What of the files was left out or read with goodwill.
    pub notes: Vec<String>,
}

impl Scene {
    /// Reads a scene file and what it names; pictures of the environment are only decoded when a ray needs them.
    pub fn read(file: &Path) -> Result<Self> {
        Self::read_with_environment(file, None)
    }

    /// Reads a scene file with another map in place of the environment's own.
    pub fn read_with_environment(file: &Path, map_override: Option<PathBuf>) -> Result<Self> {
        Self::from_document(&Document::read(file)?, file, map_override)
    }

    /// A scene from its text; `file` is what errors call it and what paths in it are relative to.
    pub fn from_text(text: &str, file: &Path) -> Result<Self> {
        Self::from_document(&Document::new(file, text), file, None)
    }

    /// A scene without shapes or lights: every ray takes the environment. One sample per pixel.
    pub fn of_environment(environment: Environment, camera: Camera) -> Self {
        Self {
            camera,
            samples: 1,
            sampling: Sampling::default(),
            integrator: IntegratorSettings::default(),
            output: OutputSettings::default(),
            environment,
            materials: Vec::new(),
            material_names: Vec::new(),
            lights: Vec::new(),
            shapes: Aggregate::new(Vec::new()),
            sources: Vec::new(),
            notes: Vec::new(),
        }
    }

    fn from_document(document: &Document, file: &Path, map_override: Option<PathBuf>) -> Result<Self> {
        let parsed = document.parse()?;
        let mut root = document.root(&parsed);
        let (camera, samples, sampling) = camera::read(root.required("camera")?.table()?)?;
        let integrator = IntegratorSettings::read(optional_table(&mut root, "integrator")?)?;
        let output = OutputSettings::read(optional_table(&mut root, "output")?)?;
        if map_override.is_some() && !root.has("environment") {
            return Err(root
                .error("there is no environment map to replace")
                .expected("an [environment] table of kind \"cube-map\" or \"equirectangular\""));
        }
        let surroundings = environment::read(optional_table(&mut root, "environment")?, map_override)?;
        let placed = PlacedShapes::read(&mut root)?;
        let lights = tables(&mut root, "lights")?.into_iter().map(light::read).collect::<Result<_>>()?;
        root.finish()?;

        let mut sources = vec![file.to_path_buf()];
        sources.extend(placed.files);
        sources.extend(surroundings.files);
        let build = match integrator.hierarchy {
            HierarchyChoice::Auto => Aggregate::new,
            HierarchyChoice::Textbook => |primitives| Aggregate::with_hierarchy(primitives, true),
            HierarchyChoice::Off => Aggregate::without_hierarchy,
        };
        Ok(Self {
            camera,
            samples,
            sampling,
            integrator,
            output,
            environment: surroundings.environment,
            materials: placed.materials,
            material_names: placed.material_names,
            lights,
            shapes: build(placed.primitives),
            sources,
            notes: placed.notes,
        })
    }
}

/// The shapes of a scene with their materials.
struct PlacedShapes {
    primitives: Vec<Primitive>,
    materials: Vec<Material>,
    material_names: Vec<String>,
    /// Meshes, their MTL files and textures.
    files: Vec<PathBuf>,
    notes: Vec<String>,
}

impl PlacedShapes {
    /// Reads the tables `materials` and `shapes`.
    fn read(root: &mut Table) -> Result<Self> {
        let mut textures = TextureStore::default();
        let colours = root.optional("mtl_colours").map(|value| value.choice()).transpose()?;
        let mut shapes = ShapeReader::new(&mut textures, colours.unwrap_or_default());
        let described = root.optional("materials").map_or(Ok(Vec::new()), |table| Ok(table.table()?.take_all()))?;
        described.iter().for_each(|(name, _)| shapes.add_material(name.clone()));
        let mut primitives = Vec::new();
        for table in tables(root, "shapes")? {
            primitives.push(shapes.read(table)?);
        }
        // What a shape shows decides which tables are needed.
        let numbers = primitives.iter().flat_map(|primitive: &Primitive| primitive.material.numbers());
        let shown: BTreeSet<u32> = numbers.copied().collect();
        for (number, (_, value)) in (0..).zip(&described) {
            let material = material::read(value.table()?, shapes.textures, shown.contains(&number))?;
            if material.needs_vertex_colours() {
                check_vertex_colours(number, value, &primitives)?;
            }
            shapes.materials[number as usize] = material;
        }
        shapes.check_glass();
        shapes.check_vertex_colours();
        let material_names = shapes.names_of_materials();
        let mut materials = std::mem::take(&mut shapes.materials);
        material::prepare_for_each_other(&mut materials, &shown);
        for primitive in &mut primitives {
            let needed = |number: u32| materials[number as usize].needs_texture_coordinates();
            primitive.textured = primitive.material.numbers().iter().any(|&number| needed(number));
        }
        let (mut files, notes) = (std::mem::take(&mut shapes.files), std::mem::take(&mut shapes.notes));
        files.extend(textures.files().cloned());
        Ok(Self { primitives, materials, material_names, files, notes })
    }
}

/// An error if a shape that shows a material of the vertices' colours has no such colours.
fn check_vertex_colours(number: u32, material: &Value, primitives: &[Primitive]) -> Result<()> {
    let without = |primitive: &&Primitive| match &primitive.geometry {
        _ if !primitive.material.numbers().contains(&number) => false,
        Geometry::Mesh(mesh) => mesh.geometry().colours.is_empty(),
        _ => true,
    };
    let Some(primitive) = primitives.iter().find(without) else { return Ok(()) };
    let shape = primitive.geometry.name();
    Err(material
        .error(format!("it takes the colours of vertices, but a shape that shows it, a {shape}, has none"))
        .expected("meshes whose OBJ files have colours (v x y z red green blue)"))
}

fn optional_table<'a>(root: &mut Table<'a>, key: &'static str) -> Result<Option<Table<'a>>> {
    root.optional(key).map(|value| value.table()).transpose()
}

fn tables<'a>(root: &mut Table<'a>, key: &'static str) -> Result<Vec<Table<'a>>> {
    let Some(value) = root.optional(key) else { return Ok(Vec::new()) };
    value.list()?.iter().map(|entry| entry.table()).collect()
}
