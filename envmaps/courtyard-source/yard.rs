//! The plan of the yard: which wall, tree and thing stands where. +x is east, -z north.

use skycube::math::{Vec2, Vec3};

use crate::buildings::{Place, build_roof, build_wall};
use crate::facades::{Facade, Finish, Opening};
use crate::furniture::{build_barrel, build_bench, build_chimney, build_lamp, build_litter, build_pot, build_well};
use crate::ground::{YARD, build_paving, build_soil, lawn};
use crate::model::Model;
use crate::noise::Random;
use crate::paint::STONE;
use crate::plants::{Tree, build_grass, build_ivy, build_shrub, build_tree, build_tuft};

fn window(x: f32, y: f32, width: f32, height: f32) -> Opening {
    Opening { low: Vec2::new(x, y), high: Vec2::new(x + width, y + height), door: false }
}

fn door(x: f32, width: f32, height: f32) -> Opening {
    Opening { low: Vec2::new(x, 0.14), high: Vec2::new(x + width, height), door: true }
}

/// The walls: inn (north), brick house (east), shed (south), tower (southwest, two sides), garden wall (west).
pub fn facades() -> [Facade; 6] {
    let facade = |name, width, height, finish, openings, seed| {
        let size = Vec2::new(width, height);
        Facade { name, size, finish, openings, seed }
    };
    let inn = vec![
        window(0.9, 1.0, 1.0, 1.35),
        door(4.3, 1.15, 2.35),
        window(6.6, 1.0, 1.15, 1.35),
        window(0.8, 3.55, 0.9, 1.2),
        window(7.4, 3.5, 0.95, 1.25),
    ];
    let house = vec![
        window(1.0, 1.0, 0.95, 1.5),
        door(3.0, 1.0, 2.2),
        window(5.3, 1.0, 1.6, 1.4),
        window(8.6, 1.1, 0.9, 1.4),
        window(1.0, 3.8, 0.9, 1.45),
        window(3.2, 3.8, 0.9, 1.45),
        window(5.6, 3.8, 0.9, 1.45),
        window(8.7, 4.0, 0.8, 1.1),
    ];
    let shed = vec![door(0.9, 2.1, 2.2), window(4.2, 1.2, 0.7, 0.7), window(6.2, 1.1, 0.9, 0.8)];
    [
        facade("inn", 9.5, 5.4, Finish::Plaster([224, 206, 168]), inn, 1000),
        facade("house", 11.0, 6.2, Finish::Brick, house, 2000),
        facade("shed", 8.0, 3.0, Finish::Plaster([204, 150, 108]), shed, 3000),
        facade("tower-north", 3.6, 8.2, Finish::Rubble, vec![window(1.5, 5.0, 0.5, 1.2)], 4000),
        facade("tower-east", 4.0, 8.2, Finish::Rubble, vec![door(1.6, 0.9, 2.0), window(1.9, 3.6, 0.45, 0.9)], 5000),
        facade("garden-wall", 14.0, 1.75, Finish::Rubble, Vec::new(), 6000),
    ]
}

pub fn buildings() -> Model {
    let mut model = Model::default();
    let mut random = Random::new(1);
    let places = [
        (Vec3::new(-6.5, 0.0, -9.0), Vec3::X, 4),
        (Vec3::new(8.0, 0.0, -8.5), Vec3::Z, 7),
        (Vec3::new(5.5, 0.0, 6.5), -Vec3::X, 5),
        (Vec3::new(-5.0, 0.0, 5.0), -Vec3::X, 3),
        (Vec3::new(-5.0, 0.0, 9.0), -Vec3::Z, 3),
        (Vec3::new(-7.2, 0.0, 5.0), -Vec3::Z, 3),
    ];
    for (facade, (corner, right, trim)) in facades().iter().zip(places) {
        build_wall(&mut model, Place { corner, right }, facade, trim, &mut random);
    }
    build_roofs(&mut model, &mut random);
    build_battlements(&mut model, &mut random);
    build_coping(&mut model, &mut random);
    build_sign(&mut model);
    build_chimney(&mut model, Vec3::new(-4.4, 6.6, -11.0), 2.2, "house");
    build_chimney(&mut model, Vec3::new(9.9, 7.4, -1.2), 2.3, "house");
    build_chimney(&mut model, Vec3::new(9.7, 7.4, -6.8), 1.9, "house");
    model
}

fn build_roofs(model: &mut Model, random: &mut Random) {
    build_roof(model, Vec3::new(-6.9, 4.98, -8.5), Vec3::X * 10.3, Vec3::new(0.0, 2.7, -3.4), random);
    build_roof(model, Vec3::new(7.5, 5.76, -8.9), Vec3::Z * 11.8, Vec3::new(3.2, 2.6, 0.0), random);
    build_roof(model, Vec3::new(5.9, 2.72, 6.05), Vec3::X * -8.8, Vec3::new(0.0, 1.5, 2.7), random);
}

