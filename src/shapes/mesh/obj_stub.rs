use super::MeshGeometry;
use crate::error::{Error, Result};
use crate::math::Vec3;
pub struct ObjFile {
    pub geometry: MeshGeometry,
    pub materials: Vec<MtlMaterial>,
}
pub struct MtlMaterial {
    pub diffuse: Vec3,
    pub specular: Vec3,
    pub shininess: f32,
    pub index_of_refraction: Option<f64>,
    pub illumination_model: Option<u8>,
    pub diffuse_map: Option<std::path::PathBuf>,
}
impl ObjFile {
    pub fn read(path: &std::path::Path) -> Result<Self> {
        Err(Error::new("meshes are not read yet").in_file(path))
    }
}
