//! A closed, convex mesh.

use std::collections::BTreeMap;

use crate::math::{DVec3, Vec3};
use crate::shapes::mesh::MeshGeometry;

/// The unit sphere as an octahedron whose 8 faces are divided into `frequency^2` triangles each, front outside.
pub fn octasphere(frequency: i32) -> MeshGeometry {
    let mut numbers = BTreeMap::new();
    let mut geometry = MeshGeometry::default();
    for octant in 0..8 {
        let signs = [0, 1, 2].map(|axis| 1 - 2 * (octant >> axis & 1));
        // Three mirrorings turn the triangles round.
        let turned = signs.iter().product::<i32>() < 0;
        let mut vertex = |i: i32, j: i32| {
            let place = [signs[0] * i, signs[1] * j, signs[2] * (frequency - i - j)];
            *numbers.entry(place).or_insert_with(|| {
                geometry.positions.push(DVec3::from(place.map(f64::from)).normalize().as_vec3());
                geometry.positions.len() as u32 - 1
            })
        };
        let mut triangles = Vec::new();
        for i in 0..frequency {
            for j in 0..frequency - i {
                triangles.push([vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]);
                if i + j + 1 < frequency {
                    triangles.push([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
                }
            }
        }
        geometry.triangles.extend(triangles.into_iter().map(|[a, b, c]| if turned { [a, c, b] } else { [a, b, c] }));
    }
    geometry
}

/// The same with vertices scaled along the axes and moved.
pub fn stretched(frequency: i32, scale: Vec3, offset: Vec3) -> MeshGeometry {
    let mut geometry = octasphere(frequency);
    geometry.positions.iter_mut().for_each(|position| *position = *position * scale + offset);
    geometry
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_closed_and_looks_outwards() {
        let geometry = octasphere(5);
        assert_eq!((geometry.triangles.len(), geometry.positions.len()), (200, 102));
        for triangle in 0..200 {
            let centre: Vec3 = geometry.corners(triangle).iter().sum();
            assert!(geometry.area_vector(triangle).dot(centre.as_dvec3()) > 0.0, "{triangle}");
        }
    }
}
