//! Pictures of walls: plaster and brick with weathering, darker at the foot, under the eaves and at openings.

use std::path::Path;

use skycube::error::Result;
use skycube::math::{Vec2, Vec3};
use skycube::report::{Anchor, text_path};

use crate::noise::{cell, fractal, smoothstep};
use crate::paint::{srgb, write_picture};

/// Texels a metre of wall.
const DENSITY: f32 = 110.0;

#[derive(Clone, Copy)]
pub enum Finish {
    Plaster([u8; 3]),
    Brick,
    Rubble,
}

/// An opening of a wall in metres from its lower left corner, seen from outside.
#[derive(Clone, Copy)]
pub struct Opening {
    pub low: Vec2,
    pub high: Vec2,
    pub door: bool,
}

/// What a wall looks like.
pub struct Facade {
    pub name: &'static str,
    pub size: Vec2,
    pub finish: Finish,
    pub openings: Vec<Opening>,
    pub seed: u64,
}

impl Facade {
    pub fn write(&self, folder: &Path) -> Result<()> {
        let texels = self.size * DENSITY;
        write_picture(&folder.join(self.name).with_extension("png"), texels.x as usize, texels.y as usize, |x, y| {
            self.colour(Vec2::new(x / DENSITY, self.size.y - y / DENSITY))
        })
    }

    fn colour(&self, place: Vec2) -> Vec3 {
        let surface = match self.finish {
            Finish::Plaster(codes) => self.plaster(codes, place),
            Finish::Brick => self.brick(place),
            Finish::Rubble => self.rubble(place),
        };
        surface * self.weathering(place)
    }

    fn noise(&self, place: Vec2, scale: f32, octaves: usize, layer: u64) -> f32 {
        fractal(Vec3::new(place.x, 0.0, place.y) * scale, octaves, self.seed + 10 * layer)
    }

    /// Rough plaster with stains; where it has come off the bricks show.
    fn plaster(&self, codes: [u8; 3], place: Vec2) -> Vec3 {
        let grain = 1.0 + 0.05 * self.noise(place, 30.0, 3, 1) + 0.08 * self.noise(place, 1.2, 5, 2);
        let streaks = smoothstep(0.15, 0.7, self.noise(place * Vec2::new(5.0, 0.35), 1.0, 4, 3));
        let plaster = srgb(codes) * grain * (1.0 - 0.16 * streaks);
        let foot = 0.35 * (1.0 - smoothstep(0.0, 1.6, place.y));
        let worn = self.noise(place, 0.9, 6, 4) + foot - 0.46;
        let rim = 1.0 - 0.3 * smoothstep(-0.06, 0.0, worn) * (1.0 - smoothstep(0.0, 0.05, worn));
        plaster.lerp(self.brick(place), smoothstep(0.0, 0.02, worn)) * rim
    }

    /// Running bond: stretchers of 24 by 7.1 cm with joints of 1 cm.
    fn brick(&self, place: Vec2) -> Vec3 {
        let (length, course, joint) = (0.25, 0.0813, 0.011);
        let row = (place.y / course).floor();
        let along = place.x + 0.5 * length * (row as i64 % 2) as f32;
        let column = (along / length).floor();
        let inside = Vec2::new(along - column * length, place.y - row * course);
        let edge = inside.min(Vec2::new(length, course) - inside).min_element();
        let wobble = 0.003 * self.noise(place, 26.0, 2, 5);
        let mortar = srgb([176, 166, 150]) * (0.9 + 0.12 * self.noise(place, 40.0, 3, 6));
        let tone = cell(column as i64, row as i64, 0, self.seed);
        let warm = srgb([160, 82, 60]).lerp(srgb([124, 62, 52]), tone);
        let burnt = if tone > 0.9 { srgb([86, 62, 60]) } else { warm };
        let brick = burnt * (1.0 + 0.14 * self.noise(place, 22.0, 4, 7));
        // The lower side of a brick lies in the shadow of its edge.
        let relief = 0.8 + 0.2 * smoothstep(0.0, 0.025, inside.y);
        mortar.lerp(brick * relief, smoothstep(0.3 * joint, 0.7 * joint, edge + wobble))
    }

