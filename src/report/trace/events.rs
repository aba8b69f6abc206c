//! The events of a traced pixel as sentences.

use crate::choice::name_of;
use crate::envmap::{Probe, VOrigin};
use crate::integrators::LightOutcome;
use crate::lights::Light;
use crate::materials::Material;
use crate::math::functions::arccos;
use crate::math::{DVec3, Ray, Side, Vec3};
use crate::scene::Scene;
use crate::shapes::Surface;

/// `(0.1, 0.2, 0.3)`, each the shortest digits that give the same `f32`.
pub(super) fn colour(colour: Vec3) -> String {
    let Vec3 { x, y, z } = colour;
    format!("({x}, {y}, {z})")
}

/// A place or direction, to six digits.
pub(super) fn vector(vector: DVec3) -> String {
    // Adding 0 takes the sign of -0 away.
    let DVec3 { x, y, z } = vector + DVec3::ZERO;
    format!("({x:.6}, {y:.6}, {z:.6})")
}

/// The angle of a cosine in degrees.
pub(super) fn degrees(cosine: f64) -> f64 {
    arccos(cosine.clamp(-1.0, 1.0)) * 180.0 / std::f64::consts::PI
}

/// `shape 2 (sphere)`, counted from 1 as they stand in the scene file.
pub(super) fn shape_name(scene: &Scene, shape: u32) -> String {
    format!("shape {} ({})", shape + 1, geometry_name(scene, shape))
}

pub(super) fn geometry_name(scene: &Scene, shape: u32) -> &'static str {
    scene.shapes.primitives().get(shape as usize).map_or("nothing", |primitive| primitive.geometry.name())
}

/// `"gold" (mirror)`.
pub(super) fn material_name(scene: &Scene, material: u32) -> String {
    let name = scene.material_names.get(material as usize).map_or("", String::as_str);
    format!("\"{name}\" ({})", material_kind(scene, material))
}

pub(super) fn material_kind(scene: &Scene, material: u32) -> &'static str {
    match &scene.materials[material as usize] {
        Material::Normals => "normals",
        Material::TextureCoordinates => "texture coordinates",
        Material::Lambert { .. } => "lambert",
        Material::Phong { .. } => "phong",
        Material::Mirror { .. } => "mirror",
        Material::Metal(_) => "metal",
        Material::Coated { .. } => "coated",
        Material::Glass { .. } => "glass",
        Material::Light { .. } => "light",
    }
}

pub(super) fn light_kind(scene: &Scene, number: usize) -> &'static str {
    match scene.lights[number] {
        Light::Ambient { .. } => "ambient",
        Light::Directional { .. } => "directional",
        Light::Point { .. } => "point",
        Light::Spot { .. } => "spot",
    }
}

/// The shape that a shadow ray is stopped by.
pub(super) fn blocker(scene: &Scene, ray: &Ray, distance: f64) -> Option<u32> {
    let mut shapes = (0..).zip(scene.shapes.primitives());
    shapes.find(|(shape, it)| it.casts_shadow && it.occludes(ray, *shape, distance)).map(|(shape, _)| shape)
}

/// What came of a light.
pub(super) fn light(scene: &Scene, number: usize, outcome: &LightOutcome) -> String {
    let name = format!("light {} ({})", number + 1, light_kind(scene, number));
    match outcome {
        LightOutcome::Ambient { contribution } => format!("{name}: unshadowed, + {}", colour(*contribution)),
        LightOutcome::Unreached => format!("{name}: does not reach this point"),
        LightOutcome::Behind => format!("{name}: the surface faces away from it"),
        LightOutcome::Blocked { ray, distance } => {
            let by =
                blocker(scene, ray, *distance).map_or_else(|| "a shape".to_owned(), |shape| shape_name(scene, shape));
            format!("{name}: shadow ray towards {} blocked by {by}", vector(ray.direction))
        }
        LightOutcome::Free { ray, distance, cosine, contribution } => format!(
            "{name}: shadow ray towards {} free over {}, angle {:.2}°, + {}",
            vector(ray.direction),
            length(*distance),
            degrees(*cosine),
            colour(*contribution)
        ),
    }
}

pub(super) fn length(distance: f64) -> String {
    if distance.is_finite() { format!("{distance:.6}") } else { "any distance".to_owned() }
}

/// A hit: what, where, how it is seen.
pub(super) fn hit(
    scene: &Scene,
    surface: &Surface,
    side: Side,
    normal: DVec3,
    distance: f64,
    cosine: f64,
) -> [String; 2] {
    let side = if side == Side::Front { "from outside" } else { "from inside" };
    let turned = if normal == surface.shading_normal { "" } else { ", turned towards the ray" };
    [
        format!(
            "hits {}, material {}, {side}, at {}, distance {distance:.6}",
            shape_name(scene, surface.id.shape),
            material_name(scene, surface.material),
            vector(surface.position)
        ),
        format!("normal {}{turned}, angle {:.2}°", vector(surface.shading_normal), degrees(cosine)),
    ]
}

/// The steps of an environment lookup, for a cube map those of `skycube probe`.
pub(super) fn environment(scene: &Scene, direction: DVec3) -> Vec<String> {
    let Some(probe) = probe(scene, direction) else { return Vec::new() };
    let names: Vec<&str> = probe.largest_axes.iter().map(|&axis| ["x", "y", "z"][axis]).collect();
    let [width, height] = probe.size;
    let [x, y] = probe.position;
    let down = if probe.v_origin == VOrigin::Top { "v" } else { "(1 - v)" };
    let filter = name_of(probe.filter);
    let mut lines = vec![
        format!(
            "largest component {} = {}: face {}, u along {} = {}, v along {} = {}",
            names.join(" and "),
            probe.largest,
            probe.point.face.signed_name(),
            probe.row.u,
            probe.point.u,
            probe.row.v,
            probe.point.v
        ),
        format!(
            "image {}: texel position (u * {width}, {down} * {height}) = ({x}, {y}), {filter}",
            probe.row.image.name()
        ),
    ];
    for texel in &probe.texels {
        let place = texel.place.map_or_else(
            || "mean of the others".to_owned(),
            |place| format!("{} column {} row {}", place.image.name(), place.column, place.row),
        );
        lines.push(format!("  {} x {} ({place})", texel.weight, colour(texel.colour)));
    }
    lines.push(format!("colour {}, scale {}", colour(probe.colour), scene.environment.scale));
    lines
}

/// The lookup of a direction, if the environment is a cube map.
pub(super) fn probe(scene: &Scene, direction: DVec3) -> Option<Probe> {
    Probe::new(scene.environment.cube_map()?, direction.as_vec3()).ok()
}
