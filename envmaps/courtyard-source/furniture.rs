//! What stands in the yard: the well, a bench, pots, a barrel, a lamp, chimneys.

use skycube::math::functions::sin_cos_degrees;
use skycube::math::{Vec2, Vec3};

use crate::buildings::build_roof;
use crate::model::Model;
use crate::noise::Random;
use crate::paint::{CLAY, FLOWER, LEAF, STONE, WOOD};
use crate::plants::{add_leaf, build_shrub};

/// The direction in the ground plane at a turn in degrees.
fn turned(degrees: f32) -> Vec3 {
    let (sine, cosine) = sin_cos_degrees(f64::from(degrees));
    Vec3::new(cosine as f32, 0.0, sine as f32)
}

/// A round well of four courses of blocks under a small tiled roof on two posts.
pub fn build_well(model: &mut Model, foot: Vec3, random: &mut Random) {
    for course in 0..4 {
        for block in 0..13 {
            let turn = (block as f32 + 0.5 * (course % 2) as f32) * 360.0 / 13.0;
            let (out, along) = (turned(turn), turned(turn + 90.0));
            let middle = foot + out * 0.82 + Vec3::Y * (0.11 + 0.21 * course as f32) + 0.012 * random.in_ball();
            let half = [along * 0.19, Vec3::Y * 0.097, out * 0.13];
            let variant = random.index(9);
            let low = STONE.at(variant, 0.35 + 0.1 * course as f32);
            model.mesh("stone").cuboid(middle, half, low, STONE.at(variant, 0.65 + 0.08 * course as f32));
        }
    }
    model.mesh("stone").tube([foot, foot + Vec3::Y * 0.8], [0.72, 0.72], 24, |_, end| STONE.at(6, 0.02 + 0.4 * end));
    let dark = [WOOD.at(1, 0.3), WOOD.at(0, 0.85)];
    for side in [-0.85, 0.85] {
        let low = foot + Vec3::new(side - 0.06, 0.0, -0.06);
        model.mesh("wood").aligned_box(low, low + Vec3::new(0.12, 2.3, 0.12), dark[0], dark[1]);
    }
    let axle = [foot + Vec3::new(-0.9, 1.55, 0.0), foot + Vec3::new(0.9, 1.55, 0.0)];
    model.mesh("wood").tube(axle, [0.07, 0.07], 10, |turn, _| WOOD.at(2, 0.3 + 0.6 * turn));
    let rope = [foot + Vec3::new(0.15, 1.5, 0.05), foot + Vec3::new(0.15, 1.15, 0.05)];
    model.mesh("clay").tube(rope, [0.012, 0.012], 6, |_, _| CLAY.at(3, 0.8));
    let bucket = [foot + Vec3::new(0.15, 0.9, 0.05), foot + Vec3::new(0.15, 1.15, 0.05)];
    model.mesh("wood").tube(bucket, [0.11, 0.14], 14, |turn, _| WOOD.at((14.0 * turn) as usize % 3, 0.7));
    let (width, rise, run) = (2.3, 0.55, 0.75);
    let eaves = foot + Vec3::new(-0.5 * width, 2.1, run);
    build_roof(model, eaves, Vec3::X * width, Vec3::new(0.0, rise, -run), random);
    build_roof(model, foot + Vec3::new(0.5 * width, 2.1, -run), -Vec3::X * width, Vec3::new(0.0, rise, run), random);
}

/// A bench of planks, its seat along `along`, its back away from the viewer of its front.
pub fn build_bench(model: &mut Model, middle: Vec3, along: Vec3) {
    let front = along.cross(Vec3::Y);
    let mesh = model.mesh("wood");
    for plank in 0..4 {
        let place = middle + front * (0.12 * plank as f32 - 0.18) + Vec3::Y * 0.46;
        let half = [along * 0.85, Vec3::Y * 0.018, front * 0.052];
        mesh.cuboid(place, half, WOOD.at(plank % 3, 0.5), WOOD.at(plank % 3, 0.95));
    }
    for plank in 0..3 {
        let place = middle - front * 0.27 + Vec3::Y * (0.62 + 0.15 * plank as f32);
        let half = [along * 0.85, Vec3::Y * 0.055, front * 0.018];
        mesh.cuboid(place, half, WOOD.at(plank, 0.45), WOOD.at(plank, 0.9));
    }
    for (side, depth, height) in [(-0.7, 0.18, 0.23), (0.7, 0.18, 0.23), (-0.7, -0.25, 0.5), (0.7, -0.25, 0.5)] {
        let place = middle + along * side + front * depth + Vec3::Y * height;
        let half = [along * 0.04, Vec3::Y * height, front * 0.04];
        mesh.cuboid(place, half, WOOD.at(1, 0.15), WOOD.at(1, 0.7));
    }
}

