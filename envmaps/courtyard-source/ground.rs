//! The ground: paving of single stones, soil, and the land around as far as the hills.

use std::path::Path;

use skycube::error::Result;
use skycube::math::functions::{exponential, sin_cos_degrees};
use skycube::math::{Vec2, Vec3};

use crate::model::Model;
use crate::noise::{Random, cell, fractal, smoothstep};
use crate::paint::{STONE, srgb, write_picture};

/// The yard in x and z.
pub const YARD: [Vec2; 2] = [Vec2::new(-7.2, -9.0), Vec2::new(8.0, 6.5)];

/// How far the lawn covers a place, 0 to 1: a ragged patch round the tree and a strip along the west wall.
pub fn lawn(place: Vec2) -> f32 {
    let ragged = 0.7 * fractal(Vec3::new(place.x, 0.0, place.y) * 1.1, 4, 41);
    let patch = 2.3 - place.distance(Vec2::new(-4.1, -4.0)) + ragged;
    let strip = -6.2 - place.x + 0.6 * ragged;
    smoothstep(-0.1, 0.35, patch.max(strip))
}

/// Stones in rows, each a low dome of its own size, height and colour; returns places in the joints.
pub fn build_paving(model: &mut Model, random: &mut Random) -> Vec<Vec3> {
    let mut joints = Vec::new();
    let mut z = YARD[0].y;
    while z < YARD[1].y {
        let depth = random.range(0.10, 0.15);
        let mut x = YARD[0].x + random.range(0.0, 0.1);
        while x < YARD[1].x {
            let width = random.range(0.09, 0.20);
            let wave = 0.06 * fractal(Vec3::new(0.5 * x, 0.0, 0.3 * z), 2, 51);
            let middle = Vec3::new(x + 0.5 * width, 0.0, z + 0.5 * depth + wave);
            if lawn(Vec2::new(middle.x, middle.z)) < 0.5 {
                let half = Vec2::new(0.5 * width - 0.006, 0.5 * depth - 0.006);
                add_cobble(model, middle, half, random);
                if random.unit() < 0.035 {
                    joints.push(Vec3::new(x, 0.0, z + wave));
                }
            }
            x += width;
        }
        z += depth;
    }
    joints
}

fn add_cobble(model: &mut Model, middle: Vec3, half: Vec2, random: &mut Random) {
    const SIDES: usize = 8;
    let height = random.range(0.022, 0.038);
    let tilt = Vec2::new(random.range(-0.06, 0.06), random.range(-0.06, 0.06));
    let patch = fractal(Vec3::new(0.7 * middle.x, 0.0, 0.7 * middle.z), 3, 61);
    let near_wall = (middle.x - YARD[0].x).min(YARD[1].x - middle.x).min(middle.z - YARD[0].y);
    let damp = 0.72 + 0.28 * smoothstep(0.0, 1.1, near_wall + 0.5 * patch);
    let variant = if near_wall < 0.5 && random.unit() < 0.4 { 9 } else { pattern(middle, random) };
    let shade = (damp * (0.86 + 0.24 * patch) + random.range(-0.1, 0.08)).clamp(0.2, 1.0);
    let mesh = model.mesh("stone");
    let top =
        mesh.vertex(middle + Vec3::Y * height, Vec3::new(-tilt.x, 1.0, -tilt.y).normalize(), STONE.at(variant, shade));
    // Rings from the crown to the foot: size, height, how steep, light.
    let rings = [(0.72, 0.93, 0.25, 0.97), (0.94, 0.62, 1.0, 0.7), (1.0, 0.0, 3.0, 0.15)];
    let turn = random.range(0.0, 45.0);
    let mut before: Option<Vec<usize>> = None;
    for (size, rise, steep, light) in rings {
        let ring: Vec<usize> = (0..SIDES)
            .map(|side| {
                let degrees = f64::from(22.5 + 45.0 * side as f32 + 0.15 * turn);
                let (sine, cosine) = sin_cos_degrees(degrees);
                // A square with rounded corners: the circle pushed out along its diagonals.
                let round = Vec2::new(cosine as f32, sine as f32);
                let square = round / round.abs().max_element();
                let offset = round.lerp(square, 0.6) * half * size;
                let y = height * rise + tilt.dot(offset) * rise;
                let normal = Vec3::new(steep * round.x - tilt.x, 1.0, steep * round.y - tilt.y).normalize();
                mesh.vertex(middle + Vec3::new(offset.x, y, offset.y), normal, STONE.at(variant, shade * light))
            })
            .collect();
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            match &before {
                None => mesh.triangle([top, ring[next], ring[side]]),
                Some(inner) => {
                    mesh.triangle([inner[side], inner[next], ring[next]]);
                    mesh.triangle([inner[side], ring[next], ring[side]]);
                }
            }
        }
        before = Some(ring);
    }
}

/// Colour of a stone: two pale rings round a rosette, a pale gutter across the yard, all others mixed.
fn pattern(place: Vec3, random: &mut Random) -> usize {
    const PALE: [usize; 3] = [2, 7, 2];
    const DARK: [usize; 3] = [3, 6, 5];
    let ring = Vec2::new(place.x - 0.55, place.z + 0.35).length();
    let gutter = (0.8 * place.x + 0.6 * place.z - 2.7).abs() < 0.14 && ring > 1.6;
    let choice = random.index(3);
    if (1.35..1.55).contains(&ring) || (0.5..0.66).contains(&ring) || gutter {
        PALE[choice]
    } else if ring < 1.35 && random.unit() < 0.9 {
        DARK[choice]
    } else {
        random.index(9)
    }
}