    /// Field stones in mortar: the cells of scattered points.
    fn rubble(&self, place: Vec2) -> Vec3 {
        let grid = place * Vec2::new(3.6, 5.4) + 0.25 * Vec2::splat(self.noise(place, 4.0, 3, 8));
        let (x, y) = (grid.x.floor() as i64, grid.y.floor() as i64);
        let (mut nearest, mut second, mut stone) = (9.0_f32, 9.0_f32, 0.0);
        for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
            let point = |layer| cell(x + dx, y + dy, layer, self.seed);
            let middle = Vec2::new((x + dx) as f32 + 0.15 + 0.7 * point(1), (y + dy) as f32 + 0.15 + 0.7 * point(2));
            let distance = grid.distance(middle);
            if distance < nearest {
                (second, nearest, stone) = (nearest, distance, point(3));
            } else {
                second = second.min(distance);
            }
        }
        let colour =
            srgb([150, 138, 118]).lerp(srgb([98, 96, 96]), stone) * (1.0 + 0.2 * self.noise(place, 14.0, 5, 9));
        let mortar = srgb([120, 112, 98]) * 0.7;
        mortar.lerp(colour * (0.75 + 0.5 * (second - nearest).min(0.5)), smoothstep(0.03, 0.14, second - nearest))
    }

    /// Factor by dirt and by light that does not reach: splashes at the foot, eaves, openings, rain below sills.
    fn weathering(&self, place: Vec2) -> f32 {
        let ragged = 0.25 * self.noise(place, 3.0, 4, 11);
        let foot = 0.45 + 0.55 * smoothstep(-0.1, 0.8, place.y + ragged);
        let eaves = 0.55 + 0.45 * smoothstep(0.0, 0.9, self.size.y - place.y);
        let corner = 0.85 + 0.15 * smoothstep(0.0, 0.35, place.x.min(self.size.x - place.x));
        let mut factor = foot * eaves * corner;
        for opening in &self.openings {
            let outside = (opening.low - place).max(place - opening.high).max(Vec2::ZERO).length();
            factor *= 0.82 + 0.18 * smoothstep(0.0, 0.16, outside);
            if !opening.door && place.y < opening.low.y && place.x > opening.low.x && place.x < opening.high.x {
                let below = opening.low.y - place.y;
                let run = smoothstep(-0.1, 0.6, self.noise(place * Vec2::new(9.0, 0.6), 1.0, 3, 12));
                factor *= 1.0 - 0.3 * run * (1.0 - smoothstep(0.2, 1.3, below));
            }
        }
        factor
    }
}

/// The sign board: letters on painted wood. Read the wrong way round, the map is mirrored.
pub fn write_sign(folder: &Path) -> Result<()> {
    const WIDTH: u32 = 768;
    const HEIGHT: u32 = 160;
    let mut letters = tiny_skia::Mask::new(WIDTH, HEIGHT).expect("a sign has texels");
    let place = tiny_skia::Transform::from_translate(0.5 * WIDTH as f32, 122.0);
    let path = text_path("SKYCUBE INN", 116.0, Anchor::Middle).expect("letters have outlines");
    letters.fill_path(&path, tiny_skia::FillRule::Winding, true, place);
    write_picture(&folder.join("sign.png"), WIDTH as usize, HEIGHT as usize, |x, y| {
        let grain = 1.0 + 0.2 * fractal(Vec3::new(0.01 * x, 0.0, 0.16 * y), 4, 91);
        let frame = x.min(WIDTH as f32 - x).min(y).min(HEIGHT as f32 - y) < 9.0;
        let board = if frame { srgb([196, 160, 84]) } else { srgb([26, 54, 70]) };
        let coverage = f32::from(letters.data()[y as usize * WIDTH as usize + x as usize]) / 255.0;
        board.lerp(srgb([236, 214, 150]), coverage) * grain
    })
}