/// Merlons along the two visible sides of the tower.
fn build_battlements(model: &mut Model, random: &mut Random) {
    for merlon in 0..4 {
        let offset = 0.3 + 1.0 * merlon as f32;
        for (x, z) in [(-5.3 - offset, 5.2), (-5.2, 5.3 + offset)] {
            let middle = Vec3::new(x, 8.55, z);
            let half = [Vec3::X * 0.27, Vec3::Y * 0.36, Vec3::Z * 0.27];
            let variant = random.index(9);
            model.mesh("stone").cuboid(middle, half, STONE.at(variant, 0.4), STONE.at(variant, 0.8));
        }
    }
    let rim = [Vec3::new(-9.0, 8.1, 4.9), Vec3::new(-4.9, 8.25, 9.0)];
    model.mesh("stone").aligned_box(rim[0], rim[1], STONE.at(3, 0.3), STONE.at(3, 0.7));
}

/// Flat stones on top of the garden wall.
fn build_coping(model: &mut Model, random: &mut Random) {
    let mut z = -9.0;
    while z < 4.9 {
        let length = random.range(0.4, 0.75);
        let lift = random.range(0.0, 0.02);
        let low = Vec3::new(-7.75, 1.72, z);
        let high = Vec3::new(-7.12, 1.82 + lift, (z + length - 0.012).min(5.0));
        let variant = random.index(9);
        model.mesh("stone").aligned_box(low, high, STONE.at(variant, 0.35), STONE.at(variant, 0.85));
        z += length;
    }
}

/// The board over the inn's door.
fn build_sign(model: &mut Model) {
    let (low, high, z) = (Vec2::new(-3.45, 2.65), Vec2::new(0.15, 3.4), -8.93);
    let corners = [(low.x, low.y), (high.x, low.y), (high.x, high.y), (low.x, high.y)];
    let texture = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(u, v)| Vec2::new(u, v));
    model.mesh("sign").quad(corners.map(|(x, y)| Vec3::new(x, y, z)), texture);
    let (back, front) = (Vec3::new(low.x, low.y, -9.0), Vec3::new(high.x, high.y, z - 0.005));
    model.mesh("wood").aligned_box(back, front, crate::paint::WOOD.at(1, 0.3), crate::paint::WOOD.at(1, 0.7));
}

/// Paving, lawn, plants and furniture.
pub fn yard() -> Model {
    let mut model = Model::default();
    let mut random = Random::new(2);
    build_soil(&mut model);
    for joint in build_paving(&mut model, &mut random) {
        build_tuft(&mut model, joint, &mut random);
    }
    build_grass(&mut model, YARD[0], Vec2::new(-0.5, 6.0), 190_000, lawn, &mut random);
    build_litter(&mut model, 1400, &mut random);
    let tree = Tree { foot: Vec3::new(-4.3, 0.0, -4.1), height: 6.2, levels: 5, leaf: 0.075, leaves: 26, tint: 0 };
    build_tree(&mut model, &tree, &mut random);
    build_ivy(&mut model, Vec3::new(-7.2, 0.0, 2.0), -Vec3::Z, Vec2::new(6.0, 1.9), 16_000, &mut random);
    build_ivy(&mut model, Vec3::new(8.0, 0.0, -1.2), Vec3::Z, Vec2::new(2.6, 5.6), 22_000, &mut random);
    build_ivy(&mut model, Vec3::new(-5.0, 0.0, 5.0), -Vec3::X, Vec2::new(3.4, 4.5), 16_000, &mut random);
    let shrubs = [
        (-6.3, -7.9, 0.75),
        (-5.2, -8.3, 0.5),
        (-6.4, 2.6, 0.65),
        (3.7, -8.7, 0.8),
        (4.9, -9.1, 0.7),
        (6.3, -8.9, 0.85),
        (7.2, 4.6, 0.9),
    ];
    for (shrub, (x, z, radius)) in shrubs.into_iter().enumerate() {
        build_shrub(
            &mut model,
            Vec3::new(x, 0.7 * radius, z),
            radius,
            (11_000.0 * radius) as usize,
            shrub,
            &mut random,
        );
    }
    build_furniture(&mut model, &mut random);
    model
}

fn build_furniture(model: &mut Model, random: &mut Random) {
    build_well(model, Vec3::new(3.5, 0.0, -3.9), random);
    build_bench(model, Vec3::new(1.3, 0.0, -8.4), Vec3::X);
    build_bench(model, Vec3::new(-6.0, 0.0, -1.2), Vec3::new(0.1, 0.0, -1.0).normalize());
    build_barrel(model, Vec3::new(7.4, 0.0, -2.9));
    build_barrel(model, Vec3::new(7.5, 0.0, -2.2));
    build_lamp(model, Vec3::new(-0.6, 2.5, -9.0), Vec3::Z);
    build_lamp(model, Vec3::new(8.0, 2.7, -4.2), -Vec3::X);
    let pots = [
        (-3.0, -8.5, 0.55, 0, true),
        (-0.4, -8.5, 0.5, 2, true),
        (6.9, -5.9, 0.5, 1, true),
        (7.3, 0.9, 0.7, 0, false),
        (2.2, 6.0, 0.55, 3, true),
        (1.4, 6.05, 0.4, 0, true),
        (-1.9, 5.9, 0.6, 2, false),
        (4.9, -3.1, 0.35, 1, true),
    ];
    for (x, z, size, glaze, flowers) in pots {
        build_pot(model, Vec3::new(x, 0.02, z), size, glaze, flowers, random);
    }
}
