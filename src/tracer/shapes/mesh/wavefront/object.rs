//! An OBJ file as one mesh.

use std::io::Cursor;
use std::path::Path;

use super::materials::ObjMaterial;
use super::read_text;
use super::scan::scan;
use crate::error::{Error, Result};
use crate::math::{Vec2, Vec3};
use crate::shapes::mesh::{Mesh, MeshGeometry};

/// What an OBJ file holds: one mesh of all its objects.
///
/// Polygons are cut into triangles as a fan from their first corner. Missing normals stay missing (flat faces).
/// Texture coordinates are the file's: `v = 0` at the bottom of the picture.
#[derive(Debug, Clone)]
pub struct ObjFile {
    pub mesh: Mesh,
    /// The material of each material group of the mesh, `None` for the faces before any `usemtl`.
    pub groups: Vec<Option<ObjMaterial>>,
}

impl ObjFile {
    /// Reads an OBJ file and the MTL files it names.
    ///
    /// An error names the file and line: a line that cannot be read, an index of what is not defined, an MTL file
    /// that is missing or lacks a material that is used.
    pub fn read(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        Self::parse(path).map_err(|error| error.in_file(path))
    }

    fn parse(path: &Path) -> Result<Self> {
        let text = read_text(path)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let libraries = scan(&text, folder)?;
        let options =
            tobj::LoadOptions { single_index: true, triangulate: true, ignore_points: true, ignore_lines: true };
        let mut reader = Cursor::new(text.as_bytes());
        let (models, materials) = tobj::load_obj_buf(&mut reader, &options, |name| libraries.load(&folder.join(name)))
            .map_err(|error| Error::new(error.to_string()))?;
        let materials = materials.map_err(|error| Error::new(format!("its materials: {error}")))?;
        let mut geometry = MeshGeometry::default();
        let mut ids = Vec::new();
        for model in models.into_iter().filter(|model| !model.mesh.indices.is_empty()) {
            let id = model.mesh.material_id;
            let group = ids.iter().position(|&known| known == id).unwrap_or(ids.len());
            if group == ids.len() {
                ids.push(id);
            }
            append(&mut geometry, &model, group as u32)?;
        }
        drop_if_all(&mut geometry.normals, Vec3::ZERO);
        drop_if_all(&mut geometry.texture_coordinates, Vec2::ZERO);
        let groups = ids.into_iter().map(|id| id.map(|id| libraries.material(&materials[id]))).collect();
        Ok(Self { mesh: Mesh::new(geometry)?, groups })
    }
}

/// Adds the triangles of one object and material; vertices without a normal get the zero vector.
fn append(geometry: &mut MeshGeometry, model: &tobj::Model, group: u32) -> Result<()> {
    let mesh = &model.mesh;
    let first = geometry.positions.len() as u32;
    let vertices = mesh.positions.len() / 3;
    let complete = |values: usize, size: usize| values == 0 || values == vertices * size;
    if !complete(mesh.normals.len(), 3) || !complete(mesh.texcoords.len(), 2) {
        return Err(Error::new(format!(
            "some faces of \"{}\" have normals or texture coordinates, some not",
            model.name
        ))
        .expected("all faces of an object (`o`, `g`, `usemtl`) to have them, or none")
        .help("export it again, or put the faces without them into an object of their own"));
    }
    geometry.positions.extend(mesh.positions.chunks_exact(3).map(Vec3::from_slice));
    geometry.normals.extend(mesh.normals.chunks_exact(3).map(Vec3::from_slice));
    geometry.normals.resize(geometry.positions.len(), Vec3::ZERO);
    geometry.texture_coordinates.extend(mesh.texcoords.chunks_exact(2).map(Vec2::from_slice));
    geometry.texture_coordinates.resize(geometry.positions.len(), Vec2::ZERO);
    let triangle = |corners: &[u32]| [corners[0] + first, corners[1] + first, corners[2] + first];
    geometry.triangles.extend(mesh.indices.chunks_exact(3).map(triangle));
    geometry.materials.resize(geometry.triangles.len(), group);
    Ok(())
}

/// Empties a list in which nothing is given.
fn drop_if_all<T: PartialEq>(values: &mut Vec<T>, nothing: T) {
    if values.iter().all(|value| *value == nothing) {
        values.clear();
    }
}
