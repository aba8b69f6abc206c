//! A displaced sphere of any number of triangles, for tests and benchmarks.

use std::collections::BTreeMap;

use skycube::math::{DVec3, Vec3};
use skycube::shapes::mesh::MeshGeometry;

/// A closed icosphere whose 20 faces are divided into `frequency`^2 triangles each (radius 1, front outside), its
/// vertices moved along their radius by `displacement` (direction to factor).
pub fn icosphere(frequency: usize, displacement: impl Fn(DVec3) -> f64) -> MeshGeometry {
    let (corners, faces) = icosahedron();
    let mut numbers = BTreeMap::new();
    let mut geometry = MeshGeometry::default();
    for face in faces {
        let corner = face.map(|vertex| corners[vertex]);
        let mut vertex = |i: usize, j: usize| {
            let k = frequency - i - j;
            let point = (corner[0] * k as f64 + corner[1] * i as f64 + corner[2] * j as f64).normalize();
            let key = (point * 1e6).round().as_ivec3().to_array();
            *numbers.entry(key).or_insert_with(|| {
                geometry.positions.push((point * displacement(point)).as_vec3());
                geometry.positions.len() as u32 - 1
            })
        };
        for i in 0..frequency {
            for j in 0..frequency - i {
                geometry.triangles.push([vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]);
                if i + j + 1 < frequency {
                    geometry.triangles.push([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
                }
            }
        }
    }
    geometry
}

/// The bumps of the reference measurements: waves of 8 % and ripples of 1 %.
#[allow(dead_code)]
pub fn bumps(point: DVec3) -> f64 {
    let wave = |x: f64, y: f64, z: f64| (x * point.x).sin() * (y * point.y).sin() * (z * point.z).sin();
    1.0 + 0.08 * wave(9.0, 11.0, 13.0) + 0.01 * wave(80.0, 90.0, 70.0)
}

/// Moves and scales all vertices.
#[allow(dead_code)]
pub fn placed(mut geometry: MeshGeometry, scale: f32, offset: Vec3) -> MeshGeometry {
    geometry.positions.iter_mut().for_each(|position| *position = *position * scale + offset);
    geometry
}

fn icosahedron() -> ([DVec3; 12], [[usize; 3]; 20]) {
    let p = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let corners = [
        [-1.0, p, 0.0],
        [1.0, p, 0.0],
        [-1.0, -p, 0.0],
        [1.0, -p, 0.0],
        [0.0, -1.0, p],
        [0.0, 1.0, p],
        [0.0, -1.0, -p],
        [0.0, 1.0, -p],
        [p, 0.0, -1.0],
        [p, 0.0, 1.0],
        [-p, 0.0, -1.0],
        [-p, 0.0, 1.0],
    ];
    #[rustfmt::skip]
    let faces = [
        [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
        [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
        [8, 6, 7], [9, 8, 1],
    ];
    (corners.map(DVec3::from), faces)
}
