//! Triangle meshes by material, and their OBJ and MTL files.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use skycube::math::{Vec2, Vec3};

/// Triangles by the name of their material. The texture of a material is the picture of the same name.
#[derive(Default)]
pub struct Model {
    meshes: BTreeMap<String, Mesh>,
}

#[derive(Default)]
pub struct Mesh {
    vertices: Vec<(Vec3, Vec3, Vec2)>,
    triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// Adds a vertex (position, unit normal, texture coordinates with v upwards); returns its number.
    pub fn vertex(&mut self, position: Vec3, normal: Vec3, texture: Vec2) -> usize {
        self.vertices.push((position, normal, texture));
        self.vertices.len() - 1
    }

    pub fn triangle(&mut self, corners: [usize; 3]) {
        self.triangles.push(corners);
    }

    /// A flat quadrilateral, corners anticlockwise seen from outside.
    pub fn quad(&mut self, corners: [Vec3; 4], texture: [Vec2; 4]) {
        let normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalize_or_zero();
        let first = self.vertices.len();
        for (corner, texture) in corners.into_iter().zip(texture) {
            self.vertex(corner, normal, texture);
        }
        self.triangle([first, first + 1, first + 2]);
        self.triangle([first, first + 2, first + 3]);
    }

    /// A box given by its middle and half its three edges; one texture coordinate for the lower, one for the upper end.
    pub fn cuboid(&mut self, middle: Vec3, half: [Vec3; 3], low: Vec2, high: Vec2) {
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let (normal, a, b) = (half[axis] * sign, half[(axis + 1) % 3], half[(axis + 2) % 3] * sign);
                let corners = [-a - b, a - b, a + b, b - a].map(|offset| middle + normal + offset);
                self.quad(corners, corners.map(|corner| if corner.y < middle.y { low } else { high }));
            }
        }
    }

    /// A box along the axes.
    pub fn aligned_box(&mut self, low: Vec3, high: Vec3, dark: Vec2, light: Vec2) {
        let half = 0.5 * (high - low);
        let edges = [Vec3::new(half.x, 0.0, 0.0), Vec3::new(0.0, half.y, 0.0), Vec3::new(0.0, 0.0, half.z)];
        self.cuboid(0.5 * (low + high), edges, dark, light);
    }

    /// The side of a cone frustum: points of two rings, joined; `texture` from the turn (0 to 1) and the end (0, 1).
    pub fn tube(&mut self, ends: [Vec3; 2], radii: [f32; 2], sides: usize, texture: impl Fn(f32, f32) -> Vec2) {
        let axis = (ends[1] - ends[0]).normalize_or_zero();
        let across = axis.any_orthonormal_vector();
        let up = axis.cross(across);
        let first = self.vertices.len();
        for side in 0..=sides {
            let turn = side as f32 / sides as f32;
            let (sine, cosine) = skycube::math::functions::sin_cos_degrees(360.0 * f64::from(turn));
            let normal = across * cosine as f32 + up * sine as f32;
            for end in 0..2 {
                self.vertex(ends[end] + normal * radii[end], normal, texture(turn, end as f32));
            }
        }
        for side in 0..sides {
            let a = first + 2 * side;
            self.triangle([a, a + 2, a + 3]);
            self.triangle([a, a + 3, a + 1]);
        }
    }
}

impl Model {
    /// The mesh of a material, empty at first.
    pub fn mesh(&mut self, material: &str) -> &mut Mesh {
        self.meshes.entry(material.to_owned()).or_default()
    }

    pub fn triangle_count(&self) -> usize {
        self.meshes.values().map(|mesh| mesh.triangles.len()).sum()
    }

    /// Writes `NAME.obj` and `NAME.mtl`.
    pub fn write(&self, folder: &Path, name: &str) -> std::io::Result<()> {
        let mut obj = format!("mtllib {name}.mtl\n");
        let mut mtl = String::new();
        let mut offset = 1;
        for (material, mesh) in &self.meshes {
            writeln!(mtl, "newmtl {material}\nKd 1 1 1\nmap_Kd {material}.png\n").expect("strings do not fail");
            obj += &format!("usemtl {material}\n");
            for (p, n, t) in &mesh.vertices {
                writeln!(
                    obj,
                    "v {:.4} {:.4} {:.4}\nvn {:.3} {:.3} {:.3}\nvt {:.5} {:.5}",
                    p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y
                )
                .expect("strings do not fail");
            }
            for corners in &mesh.triangles {
                let [a, b, c] = corners.map(|corner| corner + offset);
                writeln!(obj, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}").expect("strings do not fail");
            }
            offset += mesh.vertices.len();
        }
        std::fs::write(folder.join(name).with_extension("obj"), obj)?;
        std::fs::write(folder.join(name).with_extension("mtl"), mtl)
    }
}
