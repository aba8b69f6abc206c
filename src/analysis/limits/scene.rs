//! The parts of a scene outside the limits.

use super::limit::{COORDINATE, INDEX, LIGHT_AREA, Limit, RADIUS, REMOTENESS, SCALE, VERTEX_REMOTENESS};
use crate::materials::Material;
use crate::math::{DMat3, DVec3};
use crate::scene::Scene;
use crate::shapes::{Geometry, Outline, Primitive};

/// A sentence for every figure of a scene that lies outside the range in which bounds are promised.
pub fn outside_limits(scene: &Scene) -> Vec<String> {
    let mut found = Vec::new();
    for (number, shape) in scene.shapes.primitives().iter().enumerate() {
        let what = format!("shape {} ({})", number + 1, shape.geometry.name());
        found.extend(shape_figures(shape).into_iter().filter_map(|(limit, value)| outside(&what, &limit, value)));
        let lit = shape.material.numbers().iter().any(|&material| scene.materials[material as usize].is_emissive());
        if lit && let Some(bounds) = shape.bounds() {
            let extent = bounds.extent();
            let side = extent.max_element();
            let area = side * side;
            found.extend(outside(&what, &LIGHT_AREA, area));
        }
    }
    for material in &scene.materials {
        if let Material::Glass { index, .. } = material {
            found.extend(outside("a glass", &INDEX, *index));
        }
    }
    let camera = scene.camera.position().abs().max_element();
    found.extend(outside("the camera", &COORDINATE, camera));
    found
}

/// The figures of a shape, each with its limit.
fn shape_figures(shape: &Primitive) -> Vec<(Limit, f64)> {
    let transform = &shape.transform.to_world;
    let place = transform.translation.abs().max_element();
    let scales = scales(&transform.matrix3);
    let mut figures = vec![(COORDINATE, place)];
    match &shape.geometry {
        Geometry::Flat(Outline::Plane) => return figures,
        Geometry::Sphere => match shape.as_sphere() {
            // A large sphere that touches the origin is a ground: the distance of its surface counts, not that of its centre.
            Some((_, radius)) => figures = vec![(RADIUS, radius), (COORDINATE, (place - radius).max(0.0))],
            None => figures.extend(uneven(scales)),
        },
        Geometry::Mesh(mesh) => {
            let bounds = mesh.bounds();
            let size = bounds.extent().max_element();
            let reach = bounds.minimum.abs().max(bounds.maximum.abs()).max_element();
            figures.push((VERTEX_REMOTENESS, reach / size));
            figures.extend(uneven(scales));
        }
        Geometry::Cuboid | Geometry::Flat(_) => {}
    }
    if let Some(bounds) = shape.bounds() {
        figures.push((REMOTENESS, place / bounds.extent().max_element()));
    }
    figures
}

/// The smallest and the largest scale.
fn uneven(scales: DVec3) -> [(Limit, f64); 2] {
    [(SCALE, scales.min_element()), (SCALE, scales.max_element())]
}

fn scales(matrix: &DMat3) -> DVec3 {
    DVec3::new(matrix.x_axis.length(), matrix.y_axis.length(), matrix.z_axis.length())
}

fn outside(what: &str, limit: &Limit, value: f64) -> Option<String> {
    if limit.range.holds(value) {
        return None;
    }
    let (end, bound) =
        if value < limit.range.least { ("below", limit.range.least) } else { ("above", limit.range.most) };
    Some(format!(
        "{what}: {} is {value:.3e}, {end} {bound:e}, the end of the range that `skycube stress --case {}` measures as \
         accurate",
        limit.figure, limit.case
    ))
}
