//! Buildings: walls with openings, windows and doors, tiled roofs.

use skycube::math::{Vec2, Vec3};

use crate::facades::{Facade, Opening};
use crate::model::Model;
use crate::noise::Random;
use crate::paint::{CLAY, FLOWER, LEAF, ROOF, WOOD};

/// Depth of window and door reveals in metres.
const REVEAL: f32 = 0.18;

/// A wall's place: its lower left corner seen from outside, and the horizontal unit vector to its right.
#[derive(Clone, Copy)]
pub struct Place {
    pub corner: Vec3,
    pub right: Vec3,
}

impl Place {
    /// The point `x` along, `y` up and `out` before the wall.
    fn point(&self, x: f32, y: f32, out: f32) -> Vec3 {
        self.corner + self.right * x + Vec3::Y * y + self.right.cross(Vec3::Y) * out
    }

    fn slab(&self, model: &mut Model, material: &str, low: [f32; 3], high: [f32; 3], texture: [Vec2; 2]) {
        let middle = self.point(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2]));
        let half = [0, 1, 2].map(|axis| 0.5 * (high[axis] - low[axis]));
        let edges = [self.right * half[0], Vec3::Y * half[1], self.right.cross(Vec3::Y) * half[2]];
        model.mesh(material).cuboid(middle, edges, texture[0], texture[1]);
    }
}

/// A wall with its openings cut out, and what fills them.
pub fn build_wall(model: &mut Model, place: Place, facade: &Facade, trim: usize, random: &mut Random) {
    let mut columns = vec![0.0, facade.size.x];
    let mut rows = vec![0.0, facade.size.y];
    for opening in &facade.openings {
        columns.extend([opening.low.x, opening.high.x]);
        rows.extend([opening.low.y, opening.high.y]);
    }
    columns.sort_by(f32::total_cmp);
    rows.sort_by(f32::total_cmp);
    for x in columns.windows(2) {
        for y in rows.windows(2) {
            let middle = Vec2::new(0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]));
            let open = |opening: &Opening| middle.cmpgt(opening.low).all() && middle.cmplt(opening.high).all();
            if !facade.openings.iter().any(open) {
                let corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])];
                let texture = corners.map(|(x, y)| Vec2::new(x, y) / facade.size);
                model.mesh(facade.name).quad(corners.map(|(x, y)| place.point(x, y, 0.0)), texture);
            }
        }
    }
    for opening in &facade.openings {
        build_reveal(model, place, facade, opening);
        if opening.door {
            build_door(model, place, opening, trim)
        } else {
            build_window(model, place, opening, trim, random)
        }
    }
}

/// The four sides of an opening, with the wall's picture beside them.
fn build_reveal(model: &mut Model, place: Place, facade: &Facade, opening: &Opening) {
    let (low, high) = (opening.low, opening.high);
    let corners = [low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)];
    for side in 0..4 {
        let (a, b) = (corners[side], corners[(side + 1) % 4]);
        let texture = [a, b, b, a].map(|corner| corner / facade.size);
        let points = [
            place.point(a.x, a.y, 0.0),
            place.point(b.x, b.y, 0.0),
            place.point(b.x, b.y, -REVEAL),
            place.point(a.x, a.y, -REVEAL),
        ];
        model.mesh(facade.name).quad(points, texture);
    }
}

/// Panes, a frame with bars, a sill, shutters to some and a flower box to some.
fn build_window(model: &mut Model, place: Place, opening: &Opening, trim: usize, random: &mut Random) {
    let (low, high) = (opening.low, opening.high);
    let size = high - low;
    let corners = [(low.x, low.y), (high.x, low.y), (high.x, high.y), (low.x, high.y)];
    let shift = 0.3 * random.unit();
    let texture = [(0.0, 0.0), (0.7, 0.0), (0.7, 1.0), (0.0, 1.0)].map(|(u, v)| Vec2::new(u + shift, v));
    model.mesh("pane").quad(corners.map(|(x, y)| place.point(x, y, -REVEAL + 0.02)), texture);
    let light = [WOOD.at(6, 0.55), WOOD.at(6, 0.9)];
    let bar = 0.03;
    for x in [low.x + bar, 0.5 * (low.x + high.x), high.x - bar] {
        place.slab(model, "wood", [x - bar, low.y, -REVEAL], [x + bar, high.y, -REVEAL + 0.07], light);
    }
    for y in [low.y + bar, low.y + 0.62 * size.y, high.y - bar] {
        place.slab(model, "wood", [low.x, y - bar, -REVEAL], [high.x, y + bar, -REVEAL + 0.06], light);
    }
    let sill = [low.x - 0.1, low.y - 0.09, -0.05];
    place.slab(model, "stone", sill, [high.x + 0.1, low.y, 0.12], [Vec2::new(0.25, 0.4), Vec2::new(0.25, 0.9)]);
    if random.unit() < 0.75 {
        build_shutters(model, place, opening, trim);
    }
    if random.unit() < 0.5 {
        build_flower_box(model, place, opening, random);
    }
}

