//! The colours of verdicts in drawings.

use tiny_skia::Color;

use crate::validate::Verdict;

/// Blue, vermilion and yellow of Okabe and Ito, which people with any kind of colour vision tell apart.
pub fn verdict_colour(verdict: Verdict) -> Color {
    let [red, green, blue] = verdict_rgb(verdict);
    Color::from_rgba8(red, green, blue, 255)
}

fn verdict_rgb(verdict: Verdict) -> [u8; 3] {
    match verdict {
        Verdict::Fits => [0, 114, 178],
        Verdict::Broken => [213, 94, 0],
        Verdict::Undecidable => [240, 228, 66],
    }
}

/// The colour of the words of a repair on a dark plate: orange of the same palette.
pub fn repair_colour() -> Color {
    Color::from_rgba8(230, 159, 0, 255)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::{SRGB8_TO_LINEAR, encode_srgb};

    /// What people without one kind of cones see, of linear RGB: Machado, Oliveira and Fernandes, "A Physiologically-based
    /// Model for Simulation of Color Vision Deficiency", 2009, severity 1.
    const PROTANOPIA: [[f32; 3]; 3] =
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]];
    const DEUTERANOPIA: [[f32; 3]; 3] =
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]];
    const TRITANOPIA: [[f32; 3]; 3] =
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]];

    fn seen(matrix: [[f32; 3]; 3], rgb: [u8; 3]) -> [f32; 3] {
        let linear = rgb.map(|code| SRGB8_TO_LINEAR[usize::from(code)]);
        matrix.map(|row| {
            let sum: f32 = row.iter().zip(linear).map(|(weight, light)| weight * light).sum();
            255.0 * encode_srgb(sum.clamp(0.0, 1.0))
        })
    }

    /// The distance of two colours as seen, in codes.
    fn distance(matrix: [[f32; 3]; 3], one: [u8; 3], other: [u8; 3]) -> f32 {
        let (one, other) = (seen(matrix, one), seen(matrix, other));
        one.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f32>().sqrt()
    }

    #[test]
    fn the_colour_blind_tell_verdicts_apart() {
        let [fits, broken, undecidable] = [Verdict::Fits, Verdict::Broken, Verdict::Undecidable].map(verdict_rgb);
        let mut nearest_before = f32::INFINITY;
        for matrix in [PROTANOPIA, DEUTERANOPIA, TRITANOPIA] {
            assert!(distance(matrix, fits, broken) > 120.0, "{}", distance(matrix, fits, broken));
            for decided in [fits, broken] {
                assert!(distance(matrix, decided, undecidable) > 80.0, "{}", distance(matrix, decided, undecidable));
            }
            nearest_before = nearest_before.min(distance(matrix, [60, 200, 90], [240, 50, 40]));
        }
        // The test can fail: green and red do.
        assert!(nearest_before < 100.0, "{nearest_before}");
    }
}
