//! Trees, shrubs, ivy, grass and fallen leaves.

use skycube::math::functions::{cos, sin};
use skycube::math::{Vec2, Vec3};

use crate::model::Model;
use crate::noise::{Random, fractal, smoothstep};
use crate::paint::{GRASS, LEAF};

/// A leaf: two triangles folded along the middle, turned at random.
pub fn add_leaf(model: &mut Model, material: &str, place: Vec3, size: f32, texture: Vec2, random: &mut Random) {
    let tip = random.in_ball().normalize_or(Vec3::X);
    let side = tip.cross(random.in_ball()).normalize_or(Vec3::Y);
    let upward = if tip.cross(side).y < 0.0 { -tip.cross(side) } else { tip.cross(side) };
    let mesh = model.mesh(material);
    let points = [place - tip * size, place + side * (0.55 * size), place + tip * size, place - side * (0.55 * size)];
    let lift = [0.0, 0.25 * size, 0.0, 0.25 * size];
    let vertices: Vec<usize> = (0..4)
        .map(|corner| {
            let lean = side
                * if corner == 1 {
                    -0.4
                } else if corner == 3 {
                    0.4
                } else {
                    0.0
                };
            mesh.vertex(points[corner] + upward * lift[corner], (upward + lean).normalize(), texture)
        })
        .collect();
    mesh.triangle([vertices[0], vertices[1], vertices[2]]);
    mesh.triangle([vertices[0], vertices[2], vertices[3]]);
}

/// What a tree is grown from.
pub struct Tree {
    pub foot: Vec3,
    pub height: f32,
    pub levels: usize,
    pub leaf: f32,
    pub leaves: usize,
    pub tint: usize,
}

/// Grows a tree: branches fork, thin out and bend up; twigs carry leaves, darker inside the crown.
pub fn build_tree(model: &mut Model, tree: &Tree, random: &mut Random) {
    let crown = tree.foot + Vec3::Y * (0.66 * tree.height);
    let lean = Vec3::new(random.range(-0.12, 0.12), 1.0, random.range(-0.12, 0.12)).normalize();
    grow(model, tree, crown, tree.foot, lean, 0.30 * tree.height, 0.028 * tree.height, tree.levels, random);
}

#[expect(clippy::too_many_arguments, reason = "a recursion that carries the state of a branch")]
fn grow(
    model: &mut Model,
    tree: &Tree,
    crown: Vec3,
    from: Vec3,
    direction: Vec3,
    length: f32,
    radius: f32,
    level: usize,
    random: &mut Random,
) {
    let to = from + direction * length;
    let shift = random.unit();
    let bark = |turn: f32, end: f32| Vec2::new(0.25 * turn + 0.7 * shift, 0.1 + 0.8 * end);
    model.mesh("bark").tube([from, to], [radius, 0.72 * radius], if level > 2 { 8 } else { 4 }, bark);
    if level <= 1 {
        add_twig_leaves(model, tree, crown, from, to, random);
    }
    if level == 0 {
        return;
    }
    for fork in 0..3 + random.index(2) {
        let spread = if fork == 0 { 0.35 } else { 0.95 };
        let bent = (direction + spread * random.in_ball() + Vec3::Y * 0.12).normalize();
        let start = from.lerp(to, if fork == 0 { 1.0 } else { random.range(0.55, 1.0) });
        let (length, radius) = (length * random.range(0.62, 0.82), radius * random.range(0.5, 0.68));
        grow(model, tree, crown, start, bent, length, radius, level - 1, random);
    }
}

fn add_twig_leaves(model: &mut Model, tree: &Tree, crown: Vec3, from: Vec3, to: Vec3, random: &mut Random) {
    for _ in 0..tree.leaves {
        let place = from.lerp(to, random.range(0.2, 1.15)) + random.in_ball() * (2.4 * tree.leaf);
        let outward = ((place - crown).length() / (0.42 * tree.height)).min(1.0);
        let above = smoothstep(-0.4, 0.5, (place.y - crown.y) / tree.height);
        let light = 0.25 + 0.5 * outward * outward + 0.25 * above;
        let variant = tree.tint + random.index(4);
        add_leaf(model, "leaf", place, tree.leaf * random.range(0.7, 1.2), LEAF.at(variant, light), random);
    }
}