fn build_shutters(model: &mut Model, place: Place, opening: &Opening, trim: usize) {
    let (low, high) = (opening.low, opening.high);
    let width = 0.5 * (high.x - low.x);
    for left in [low.x - width - 0.04, high.x + 0.04] {
        let light = [WOOD.at(trim, 0.6), WOOD.at(trim, 0.9)];
        place.slab(model, "wood", [left, low.y, 0.01], [left + width, high.y, 0.04], light);
        let slats = ((high.y - low.y) / 0.085) as usize;
        for slat in 0..slats {
            let y = low.y + 0.04 + slat as f32 * (high.y - low.y - 0.06) / slats as f32;
            let light = [WOOD.at(trim, 0.3), WOOD.at(trim, 0.95)];
            place.slab(model, "wood", [left + 0.05, y, 0.04], [left + width - 0.05, y + 0.045, 0.065], light);
        }
    }
}

fn build_flower_box(model: &mut Model, place: Place, opening: &Opening, random: &mut Random) {
    let (left, right, y) = (opening.low.x, opening.high.x, opening.low.y);
    place.slab(model, "clay", [left, y, 0.02], [right, y + 0.16, 0.22], [CLAY.at(0, 0.5), CLAY.at(0, 0.9)]);
    let colour = random.index(6);
    for leaf in 0..260 {
        let place = place.point(random.range(left, right), y + random.range(0.1, 0.38), random.range(0.03, 0.3));
        let blossom = leaf % 3 == 0;
        let (palette, variant) = if blossom { (&FLOWER, colour) } else { (&LEAF, leaf) };
        let size = if blossom { 0.025 } else { 0.035 };
        crate::plants::add_leaf(model, palette.name, place, size, palette.at(variant, random.range(0.5, 1.0)), random);
    }
}

/// A leaf of boards with a handle, in a frame, and a step.
fn build_door(model: &mut Model, place: Place, opening: &Opening, trim: usize) {
    let (low, high) = (opening.low, opening.high);
    let boards = ((high.x - low.x) / 0.14) as usize;
    let width = (high.x - low.x) / boards as f32;
    for board in 0..boards {
        let x = low.x + board as f32 * width;
        let light = [WOOD.at(trim, 0.45), WOOD.at(trim, 0.75 + 0.1 * (board % 3) as f32)];
        place.slab(model, "wood", [x + 0.006, low.y, -REVEAL], [x + width - 0.006, high.y, -REVEAL + 0.04], light);
    }
    for y in [low.y + 0.3, high.y - 0.35] {
        let light = [WOOD.at(3, 0.3), WOOD.at(3, 0.7)];
        place.slab(model, "wood", [low.x + 0.05, y, -REVEAL], [high.x - 0.05, y + 0.13, -REVEAL + 0.07], light);
    }
    let handle = high.x - 0.16;
    let dark = [WOOD.at(3, 0.05), WOOD.at(3, 0.2)];
    place.slab(model, "wood", [handle, low.y + 0.95, -REVEAL], [handle + 0.04, low.y + 1.15, -REVEAL + 0.12], dark);
    let step = [Vec2::new(0.05, 0.4), Vec2::new(0.05, 0.95)];
    place.slab(model, "stone", [low.x - 0.25, -0.02, -0.1], [high.x + 0.25, low.y, 0.45], step);
}

/// One slope of a tiled roof: from the eaves' left end (seen from outside) along the eaves and up to the ridge.
pub fn build_roof(model: &mut Model, eaves: Vec3, along: Vec3, up: Vec3, random: &mut Random) {
    let normal = along.cross(up).normalize();
    let under = [eaves, eaves + along, eaves + along + up, eaves + up].map(|corner| corner - 0.04 * normal);
    let dark = ROOF.at(5, 0.05);
    model.mesh("roof").quad(under, [dark; 4]);
    model
        .mesh("roof")
        .quad([under[3], under[2], under[1], under[0]].map(|corner| corner - 0.01 * normal), [WOOD.at(1, 0.1); 4]);
    let (columns, rows) = ((along.length() / 0.21) as usize, (up.length() / 0.30) as usize);
    let (across, rise) = (along / columns as f32, up / rows as f32);
    for row in 0..rows {
        for column in 0..columns {
            let jitter = 0.012 * random.in_ball();
            let low = eaves + across * (column as f32 + 0.5) + rise * (row as f32 - 0.12) + jitter + 0.035 * normal;
            let high = low + rise * 1.2 - 0.03 * normal;
            let variant = random.index(8);
            let moss = if random.unit() < 0.06 { 0.45 } else { random.range(0.75, 1.0) };
            add_tile(model, [low, high], across, normal, variant, moss);
        }
    }
}

/// A half round tile between two points of its middle line.
fn add_tile(model: &mut Model, line: [Vec3; 2], across: Vec3, normal: Vec3, variant: usize, light: f32) {
    // Points of the arch: offset across, height, light.
    let arch = [(-0.55, 0.0, 0.25), (-0.36, 0.055, 0.8), (0.0, 0.085, 1.0), (0.36, 0.055, 0.8), (0.55, 0.0, 0.25)];
    let mesh = model.mesh("roof");
    let mut vertices = Vec::with_capacity(10);
    for (offset, height, shade) in arch {
        let slope = (normal + across.normalize() * (1.6 * offset)).normalize();
        for end in line {
            let point = end + across * offset + normal * height;
            vertices.push(mesh.vertex(point, slope, ROOF.at(variant, shade * light)));
        }
    }
    for strip in 0..4 {
        let a = &vertices[2 * strip..2 * strip + 4];
        mesh.triangle([a[0], a[2], a[3]]);
        mesh.triangle([a[0], a[3], a[1]]);
    }
}
