//! The colour spaces of FLIP: linear Rec. 709, the opponent space YCxCz, and CIE Lab. White is D65.

use crate::math::Vec3;
use crate::math::functions::cube_root;

/// CIE XYZ of the Rec. 709 primaries with white at (0.3127, 0.3290); rows X, Y, Z.
const XYZ_OF_LINEAR: [Vec3; 3] = [
    Vec3::new(0.412_390_8, 0.357_584_33, 0.180_480_8),
    Vec3::new(0.212_639, 0.715_168_65, 0.072_192_32),
    Vec3::new(0.019_330_818, 0.119_194_78, 0.950_532_14),
];

/// The inverse of that matrix; rows red, green, blue.
const LINEAR_OF_XYZ: [Vec3; 3] = [
    Vec3::new(3.240_97, -1.537_383_2, -0.498_610_76),
    Vec3::new(-0.969_243_65, 1.875_967_5, 0.041_555_06),
    Vec3::new(0.055_630_08, -0.203_976_96, 1.056_971_5),
];

/// XYZ of white: the sums of the rows.
const WHITE: Vec3 = Vec3::new(0.950_455_9, 1.0, 1.089_057_8);

fn product(matrix: &[Vec3; 3], colour: Vec3) -> Vec3 {
    Vec3::new(matrix[0].dot(colour), matrix[1].dot(colour), matrix[2].dot(colour))
}

/// XYZ relative to white, in `[0, 1]`.
fn relative_xyz(linear: Vec3) -> Vec3 {
    product(&XYZ_OF_LINEAR, linear) / WHITE
}

/// YCxCz of a linear colour: Lab without its cube root, so that it can be filtered.
pub fn opponent_of_linear(linear: Vec3) -> Vec3 {
    let xyz = relative_xyz(linear);
    Vec3::new(116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z))
}

/// CIE Lab of a colour in YCxCz, clamped to what a display shows.
pub fn lab_of_opponent(opponent: Vec3) -> Vec3 {
    let y = (opponent.x + 16.0) / 116.0;
    let xyz = Vec3::new(y + opponent.y / 500.0, y, y - opponent.z / 200.0) * WHITE;
    lab_of_linear(product(&LINEAR_OF_XYZ, xyz).clamp(Vec3::ZERO, Vec3::ONE))
}

/// CIE Lab of a linear colour.
pub fn lab_of_linear(linear: Vec3) -> Vec3 {
    const DELTA: f32 = 6.0 / 29.0;
    let root = |value: f32| {
        if value > DELTA * DELTA * DELTA { cube_root(value) } else { value / (3.0 * DELTA * DELTA) + 4.0 / 29.0 }
    };
    let [x, y, z] = relative_xyz(linear).to_array().map(root);
    Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
}

/// Lab with the Hunt effect: dark colours look less colourful.
pub fn hunt_adjusted(lab: Vec3) -> Vec3 {
    let share = 0.01 * lab.x;
    Vec3::new(lab.x, share * lab.y, share * lab.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrices_undo_each_other() {
        for colour in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ONE] {
            let back = product(&LINEAR_OF_XYZ, product(&XYZ_OF_LINEAR, colour));
            assert!((back - colour).abs().max_element() < 2e-6, "{colour} {back}");
        }
        assert!((product(&XYZ_OF_LINEAR, Vec3::ONE) - WHITE).abs().max_element() < 1e-6);
    }

    #[test]
    fn lab_knows_white_black_and_middle_grey() {
        assert!((lab_of_linear(Vec3::ONE) - Vec3::new(100.0, 0.0, 0.0)).abs().max_element() < 1e-3);
        assert!(lab_of_linear(Vec3::ZERO).abs().max_element() < 1e-4);
        // L = 50 is the luminance 0.18418 (CIE 15, 8.2.1).
        assert!((lab_of_linear(Vec3::splat(0.184_186_52)).x - 50.0).abs() < 1e-3);
    }

    #[test]
    fn the_opponent_space_leads_to_the_same_lab() {
        for colour in [Vec3::new(0.2, 0.5, 0.9), Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.01, 0.02, 0.0)] {
            let (through, straight) = (lab_of_opponent(opponent_of_linear(colour)), lab_of_linear(colour));
            assert!((through - straight).abs().max_element() < 2e-2, "{through} {straight}");
        }
    }
}