/// The soil in the joints and under the grass.
pub fn build_soil(model: &mut Model) {
    let [low, high] = YARD;
    let corners = [(low.x, high.y), (high.x, high.y), (high.x, low.y), (low.x, low.y)];
    let texture = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    model.mesh("soil").quad(corners.map(|(x, z)| Vec3::new(x, 0.0, z)), texture.map(|(u, v)| Vec2::new(u, v)));
}

pub fn write_soil(folder: &Path) -> Result<()> {
    const SIZE: usize = 1536;
    write_picture(&folder.join("soil.png"), SIZE, SIZE, |x, y| {
        let place = YARD[0] + (YARD[1] - YARD[0]) * Vec2::new(x, y) / SIZE as f32;
        let point = Vec3::new(place.x, 0.0, place.y);
        let sand = srgb([112, 100, 82]).lerp(srgb([84, 76, 62]), 0.5 + 0.5 * fractal(2.0 * point, 5, 81));
        let turf = srgb([66, 82, 38]).lerp(srgb([92, 92, 50]), 0.5 + 0.5 * fractal(6.0 * point, 5, 82));
        sand.lerp(turf, lawn(place)) * (0.62 + 0.2 * fractal(30.0 * point, 3, 83))
    })
}

const SECTORS: usize = 360;
const RINGS: usize = 110;
const INNER: f32 = 6.0;
const OUTER: f32 = 1500.0;

/// Height of the land around the yard: flat near it, hills far away.
pub fn land_height(place: Vec2) -> f32 {
    let distance = place.length();
    let point = Vec3::new(place.x, 0.0, place.y);
    let near = 0.7 * smoothstep(12.0, 40.0, distance) * fractal(0.05 * point, 3, 91);
    let hills = 42.0 + 110.0 * fractal(0.0021 * point + Vec3::splat(4.2), 5, 92);
    let far = 90.0 * smoothstep(600.0, 1400.0, distance) * (0.6 + fractal(0.003 * point, 4, 94));
    -0.06 + near + (hills.max(0.0) + far) * smoothstep(45.0, 700.0, distance)
}

/// Radius of a ring of the land, growing by a constant factor.
fn ring_radius(fraction: f32) -> f32 {
    INNER * skycube::math::functions::power(OUTER / INNER, fraction)
}

pub fn build_land(model: &mut Model) {
    let mesh = model.mesh("land");
    for ring in 0..=RINGS {
        for sector in 0..=SECTORS {
            let turn = sector as f32 / SECTORS as f32;
            let (sine, cosine) = sin_cos_degrees(f64::from(360.0 * turn));
            let radius = ring_radius(ring as f32 / RINGS as f32);
            let place = Vec2::new(cosine as f32, sine as f32) * radius;
            let step = 0.02 * radius;
            let slope = |offset: Vec2| (land_height(place + offset) - land_height(place - offset)) / (2.0 * step);
            let normal = Vec3::new(-slope(Vec2::new(step, 0.0)), 1.0, -slope(Vec2::new(0.0, step))).normalize();
            let point = Vec3::new(place.x, land_height(place), place.y);
            mesh.vertex(point, normal, Vec2::new(turn, ring as f32 / RINGS as f32));
        }
    }
    for ring in 0..RINGS {
        for sector in 0..SECTORS {
            let a = ring * (SECTORS + 1) + sector;
            let b = a + SECTORS + 1;
            mesh.triangle([a, a + 1, b + 1]);
            mesh.triangle([a, b + 1, b]);
        }
    }
}

/// Meadows, fields, woods; far ones pale with air.
pub fn write_land(folder: &Path) -> Result<()> {
    let (width, height) = (4096, 1024);
    write_picture(&folder.join("land.png"), width, height, |x, y| {
        let radius = ring_radius(1.0 - y / height as f32);
        let (sine, cosine) = sin_cos_degrees(f64::from(360.0 * x / width as f32));
        let place = Vec2::new(cosine as f32, sine as f32) * radius;
        let point = Vec3::new(place.x, 0.0, place.y);
        let meadow = srgb([98, 122, 58]).lerp(srgb([134, 138, 74]), 0.5 + 0.5 * fractal(0.9 * point, 5, 101));
        let bent = place + 14.0 * Vec2::new(fractal(0.02 * point, 3, 102), fractal(0.02 * point, 3, 103));
        let (field_x, field_z) = ((bent.x / 70.0).floor() as i64, (bent.y / 48.0).floor() as i64);
        let kind = cell(field_x, field_z, 0, 104);
        let field = match (kind * 6.0) as usize {
            0 => srgb([190, 172, 96]),
            1 => srgb([122, 142, 62]),
            2 => srgb([142, 118, 82]),
            _ => meadow,
        };
        let wood = smoothstep(0.08, 0.16, fractal(0.011 * point, 5, 105));
        let trees = srgb([46, 74, 38]) * (0.75 + 0.5 * fractal(0.35 * point, 4, 106));
        let land =
            meadow.lerp(field, smoothstep(30.0, 60.0, radius)).lerp(trees, wood * smoothstep(60.0, 120.0, radius));
        land.lerp(Vec3::new(0.42, 0.55, 0.76), 0.85 * (1.0 - exponential(-radius / 800.0)))
    })
}
