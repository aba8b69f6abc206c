//! Worlds drawn by direction, at any number of texels: what is right is known.

use super::picture_of;
use crate::envmap::{Face, FacePoint, Preset};
use crate::math::Vec3;
use crate::math::functions::floor;
use crate::parallel;
use crate::picture::Picture;

/// The display colour of a sky without detail.
const FLAT_SKY: [f32; 3] = [150.0, 180.0, 220.0];

/// What is to be seen around.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum World {
    /// Blocks of all sizes under a clouded sky: detail everywhere.
    City,
    /// Hills of soft earth under a sky that fades upwards.
    Hills,
    /// A panelled room, bright lamps above.
    Room,
}

impl World {
    pub const ALL: [Self; 3] = [Self::City, Self::Hills, Self::Room];

    /// The world from which a foreign picture comes.
    pub fn next(self) -> Self {
        Self::ALL[(self as usize + 1) % Self::ALL.len()]
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::City => "city",
            Self::Hills => "hills",
            Self::Room => "room",
        }
    }

    /// The six pictures under the `opengl` lookup.
    pub fn faces(self, size: usize) -> [Picture; 6] {
        Face::ALL.map(|face| self.face(face, size))
    }

    /// The picture of one face.
    pub fn face(self, face: Face, size: usize) -> Picture {
        self.face_below(face, size, f32::INFINITY)
    }

    /// The six pictures under a sky of one colour, which comes down to this height of the cube from -1 to 1.
    pub fn faces_below(self, size: usize, height: f32) -> [Picture; 6] {
        Face::ALL.map(|face| self.face_below(face, size, height))
    }

    fn face_below(self, face: Face, size: usize, height: f32) -> Picture {
        let lookup = Preset::Opengl.lookup();
        let centre = |index: usize| (index as f32 + 0.5) / size as f32;
        let row = |y: usize| -> Vec<u8> {
            let direction = |x: usize| lookup.direction(FacePoint { face, u: centre(x), v: centre(y) });
            let colour = |d: Vec3| if d.y > height { FLAT_SKY } else { self.colour(d.normalize()) };
            (0..size).flat_map(|x| colour(direction(x)).map(code)).collect()
        };
        picture_of(size, parallel::map(0..size, row).concat())
    }

    /// Display colours from 0 to 255 in a direction; +y is up.
    fn colour(self, d: Vec3) -> [f32; 3] {
        match self {
            Self::City => {
                let blocks = step_noise(d * 6.0, 1) + 0.6 * step_noise(d * 15.0, 2) + 0.3 * fractal(d * 20.0, 3);
                let clouds = fractal(d * 4.0, 4);
                let built = d.y < 0.25 + 0.3 * step_noise(d * Vec3::new(7.0, 0.0, 7.0), 5);
                if built {
                    [40.0 + 80.0 * blocks, 38.0 + 75.0 * blocks, 45.0 + 60.0 * blocks]
                } else {
                    [120.0 + 100.0 * clouds, 150.0 + 80.0 * clouds, 200.0 + 40.0 * clouds]
                }
            }
            Self::Hills => {
                let earth = fractal(d * 9.0, 6);
                let rise = 0.25 * noise(d * 3.0, 7) - 0.1;
                if d.y < rise {
                    [60.0 + 90.0 * earth, 70.0 + 80.0 * earth, 30.0 + 50.0 * earth]
                } else {
                    let height = d.y - rise;
                    let haze = 25.0 * noise(d * 2.0, 8);
                    [190.0 - 90.0 * height + haze, 210.0 - 70.0 * height + haze, 235.0 - 30.0 * height]
                }
            }
            Self::Room => {
                let cube = d / d.abs().max_element();
                let panels = step_noise(cube * 2.5, 9);
                let grain = fractal(cube * Vec3::new(12.0, 2.0, 12.0), 10);
                let light = 0.5 + 0.5 * (0.5 + 0.5 * d.y);
                let lamp = if d.y > 0.7 && step_noise(cube * 6.0, 11) > 0.8 { 90.0 } else { 0.0 };
                let wood = light * (50.0 + 90.0 * panels + 60.0 * grain) + lamp;
                [wood, 0.8 * wood + 5.0, 0.55 * wood + 8.0]
            }
        }
    }
}

fn code(value: f32) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

/// Five octaves of noise, from 0 to 1.
fn fractal(place: Vec3, seed: u64) -> f32 {
    let octave = |power: i32| noise(place * (1 << power) as f32, seed + 100 * power as u64) / (2 << power) as f32;
    (0..5).map(octave).sum()
}

/// Even blocks, each of its own value from 0 to 1.
fn step_noise(place: Vec3, seed: u64) -> f32 {
    value_at(place.to_array().map(|coordinate| floor(f64::from(coordinate))), seed)
}

/// Smooth noise from 0 to 1: values at whole coordinates, interpolated.
fn noise(place: Vec3, seed: u64) -> f32 {
    let cell = place.to_array().map(|coordinate| floor(f64::from(coordinate)));
    let within: [f32; 3] = std::array::from_fn(|axis| {
        let part = place[axis] - cell[axis] as f32;
        part * part * (3.0 - 2.0 * part)
    });
    let corner = |number: i64| {
        let bit = |axis: usize| number >> axis & 1;
        let weight = |axis: usize| if bit(axis) == 1 { within[axis] } else { 1.0 - within[axis] };
        let value = value_at(std::array::from_fn(|axis| cell[axis] + bit(axis)), seed);
        value * weight(0) * weight(1) * weight(2)
    };
    (0..8).map(corner).sum()
}

/// The value of a cell: its coordinates, hashed.
fn value_at(cell: [i64; 3], seed: u64) -> f32 {
    let mixed =
        |hash: u64, coordinate: &i64| (hash ^ *coordinate as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29);
    let hash = cell.iter().fold(seed.wrapping_mul(0x2545_F491_4F6C_DD1D), mixed);
    let hash = (hash ^ hash >> 32).wrapping_mul(0xD6E8_FEB8_6659_FD93);
    (hash >> 40) as f32 / (1_u64 << 24) as f32
}
