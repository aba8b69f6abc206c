//! The distribution of light over the sphere: concentrated in few directions, or uniform.

use super::cells::Cell;

/// Power and solid angle, sorted by radiance into classes 1/256 of an octave wide or a little more.
#[derive(Debug, Clone)]
pub(super) struct BrightnessHistogram {
    classes: Vec<Cell>,
}

/// Bits of an `f32` that do not decide the class: what is left is the exponent and eight bits of the fraction.
const DROPPED_BITS: u32 = 15;

impl BrightnessHistogram {
    pub(super) fn new() -> Self {
        Self { classes: vec![Cell::default(); 1 << (31 - DROPPED_BITS)] }
    }

    pub(super) fn add(&mut self, cell: Cell) {
        let radiance = (cell.power / cell.solid_angle) as f32;
        // The bits of positive floats are in the order of their values.
        let class = &mut self.classes[(radiance.max(0.0).to_bits() >> DROPPED_BITS) as usize];
        class.power += cell.power;
        class.solid_angle += cell.solid_angle;
    }

    /// The share of the power that comes from the brightest directions which together make up `share` of the sphere.
    pub(super) fn power_of_brightest(&self, share: f64) -> f64 {
        let total: f64 = self.classes.iter().map(|class| class.power).sum();
        let sphere: f64 = self.classes.iter().map(|class| class.solid_angle).sum();
        if total <= 0.0 {
            return 0.0;
        }
        let (mut left, mut power) = (share * sphere, 0.0);
        for class in self.classes.iter().rev().filter(|class| class.solid_angle > 0.0) {
            if class.solid_angle >= left {
                power += class.power * (left / class.solid_angle);
                break;
            }
            left -= class.solid_angle;
            power += class.power;
        }
        power / total
    }
}
