//! Repeatable randomness: a generator of numbers, and noise over space.

use skycube::math::Vec3;

/// A small generator of repeatable numbers (SplitMix64, Steele, Lea and Flood 2014).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        (mix(self.0) >> 40) as f32 / (1_u32 << 24) as f32
    }

    pub fn range(&mut self, from: f32, to: f32) -> f32 {
        from + (to - from) * self.unit()
    }

    pub fn index(&mut self, count: usize) -> usize {
        ((self.unit() * count as f32) as usize).min(count - 1)
    }

    /// A point of the unit ball.
    pub fn in_ball(&mut self) -> Vec3 {
        loop {
            let point = Vec3::new(self.range(-1.0, 1.0), self.range(-1.0, 1.0), self.range(-1.0, 1.0));
            if point.length_squared() <= 1.0 {
                return point;
            }
        }
    }
}

fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// A number in [0, 1) for every cell of a lattice.
pub fn cell(x: i64, y: i64, z: i64, seed: u64) -> f32 {
    let key = (x as u64).wrapping_mul(0x8cb9_2ba7_2f3d_8dd7)
        ^ (y as u64).wrapping_mul(0xd6e8_feb8_6659_fd93)
        ^ (z as u64).wrapping_mul(0xa076_1d64_78bd_642f)
        ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mix(key) >> 40) as f32 / (1_u32 << 24) as f32
}

/// Value noise in [-1, 1], smooth, features about 1 wide.
pub fn noise(point: Vec3, seed: u64) -> f32 {
    let floor = point.floor();
    let fraction = point - floor;
    let ease = fraction * fraction * (Vec3::splat(3.0) - 2.0 * fraction);
    let (x, y, z) = (floor.x as i64, floor.y as i64, floor.z as i64);
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    let edge = |dy: i64, dz: i64| mix(cell(x, y + dy, z + dz, seed), cell(x + 1, y + dy, z + dz, seed), ease.x);
    let plane = |dz: i64| mix(edge(0, dz), edge(1, dz), ease.y);
    2.0 * mix(plane(0), plane(1), ease.z) - 1.0
}

/// A sum of octaves of noise, each half as large and half as strong as the one before; about [-1, 1].
pub fn fractal(mut point: Vec3, octaves: usize, seed: u64) -> f32 {
    let (mut sum, mut weight, mut total) = (0.0, 1.0, 0.0);
    for octave in 0..octaves {
        sum += weight * noise(point, seed + octave as u64);
        total += weight;
        weight *= 0.5;
        // Turning by the 3-4-5 triangle keeps the lattices of the octaves from lining up.
        point = 2.0 * Vec3::new(0.8 * point.x - 0.6 * point.z, point.y + 0.37, 0.6 * point.x + 0.8 * point.z);
    }
    1.4 * sum / total
}

/// Cubic step from 0 at `start` to 1 at `end`.
pub fn smoothstep(start: f32, end: f32, value: f32) -> f32 {
    let x = ((value - start) / (end - start)).clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}