/// A pot of clay with a round bush or with flowers.
pub fn build_pot(model: &mut Model, foot: Vec3, size: f32, glaze: usize, flowers: bool, random: &mut Random) {
    let shade = |turn: f32, end: f32| CLAY.at(glaze, 0.3 + 0.5 * end + 0.1 * (turn - 0.5).abs());
    model.mesh("clay").tube([foot, foot + Vec3::Y * (0.8 * size)], [0.32 * size, 0.46 * size], 20, shade);
    let rim = [foot + Vec3::Y * (0.78 * size), foot + Vec3::Y * (0.9 * size)];
    model.mesh("clay").tube(rim, [0.51 * size, 0.51 * size], 20, |_, end| CLAY.at(glaze, 0.6 + 0.4 * end));
    let middle = foot + Vec3::Y * (1.3 * size);
    build_shrub(model, middle, 0.62 * size, (5200.0 * size * size) as usize + 300, glaze + 2, random);
    if flowers {
        let colour = random.index(6);
        for _ in 0..90 {
            let place = middle + random.in_ball().normalize_or(Vec3::Y) * (0.66 * size);
            if place.y > middle.y - 0.2 * size {
                add_leaf(model, "flower", place, 0.028, FLOWER.at(colour, random.range(0.7, 1.0)), random);
            }
        }
    }
}

/// A barrel of staves with hoops.
pub fn build_barrel(model: &mut Model, foot: Vec3) {
    let ring = |height: f32| 0.27 + 0.07 * (1.0 - (2.0 * height - 1.0) * (2.0 * height - 1.0));
    for part in 0..6 {
        let (low, high) = (part as f32 / 6.0, (part + 1) as f32 / 6.0);
        let ends = [foot + Vec3::Y * (0.9 * low), foot + Vec3::Y * (0.9 * high)];
        let staves = |turn: f32, _: f32| WOOD.at((18.0 * turn) as usize % 3, 0.5 + 0.4 * high);
        model.mesh("wood").tube(ends, [ring(low), ring(high)], 18, staves);
    }
    for height in [0.12, 0.33, 0.67, 0.88] {
        let ends = [foot + Vec3::Y * (0.9 * height - 0.02), foot + Vec3::Y * (0.9 * height + 0.02)];
        let radius = ring(height) + 0.008;
        model.mesh("stone").tube(ends, [radius, radius], 24, |_, _| STONE.at(6, 0.3));
    }
    let top = foot + Vec3::Y * 0.86;
    model.mesh("wood").tube([top, top + Vec3::Y * 0.001], [0.27, 0.0], 18, |_, _| WOOD.at(1, 0.5));
}

/// A lamp on a bracket.
pub fn build_lamp(model: &mut Model, wall: Vec3, out: Vec3) {
    let iron = [STONE.at(6, 0.02), STONE.at(6, 0.15)];
    let side = out.cross(Vec3::Y);
    let mesh = model.mesh("stone");
    mesh.cuboid(wall + out * 0.25, [out * 0.25, Vec3::Y * 0.02, side * 0.02], iron[0], iron[1]);
    for (height, half) in [(-0.08, 0.12), (-0.42, 0.09)] {
        let place = wall + out * 0.45 + Vec3::Y * height;
        mesh.cuboid(place, [out * half, Vec3::Y * 0.025, side * half], iron[0], iron[1]);
    }
    let glass = wall + out * 0.45 - Vec3::Y * 0.25;
    model.mesh("clay").cuboid(glass, [out * 0.07, Vec3::Y * 0.15, side * 0.07], CLAY.at(3, 0.7), CLAY.at(3, 1.0));
}

/// A brick chimney with a cap and two pots.
pub fn build_chimney(model: &mut Model, foot: Vec3, height: f32, facade: &str) {
    let half = [Vec3::X * 0.4, Vec3::Y * (0.5 * height), Vec3::Z * 0.32];
    let middle = foot + Vec3::Y * (0.5 * height);
    for (normal, right) in [(2, Vec3::X), (0, -Vec3::Z), (2, -Vec3::X), (0, Vec3::Z)] {
        let out = right.cross(Vec3::Y) * half[normal].length();
        let wide = right * if normal == 2 { 0.4 } else { 0.32 };
        let corners =
            [-wide - half[1], wide - half[1], wide + half[1], half[1] - wide].map(|point| middle + out + point);
        let texture = [(0.3, 0.4), (0.38, 0.4), (0.38, 0.6), (0.3, 0.6)].map(|(u, v)| Vec2::new(u, v));
        model.mesh(facade).quad(corners, texture);
    }
    let cap = foot + Vec3::Y * height;
    model.mesh("stone").aligned_box(
        cap - Vec3::new(0.48, 0.0, 0.4),
        cap + Vec3::new(0.48, 0.1, 0.4),
        STONE.at(3, 0.4),
        STONE.at(3, 0.9),
    );
    for side in [-0.18, 0.18] {
        let pot = cap + Vec3::new(side, 0.1, 0.0);
        model.mesh("clay").tube([pot, pot + Vec3::Y * 0.4], [0.13, 0.1], 12, |_, end| CLAY.at(1, 0.4 + 0.6 * end));
    }
}

/// Fallen leaves on the paving, thickest under the tree.
pub fn build_litter(model: &mut Model, count: usize, random: &mut Random) {
    for _ in 0..count {
        let spread = 5.5 * random.in_ball();
        let place = Vec3::new(-3.4 + spread.x, 0.045, -3.2 + spread.z);
        add_leaf(
            model,
            "leaf",
            place,
            random.range(0.02, 0.04),
            LEAF.at(4 + 2 * random.index(2), random.range(0.6, 1.0)),
            random,
        );
    }
}