/// A shrub: leaves in a lumpy ball.
pub fn build_shrub(model: &mut Model, middle: Vec3, radius: f32, count: usize, tint: usize, random: &mut Random) {
    for _ in 0..count {
        let direction = random.in_ball().normalize_or(Vec3::Y);
        let lump = 1.0 + 0.35 * fractal(2.0 * direction + middle, 3, 5);
        let depth = 1.0 - 0.45 * random.unit() * random.unit();
        let place = middle + direction * Vec3::new(1.0, 0.85, 1.0) * (radius * lump * depth);
        if place.y > 0.0 {
            let light = (0.30 + 0.55 * smoothstep(0.5, 1.0, depth)) * (0.6 + 0.4 * smoothstep(-1.0, 0.6, direction.y));
            add_leaf(model, "leaf", place, random.range(0.025, 0.05), LEAF.at(tint + random.index(3), light), random);
        }
    }
}

/// Ivy on a wall: leaves where noise and the distance from the root let it climb.
pub fn build_ivy(model: &mut Model, corner: Vec3, right: Vec3, size: Vec2, count: usize, random: &mut Random) {
    let outward = right.cross(Vec3::Y);
    for _ in 0..count {
        let (x, y) = (random.unit(), random.unit());
        let reach = 0.5 + 0.5 * fractal(Vec3::new(3.0 * x, 0.0, 2.0 * y) + corner, 4, 17) - 0.75 * y;
        if reach > 0.0 {
            let thick = smoothstep(0.0, 0.3, reach);
            let out = random.range(0.02, 0.06 + 0.16 * thick);
            let place = corner + right * (x * size.x) + Vec3::Y * (y * size.y) + outward * out;
            let light = 0.35 + 3.0 * out;
            add_leaf(model, "leaf", place, random.range(0.03, 0.06), LEAF.at(random.index(8), light), random);
        }
    }
}

/// A blade of grass, dark at the root.
fn add_blade(model: &mut Model, root: Vec3, height: f32, random: &mut Random) {
    let turn = f64::from(random.range(0.0, std::f32::consts::TAU));
    let side = Vec3::new(cos(turn) as f32, 0.0, sin(turn) as f32) * random.range(0.003, 0.006);
    let tip = root + Vec3::Y * height + 0.5 * height * random.in_ball() * Vec3::new(1.0, 0.2, 1.0);
    let normal = (side.cross(tip - root).normalize() * 0.35 + Vec3::Y).normalize();
    let variant = random.index(6);
    let mesh = model.mesh("grass");
    let corners = [(root - side, 0.2), (root + side, 0.2), (tip, 1.0)];
    let vertices = corners.map(|(point, light)| mesh.vertex(point, normal, GRASS.at(variant, light)));
    mesh.triangle(vertices);
}

/// Grass over the rectangle where `cover` (0 to 1) says so.
pub fn build_grass(
    model: &mut Model,
    low: Vec2,
    high: Vec2,
    count: usize,
    cover: impl Fn(Vec2) -> f32,
    random: &mut Random,
) {
    for _ in 0..count {
        let place = Vec2::new(random.range(low.x, high.x), random.range(low.y, high.y));
        let cover = cover(place);
        if random.unit() < cover {
            let lush = 0.6 + 0.6 * fractal(Vec3::new(place.x, 0.0, place.y) * 1.4, 3, 23);
            add_blade(model, Vec3::new(place.x, 0.0, place.y), random.range(0.04, 0.09) + 0.07 * lush * cover, random);
        }
    }
}

/// A tuft in a joint of the paving.
pub fn build_tuft(model: &mut Model, place: Vec3, random: &mut Random) {
    for _ in 0..14 {
        let root = place + 0.03 * random.in_ball() * Vec3::new(1.0, 0.0, 1.0);
        let height = random.range(0.04, 0.13);
        add_blade(model, root, height, random);
    }
}
